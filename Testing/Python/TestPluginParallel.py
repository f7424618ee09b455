# SPDX-License-Identifier: BSD-3-Clause
"""Four processes, each with a piece of the points, make one tree together; all run this script."""
import os
import sys
import traceback

import numpy
from octreetesting import CELL_ARRAYS, COSTS, HISTOGRAM, argument, arrays, write_sphere
from paraview import simple
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_PIXEL, VTK_VOXEL, vtkMultiBlockDataSet,
                                           vtkPartitionedDataSet, vtkPolyData)
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from hashedoctree import vtkHashedOctreeFilter

PROCESSES = 4
# Of these no two runs agree.
TIMES = {"BuildSeconds"}
# What the trees of the processes need together is more than what one tree needs.
MEMORY = {"TreeBytes"}


def end_all(*exception):
    """What fails in one process ends all: the others would wait for it."""
    traceback.print_exception(*exception)
    sys.stderr.flush()
    os._exit(1)


sys.excepthook = end_all
controller = vtkMultiProcessController.GetGlobalController()
rank = controller.GetLocalProcessId()
assert controller.GetNumberOfProcesses() == PROCESSES


def make_points(coordinates):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(coordinates, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def run(data, pieces, errors=None, **properties):
    """The filter's outputs for a data set in this process, as one of so many pieces."""
    octree = vtkHashedOctreeFilter()
    octree.SetInputData(data)
    for name, value in properties.items():
        getattr(octree, "Set" + name)(value)
    assert octree.GetController() == controller
    texts = [] if errors is None else errors

    def note(_caller, _event, text):
        texts.append(text)
    note.CallDataType = "string0"
    octree.AddObserver("ErrorEvent", note)
    octree.UpdatePiece(rank if pieces > 1 else 0, pieces, 0)
    assert errors is not None or not texts, texts
    return [octree.GetOutputDataObject(port) for port in range(3)]


def rows(output):
    """What the cells are, a row each, with their lower and upper corners."""
    cells = arrays(output.GetCellData())
    bounds = numpy.array([output.GetCell(i).GetBounds() for i in range(output.GetNumberOfCells())])
    columns = [cells[name].astype(numpy.uint64) for name in CELL_ARRAYS]
    return numpy.column_stack([*columns, bounds.reshape(-1, 6).view(numpy.uint64)]) \
        if len(bounds) else numpy.zeros((0, len(CELL_ARRAYS) + 6), numpy.uint64)


def gather(name, values):
    """The values of all processes, one after the other, in the first process."""
    paths = [os.path.join(argument("-T"), f"{name}{i}.npy") for i in range(PROCESSES)]
    numpy.save(paths[rank], values)
    controller.Barrier()
    parts = [numpy.load(path) for path in paths] if rank == 0 else []
    controller.Barrier()
    return parts


def expect_same_field_data(output, expected):
    here, there = arrays(output.GetFieldData()), arrays(expected.GetFieldData())
    assert here.keys() == there.keys()
    for name in here.keys() - TIMES - MEMORY:
        assert here[name] == there[name], (name, here[name], there[name])


def expect_same_tree(pieces, whole):
    """The nodes of all processes are those of one tree of all points, and so is what is told of
    it; the tables are in the first process."""
    parts = gather("rows", rows(pieces[0]))
    expect_same_field_data(pieces[0], whole[0])
    if rank > 0:
        assert all(table.GetNumberOfRows() == 0 for table in pieces[1:])
        return
    expected = rows(whole[0])
    here = numpy.concatenate(parts)
    by_key = CELL_ARRAYS.index("MortonKey")
    assert len(set(here[:, by_key])) == len(here) == len(expected), (len(here), len(expected))
    order = numpy.argsort(here[:, by_key])
    assert numpy.array_equal(here[order], expected[numpy.argsort(expected[:, by_key])])
    for names, table, expected_table in zip([HISTOGRAM, COSTS], pieces[1:], whole[1:]):
        for name in names:
            column = vtk_to_numpy(table.GetColumnByName(name))
            assert numpy.array_equal(column, vtk_to_numpy(expected_table.GetColumnByName(name)))
        expect_same_field_data(table, expected_table)


def expect_shares(pieces, number_of_points):
    """Each process has about its share of the points."""
    points = arrays(pieces[0].GetCellData())["PointCount"].sum()
    assert 0.8 * number_of_points / PROCESSES < points < 1.25 * number_of_points / PROCESSES


random = numpy.random.default_rng(5)
cube = random.random((4000, 3))
clusters = numpy.concatenate([centre + 1e-3 * random.standard_normal((500, 3))
                              for centre in random.random((8, 3))])
flat = cube * [1.0, 1.0, 0.0] + [0.0, 0.0, 3.0]
duplicates = numpy.repeat(cube[:5], 300, axis=0)
holes = cube.copy()
holes[::7, 1] = numpy.nan

for points, properties in [
        (cube, {}), (cube, {"IncludeEmptyLeaves": True, "IncludeInternalNodes": True}),
        (cube.astype(numpy.float32), {"MaxPointsPerLeaf": 20, "FrequencyModel": 1}),
        (cube, {"MaxDepth": 3, "StartDepthModel": 1, "IncludeInternalNodes": True}),
        (cube, {"MaxDepth": 0}), (cube, {"MaxPointsPerLeaf": 5000}),
        (cube, {"UseCustomBounds": True, "CustomBounds": (0.2, 0.7, 0.1, 0.9, -1.0, 0.6)}),
        (clusters, {"FrequencyModel": 2}), (flat, {"IncludeInternalNodes": True}),
        (cube, {"Dimension": 2, "Plane": 2}), (duplicates, {"IncludeInternalNodes": True}),
        (cube[:3], {"IncludeEmptyLeaves": True}), (holes, {})]:
    whole = run(make_points(points), 1, **properties)
    # As a scan is read: one part of space after the other, or anything anywhere.
    for order in [numpy.argsort(points[:, 0]), numpy.arange(len(points))]:
        piece = run(make_points(numpy.array_split(points[order], PROCESSES)[rank]), PROCESSES,
                    **properties)
        expect_same_tree(piece, whole)
        if points is cube and not properties:
            expect_shares(piece, len(cube))

# Nothing in some processes, and another type in each.
types = [numpy.float32, numpy.float64, numpy.float64, numpy.float32]
halves = cube.astype(numpy.float32)
ends = {0: halves[:1000], 3: halves[1000:]}
piece = run(make_points(ends.get(rank, halves[:0]).astype(types[rank])), PROCESSES)
expect_same_tree(piece, run(make_points(halves), 1))

# Blocks, of which processes have some only; the trees are there where the blocks are.
def make_blocks(kind, *blocks):
    data = kind()
    for i, block in enumerate(blocks):
        if isinstance(data, vtkMultiBlockDataSet):
            data.SetBlock(i, block)
        else:
            data.SetPartition(i, block)
    return data


def block_of(output, i):
    return output.GetBlock(i) if isinstance(output, vtkMultiBlockDataSet) else \
        output.GetPartition(i)


for kind in [vtkMultiBlockDataSet, vtkPartitionedDataSet]:
    mine = [make_points(cube[rank::2]) if rank < 2 else None,
            make_points(clusters[rank - 1::3]) if rank > 0 else None]
    piece = run(make_blocks(kind, *mine), PROCESSES)
    whole = run(make_blocks(kind, make_points(cube), make_points(clusters)), 1)
    for i in range(2):
        expect_same_tree([block_of(output, i) for output in piece],
                         [block_of(output, i) for output in whole])

# Other blocks in each process are other data sets: each has its own trees.
mine = make_blocks(vtkPartitionedDataSet, *[make_points(cube[i::PROCESSES])
                                            for i in range(rank + 1)])
piece = run(mine, PROCESSES)
whole = run(mine, 1)
assert piece[0].GetNumberOfPartitions() == rank + 1
assert numpy.array_equal(rows(piece[0].GetPartition(rank)), rows(whole[0].GetPartition(rank)))
assert piece[1].GetBlock(rank).GetNumberOfRows() == whole[1].GetBlock(rank).GetNumberOfRows() > 1

# So it is without a controller.
octree = vtkHashedOctreeFilter()
octree.SetController(None)
mine = make_points(cube[rank::PROCESSES])
octree.SetInputData(mine)
octree.UpdatePiece(rank, PROCESSES, 0)
assert numpy.array_equal(rows(octree.GetOutputDataObject(0)), rows(run(mine, 1)[0]))

# An error of all processes, and one process that is aborted.
errors = []
piece = run(make_points(cube[:0]), PROCESSES, errors)
assert len(errors) == 1 and "The input has no points" in errors[0], errors
assert piece[0].GetNumberOfCells() == piece[1].GetNumberOfRows() == 0
octree = vtkHashedOctreeFilter()
octree.SetInputData(mine)
if rank == 2:
    octree.AddObserver("ProgressEvent", lambda *_: octree.SetAbortExecute(1))
octree.UpdatePiece(rank, PROCESSES, 0)
assert octree.GetOutput().GetNumberOfCells() == 0


def run_proxy(source, cell_type, **properties):
    """Numbers of cells, which all have this type, and of rows of both tables, in this process."""
    octree = simple.HashedOctree(Input=source, **properties)
    octree.UpdatePipeline()
    cells, histogram, costs = (octree.GetClientSideObject().GetOutputDataObject(port)
                               for port in range(3))
    assert {cells.GetCellType(i) for i in range(cells.GetNumberOfCells())} <= {cell_type}
    return cells.GetNumberOfCells(), histogram.GetNumberOfRows(), costs.GetNumberOfRows()


def leaves_in_grid(source, **properties):
    """Number of leaves that this process shows in its hyper tree grid."""
    octree = simple.HashedOctree(Input=source, OutputType="HyperTreeGrid", **properties)
    leaves = simple.HyperTreeGridToUnstructuredGrid(Input=octree)
    leaves.UpdatePipeline()
    return leaves.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()


# In ParaView: a source that every process makes its part of, and a file that the first one reads.
if rank == 0:
    _, number_of_points = write_sphere()
controller.Barrier()
path = os.path.join(argument("-T"), "sphere.vtp")
reader = simple.XMLPolyDataReader(FileName=[path])
sphere = simple.Sphere(ThetaResolution=64, PhiResolution=64)
for source in [reader, sphere]:
    for cell_type, properties in [(VTK_VOXEL, {}), (VTK_PIXEL, {"Dimension": "Two", "Plane": "XY"})]:
        cells, histogram_rows, cost_rows = run_proxy(source, cell_type, **properties)
        assert (histogram_rows > 1) == (cost_rows > 1) == (rank == 0)
        parts = numpy.concatenate([*gather("cells", numpy.array([cells])), [0]])
        if rank == 0 and source is reader: # From above both halves of the sphere are one.
            expected = number_of_points if cell_type == VTK_VOXEL else number_of_points // 2
            assert parts.sum() == expected, (parts, number_of_points)
    for properties in [{}, {"IncludeEmptyLeaves": True}]:
        assert leaves_in_grid(source, **properties) == \
            run_proxy(source, VTK_VOXEL, **properties)[0] > 0
