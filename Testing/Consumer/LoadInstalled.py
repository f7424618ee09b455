# SPDX-License-Identifier: BSD-3-Clause
"""Loads an installed plugin and Python package: LoadInstalled.py PLUGIN PREFIX"""
import sys

import hashedoctree
from paraview import simple

plugin, prefix = sys.argv[1:3]
assert hashedoctree.__file__.startswith(prefix), hashedoctree.__file__
assert hashedoctree.vtkHashedOctreeFilter().GetNumberOfOutputPorts() == 3

simple.LoadPlugin(plugin, ns=globals())
octree = HashedOctree(Input=simple.Sphere())
octree.UpdatePipeline()
assert octree.CellData["Depth"].GetRange()[1] > 0
