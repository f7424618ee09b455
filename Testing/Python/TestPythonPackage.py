# SPDX-License-Identifier: BSD-3-Clause
"""The Python package, without ParaView's shells and without the plugin."""
import sys

from hashedoctree import (vtkHashedOctreeFilter, vtkHashedOctreeLocateFilter,
                          vtkHashedOctreeNeighborsFilter)
from vtkmodules.vtkFiltersSources import vtkSphereSource

assert "paraview" not in sys.modules
sphere = vtkSphereSource()
sphere.SetThetaResolution(32)
sphere.SetPhiResolution(32)
octree = vtkHashedOctreeFilter()
octree.SetInputConnection(sphere.GetOutputPort())
octree.SetStartDepthModel(vtkHashedOctreeFilter.Mean)
octree.SetFrequencyModel(vtkHashedOctreeFilter.Points)
octree.SetMaxDepth(4)
octree.Update()

cells, histogram, costs = (octree.GetOutputDataObject(port) for port in range(3))
assert cells.GetClassName() == "vtkUnstructuredGrid", cells
assert cells.GetCellData().GetScalars().GetName() == "Depth"
counts = cells.GetCellData().GetArray("PointCount")
points = sphere.GetOutput().GetNumberOfPoints()
assert sum(counts.GetValue(i) for i in range(counts.GetNumberOfValues())) == points
assert histogram.GetNumberOfRows() == costs.GetNumberOfRows() == 5
assert histogram.GetColumnByName("Points").GetValue(0) == 0
octree.SetOutputType(vtkHashedOctreeFilter.Outlines)
octree.Update()
assert octree.GetOutputDataObject(0).GetClassName() == "vtkPolyData"

locate = vtkHashedOctreeLocateFilter()
locate.SetInputConnection(sphere.GetOutputPort())
locate.SetQueryPointsConnection(sphere.GetOutputPort())
locate.SetFrequencyModel(vtkHashedOctreeLocateFilter.Points)
locate.Update()
ids = locate.GetOutputDataObject(0).GetPointData().GetArray("LeafId")
assert sorted(ids.GetValue(i) for i in range(points)) == list(range(points))
table = locate.GetOutputDataObject(1)
assert table.GetNumberOfRows() > 0
for row in range(table.GetNumberOfRows()):
    predicted, measured = (table.GetValueByName(row, name) for name in
                           ("PredictedMean", "MeasuredMean"))
    assert predicted == measured, (row, predicted, measured)

neighbors = vtkHashedOctreeNeighborsFilter()
neighbors.SetInputConnection(sphere.GetOutputPort())
neighbors.SetMaxDepth(4)
neighbors.IncludeEmptyLeavesOff()
neighbors.SetCenter(sphere.GetOutput().GetPoint(0))
neighbors.SetSearchMode(vtkHashedOctreeNeighborsFilter.InRadius)
neighbors.SetRadius(float("inf"))
neighbors.Update()
# All leaves, the query leaf first.
assert neighbors.GetOutputDataObject(0).GetNumberOfCells() == cells.GetNumberOfCells()
