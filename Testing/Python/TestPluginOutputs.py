# SPDX-License-Identifier: BSD-3-Clause
"""The arrays of the three outputs, in ParaView alone and from a server."""
import numpy
from octreetesting import CELL_ARRAYS, COSTS, HISTOGRAM, arrays, fetch, write_sphere
from paraview import servermanager, simple

path, number_of_points = write_sphere()
sphere = simple.XMLPolyDataReader(FileName=[path])
octree = simple.HashedOctree(Input=sphere, IncludeEmptyLeaves=1)
octree.UpdatePipeline()

cells = fetch(octree, 0)
assert cells.GetClassName() == "vtkUnstructuredGrid", cells
assert cells.GetCellData().GetScalars().GetName() == "Depth"
of_cells = arrays(cells.GetCellData())
in_first_process = arrays(servermanager.Fetch(octree, 0).GetCellData())
assert list(in_first_process) == CELL_ARRAYS, list(in_first_process)
assert set(of_cells) == set(CELL_ARRAYS), list(of_cells)
figures = {name: values[0] for name, values in arrays(cells.GetFieldData()).items()}
assert (of_cells["HitCost"] == 1 + abs(of_cells["Depth"] - figures["StartDepth"])).all()
assert (of_cells["RootCost"] == 1 + of_cells["Depth"]).all()
assert of_cells["PointCount"].sum() == number_of_points == figures["NumberOfPoints"]
assert cells.GetNumberOfCells() == figures["NumberOfLeaves"] > number_of_points
assert of_cells["HitCost"].mean() == figures["MeanHitCost"] < figures["MeanRootCost"]

histogram = arrays(fetch(octree, 1).GetRowData())
assert list(histogram) == HISTOGRAM, list(histogram)
assert (histogram["Depth"] == numpy.arange(figures["DeepestDepth"] + 1)).all()
assert (histogram["Leaves"] == numpy.bincount(of_cells["Depth"])).all()
empty = of_cells["Depth"][of_cells["PointCount"] == 0]
assert histogram["EmptyLeaves"].sum() == len(empty) == figures["NumberOfEmptyLeaves"]
assert histogram["Points"].sum() == number_of_points
assert histogram["GridWeight"].sum() == 8.0 ** figures["DeepestDepth"]

costs = arrays(fetch(octree, 2).GetRowData())
assert list(costs) == COSTS, list(costs)
assert (costs["CostLeaves"] == costs["MeasuredLeaves"]).all()
assert (costs["CostPoints"] == costs["MeasuredPoints"]).all()
assert costs["CostLeaves"].argmin() == figures["StartDepth"]
assert costs["CostLeaves"][0] == figures["MeanRootCost"]
marked = costs["StartDepth"] == figures["StartDepth"]
assert (costs["MeanHitCost"][marked] == figures["MeanHitCost"]).all()
assert numpy.isnan(costs["MeanHitCost"][~marked]).all()

# Wire boxes have the same arrays.
octree.OutputType = "Outlines"
octree.UpdatePipeline()
outlines = fetch(octree, 0)
assert outlines.GetClassName() == "vtkPolyData", outlines
assert outlines.GetNumberOfLines() == cells.GetNumberOfCells()
for name, values in arrays(outlines.GetCellData()).items():
    assert (values == of_cells[name]).all(), name

# So has the tree as ParaView's own kind of tree, which holds the nodes above the leaves, too. (Such
# data stay on the server: ParaView cannot fetch them.)
octree.OutputType = "HyperTreeGrid"
octree.UpdatePipeline()
grid = octree.GetDataInformation(0)
assert grid.GetDataSetTypeAsString() == "vtkHyperTreeGrid", grid.GetDataSetTypeAsString()
# Of several processes each has the nodes around its part, masked or above the leaves.
is_parted = servermanager.ActiveConnection.GetNumberOfDataPartitions() > 1
vertices = grid.GetNumberOfCells() - figures["NumberOfNodes"]
assert vertices > 0 if is_parted else vertices == 0
leaves = simple.HyperTreeGridToUnstructuredGrid(Input=octree)
leaves.UpdatePipeline()
of_leaves = arrays(fetch(leaves, 0).GetCellData())
for name, values in of_cells.items():
    assert (numpy.sort(of_leaves[name]) == numpy.sort(values)).all(), name
octree.OutputType = "Voxels"

# Composite input: a tree for each block, at each port.
group = simple.GroupDatasets(Input=[sphere, simple.XMLPolyDataReader(FileName=[path])])
blocks = simple.HashedOctree(Input=group)
blocks.UpdatePipeline()
for port, expected in enumerate(("vtkUnstructuredGrid", "vtkTable", "vtkTable")):
    leaves = fetch(blocks, port).NewTreeIterator()
    classes = []
    while not leaves.IsDoneWithTraversal():
        classes.append(leaves.GetCurrentDataObject().GetClassName())
        leaves.GoToNextItem()
    assert classes == [expected, expected], classes

# Downstream filters take the cells.
deep = simple.Threshold(Input=octree, Scalars=["CELLS", "Depth"], LowerThreshold=7,
                        UpperThreshold=21)
deep.UpdatePipeline()
assert deep.GetDataInformation().GetNumberOfCells() == histogram["Leaves"][7:].sum() > 0
of_points = simple.CellDatatoPointData(Input=octree)
of_points.UpdatePipeline()
assert set(CELL_ARRAYS) <= set(of_points.PointData.keys()), of_points.PointData.keys()
