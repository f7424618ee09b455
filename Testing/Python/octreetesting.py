# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the plugin share. Importing it connects to the server, if there is one, and
loads the plugin."""
import os
import sys

from paraview import servermanager, simple
from paraview.modules.vtkRemotingCore import vtkRemotingCoreConfiguration
from vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

CELL_ARRAYS = ["Depth", "HitCost", "RootCost", "PointCount", "MortonKey"]
HISTOGRAM = ["Depth", "Leaves", "EmptyLeaves", "Points", "GridWeight"]
COSTS = ["StartDepth", "CostLeaves", "CostPoints", "CostGrid", "MeasuredLeaves", "MeasuredPoints",
         "ContinuousLeaves"]


def argument(option):
    """Value of -T (folder for output), -V (baseline image) or -D (Data)."""
    return sys.argv[sys.argv.index(option) + 1]


def write_sphere():
    """A file with points, in one piece: of several processes the first gets all of them. Returns
    its path and the number of points."""
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(64)
    sphere.SetPhiResolution(64)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(os.path.join(argument("-T"), "sphere.vtp"))
    writer.SetInputConnection(sphere.GetOutputPort())
    # Not appended: ParaView 5.11 cannot read that with the expat of Debian's security updates.
    writer.SetDataModeToBinary()
    assert writer.Write()
    return writer.GetFileName(), sphere.GetOutput().GetNumberOfPoints()


def _connect():
    # smTestDriver gives the address as --url, by which pvpython does not connect.
    url = vtkRemotingCoreConfiguration.GetInstance().GetServerURL()
    if url:
        host, port = url.split("//")[1].split(":")
        simple.Connect(host, int(port))


def _load_plugin():
    plugin = os.environ["HASHEDOCTREE_PLUGIN"]
    simple.LoadPlugin(plugin, remote=False)
    if servermanager.ActiveConnection.IsRemote():
        simple.LoadPlugin(plugin, remote=True)


def arrays(attributes):
    """The arrays of a vtkDataSetAttributes or vtkFieldData by name, as numpy arrays."""
    return {attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i))
            for i in range(attributes.GetNumberOfArrays())}


def fetch(octree, port):
    """Output of a port, brought to the client."""
    return servermanager.Fetch(octree, idx=port)


_connect()
_load_plugin()
