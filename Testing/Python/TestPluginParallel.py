# SPDX-License-Identifier: BSD-3-Clause
"""Four processes, each with a piece of the points, make one tree together; all run this script."""
import os
import sys
import traceback

import numpy
from octreetesting import CELL_ARRAYS, COSTS, HISTOGRAM, argument, arrays, write_sphere
from paraview import simple
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformationVector, vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_PIXEL, VTK_VOXEL, vtkDataObject,
                                           vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet,
                                           vtkPartitionedDataSet, vtkPolyData)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from hashedoctree import (vtkHashedOctreeFilter, vtkHashedOctreeLocateFilter,
                          vtkHashedOctreeNeighborsFilter)

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


def mark(data, first):
    """Marks the points from the first on as another piece's."""
    ghosts = numpy.zeros(data.GetNumberOfPoints(), numpy.uint8)
    ghosts[first:] = vtkDataSetAttributes.DUPLICATEPOINT
    ghosts = numpy_to_vtk(ghosts, deep=True)
    ghosts.SetName(vtkDataSetAttributes.GhostArrayName())
    data.GetPointData().AddArray(ghosts)
    return data


def make_filter(data, filter_=vtkHashedOctreeFilter, queries=None, **properties):
    """A filter of a data set in this process."""
    octree = filter_()
    octree.SetInputData(data)
    if queries is not None:
        octree.SetQueryPointsData(queries)
    for name, value in properties.items():
        getattr(octree, "Set" + name)(value)
    assert octree.GetController() == controller
    return octree


def run(data, pieces, errors=None, **properties):
    """The outputs of that filter, as one of so many pieces. Where errors are expected, notes
    their texts and those of warnings."""
    octree = make_filter(data, **properties)
    texts = [] if errors is None else errors

    def note(_caller, _event, text):
        texts.append(text)
    note.CallDataType = "string0"
    octree.AddObserver("ErrorEvent", note)
    if errors is not None:
        octree.AddObserver("WarningEvent", note)
    octree.UpdatePiece(rank if pieces > 1 else 0, pieces, 0)
    assert errors is not None or not texts, texts
    return [octree.GetOutputDataObject(port) for port in range(octree.GetNumberOfOutputPorts())]


def rows(output, names=tuple(CELL_ARRAYS)):
    """What the cells are, a row each, with their lower and upper corners; key first."""
    cells = arrays(output.GetCellData())
    bounds = numpy.array([output.GetCell(i).GetBounds() for i in range(output.GetNumberOfCells())])
    columns = [cells[name].astype(numpy.uint64) for name in ["MortonKey", *names]]
    return numpy.column_stack([*columns, bounds.reshape(-1, 6).view(numpy.uint64)]) \
        if len(bounds) else numpy.zeros((0, 1 + len(names) + 6), numpy.uint64)


def sort_by_key(rows_):
    """Rows of which each has another key."""
    assert len(numpy.unique(rows_[:, 0])) == len(rows_)
    return rows_[numpy.argsort(rows_[:, 0])]


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
    it; the tables are in the first process. Times and memory, which differ from run to run, are the
    same in all processes."""
    parts = gather("rows", rows(pieces[0]))
    told = arrays(pieces[0].GetFieldData())
    told = gather("told", numpy.concatenate([told[name] for name in sorted(TIMES | MEMORY)]))
    assert all(numpy.array_equal(of_process, told[0]) for of_process in told), told
    for piece, expected in zip(pieces, whole):
        expect_same_field_data(piece, expected)
    if rank > 0:
        assert all(table.GetNumberOfRows() == 0 for table in pieces[1:])
        return
    assert numpy.array_equal(sort_by_key(numpy.concatenate(parts)), sort_by_key(rows(whole[0])))
    for names, table, expected_table in zip([HISTOGRAM, COSTS], pieces[1:], whole[1:]):
        for name in names:
            column = vtk_to_numpy(table.GetColumnByName(name))
            expected_column = vtk_to_numpy(expected_table.GetColumnByName(name))
            assert numpy.array_equal(column, expected_column, equal_nan=True), name


def expect_shares(pieces, number_of_points):
    """Each process has about its share of the points."""
    points = arrays(pieces[0].GetCellData())["PointCount"].sum()
    assert 0.8 * number_of_points / PROCESSES < points < 1.25 * number_of_points / PROCESSES


random = numpy.random.default_rng(5)
cube = random.random((4000, 3))
clusters = numpy.concatenate([center + 1e-3 * random.standard_normal((500, 3))
                              for center in random.random((8, 3))])
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

# Shares are of all points, also where one process has most of them, close to each other.
crowd = 0.1 * random.random((40000, 3))
mine = crowd if rank == 0 else cube[rank::PROCESSES]
expect_shares(run(make_points(mine), PROCESSES), len(crowd) + len(cube) * 3 // PROCESSES)

# The neighbours of leaves, which lie in any part, are those in the one tree.
NEIGHBOR_ARRAYS = [*CELL_ARRAYS, "Role", "Case"]


def expect_same_neighbors(piece, whole):
    """The cells of all processes are those of one tree, and so is what is told of them."""
    parts = gather("rows", rows(piece, NEIGHBOR_ARRAYS))
    expect_same_field_data(piece, whole)
    if rank == 0:
        assert numpy.array_equal(sort_by_key(numpy.concatenate(parts)),
                                 sort_by_key(rows(whole, NEIGHBOR_ARRAYS)))


for points, properties in [
        (clusters, {"Center": clusters[3]}), (cube, {"Center": (0.5, 0.5, 0.5)}),
        (cube, {"Center": (0.9, 0.2, 0.6), "IncludeEmptyLeaves": True, "SearchMode": 1,
                "Radius": 0.3}),
        (clusters, {"Center": clusters[700], "SearchMode": 1, "Radius": 0.5}),
        (cube, {"UseLeafKey": True, "LeafKey": 0o10000 + 0o4321}), (flat, {"Center": flat[7]}),
        (cube, {"UseLeafKey": True, "LeafKey": 1, "MaxDepth": 0})]:
    properties["filter_"] = vtkHashedOctreeNeighborsFilter
    whole, = run(make_points(points), 1, **properties)
    for order in [numpy.argsort(points[:, 0]), numpy.arange(len(points))]:
        piece, = run(make_points(numpy.array_split(points[order], PROCESSES)[rank]), PROCESSES,
                     **properties)
        expect_same_neighbors(piece, whole)
# A tree that is kept of a process's own points is not taken for one of all, nor the other way round.
mine = make_points(cube[rank::PROCESSES])
neighbors = vtkHashedOctreeNeighborsFilter()
neighbors.SetInputData(mine)
for i, pieces in enumerate([1, PROCESSES, PROCESSES, 1, 1, PROCESSES]):
    center = (0.3 + 0.1 * i, 0.5, 0.5)
    neighbors.SetCenter(center)
    neighbors.UpdatePiece(rank if pieces > 1 else 0, pieces, 0)
    whole, = run(mine, pieces, filter_=vtkHashedOctreeNeighborsFilter, Center=center)
    piece = neighbors.GetOutputDataObject(0)
    expect_same_field_data(piece, whole)
    assert numpy.array_equal(rows(piece, NEIGHBOR_ARRAYS), rows(whole, NEIGHBOR_ARRAYS)), i

errors = []
run(make_points(cube[rank::PROCESSES]), PROCESSES, errors,
    filter_=vtkHashedOctreeNeighborsFilter, UseLeafKey=True, LeafKey=2)
assert len(errors) == 1 and "names no leaf" in errors[0], errors


def expect_same_search(pieces, whole, mine):
    """What queries find, of which this process has `mine`, is what they find in one tree; and so
    are the costs."""
    here, there = arrays(pieces[0].GetPointData()), arrays(whole[0].GetPointData())
    here.pop(vtkDataSetAttributes.GhostArrayName(), None)
    assert here.keys() == there.keys()
    for name in here:
        assert numpy.array_equal(here[name], there[name][mine]), name
    expect_same_field_data(pieces[0], whole[0])
    if rank == 0:
        expect_same_field_data(pieces[1], whole[1])
        for i in range(whole[1].GetNumberOfColumns()):
            column, expected = pieces[1].GetColumn(i), whole[1].GetColumn(i)
            assert [column.GetVariantValue(j).ToString() for j in range(column.GetNumberOfValues())] == \
                [expected.GetVariantValue(j).ToString() for j in range(expected.GetNumberOfValues())]
    else:
        assert pieces[1].GetNumberOfRows() == 0


# Queries are searched for where the part of the tree is that they are in.
queries = numpy.concatenate([clusters[::5], random.random((600, 3)) * 1.2 - 0.1])
queries[17] = numpy.inf
locating = {"filter_": vtkHashedOctreeLocateFilter}
for points, properties in [
        (clusters, {}), (clusters, {"IncludeEmptyLeaves": True, "MaxPointsPerLeaf": 4}),
        (cube, {"StartDepthModel": 3, "FixedStartDepth": 9, "FrequencyModel": 1}),
        (flat, {"FrequencyModel": 2}), (cube[:2], {}), (cube, {"MaxDepth": 2}),
        # The longest way from the root.
        (numpy.repeat(clusters[:100], 2, axis=0), {"Dimension": 2, "Plane": 1, "MaxDepth": 31})]:
    whole = run(make_points(points), 1, queries=make_points(queries), **locating, **properties)
    for mine in [numpy.array_split(numpy.arange(len(queries)), PROCESSES)[rank],
                 numpy.arange(len(queries)) if rank == 1 else numpy.arange(0)]:
        piece = run(make_points(points[rank::PROCESSES]), PROCESSES,
                    queries=make_points(queries[mine]), **locating, **properties)
        expect_same_search(piece, whole, mine)

# Queries that another process has, too, are found, and count there.
whole = run(make_points(cube), 1, queries=make_points(queries), **locating)
mine = numpy.array_split(numpy.arange(len(queries)), PROCESSES)[-1 - rank]
others = numpy.concatenate([mine, numpy.arange(50 * rank)])  # One process has none of them.
warnings = []
piece = run(make_points(cube[rank::PROCESSES]), PROCESSES, warnings,
            queries=mark(make_points(queries[others]), len(mine)), **locating)
expect_same_search(piece, whole, others)
assert len(warnings) == (1 if rank == 0 else 0), warnings
assert all(f"1 of {len(queries)} query points" in warning for warning in warnings), warnings

# Nothing in some processes, and another type in each.
types = [numpy.float32, numpy.float64, numpy.float64, numpy.float32]
halves = cube.astype(numpy.float32)
ends = {0: halves[:1000], 3: halves[1000:]}
piece = run(make_points(ends.get(rank, halves[:0]).astype(types[rank])), PROCESSES)
expect_same_tree(piece, run(make_points(halves), 1))

# A point that is marked as one that another process has, too, is not counted twice.
mine = make_points(numpy.concatenate([cube[rank::PROCESSES], cube[:300], cube[0::PROCESSES]]))
mark(mine, len(cube[rank::PROCESSES]))
expect_same_tree(run(mine, PROCESSES), run(make_points(cube), 1))

# So are points that nobody marks, where they are merged.
mine = make_points(numpy.concatenate([cube[rank::PROCESSES], cube[:300], cube[0::PROCESSES]]))
for values in ({}, {"MaxPointsPerLeaf": 5}):
    expect_same_tree(run(mine, PROCESSES, MergePoints=True, **values), run(make_points(cube), 1, **values))

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

    mine = [numpy.arange(rank, len(queries), 2) if rank < 2 else None,
            numpy.arange(0, 50) if rank == 3 else None]
    of_queries = make_blocks(kind, *[None if i is None else make_points(queries[i]) for i in mine])
    all_queries = make_blocks(kind, make_points(queries), make_points(queries[:50]))
    piece = run(make_points(cube[rank::PROCESSES]), PROCESSES, queries=of_queries, **locating)
    whole = run(make_points(cube), 1, queries=all_queries, **locating)
    for i in range(2):
        expected = [whole[0].GetBlock(i) if kind is vtkMultiBlockDataSet else
                    whole[0].GetPartition(i), whole[1].GetBlock(i)]
        located = block_of(piece[0], i)
        assert (located is None) == (mine[i] is None)
        if located is not None:
            expect_same_search([located, piece[1].GetBlock(i)], expected, mine[i])
        elif rank == 0:
            expect_same_field_data(piece[1].GetBlock(i), expected[1])

# Several processes keep no trees: one that took its own would not wait for those without points.
neighbors = make_filter(make_blocks(vtkMultiBlockDataSet,
                                    make_points(cube[rank::2]) if rank < 2 else None),
                        filter_=vtkHashedOctreeNeighborsFilter)
for center in ((0.3, 0.5, 0.5), (0.7, 0.2, 0.6)):
    neighbors.SetCenter(center)
    neighbors.UpdatePiece(rank, PROCESSES, 0)
    whole, = run(make_points(cube), 1, filter_=vtkHashedOctreeNeighborsFilter, Center=center)
    expect_same_neighbors(neighbors.GetOutputDataObject(0).GetBlock(0), whole)

# Other blocks in each process are other data sets: each has its own trees. One may have no block.
def mine_of(blocks):
    """So many partitions."""
    return make_blocks(vtkPartitionedDataSet,
                       *[make_points(cube[i::PROCESSES]) for i in range(blocks)])


for blocks in (rank + 1, rank):
    mine = mine_of(blocks)
    piece, whole = (run(mine, pieces) for pieces in (PROCESSES, 1))
    assert piece[0].GetNumberOfPartitions() == blocks
    for i in range(blocks):
        assert numpy.array_equal(rows(piece[0].GetPartition(i)), rows(whole[0].GetPartition(i)))
        assert piece[1].GetBlock(i).GetNumberOfRows() == whole[1].GetBlock(i).GetNumberOfRows() > 1

# Also where they are as many, at other places.
of_cube = make_points(cube[rank::PROCESSES])
nested = make_blocks(vtkMultiBlockDataSet, make_points(clusters[rank::PROCESSES]))
mine = make_blocks(vtkMultiBlockDataSet, *([of_cube, nested] if rank == 0 else [nested, of_cube]))
piece, whole = (rows(run(mine, pieces)[0].GetBlock(min(rank, 1))) for pieces in (PROCESSES, 1))
assert numpy.array_equal(piece, whole)

# One with nothing to use warns of that, and the others have their trees.
image = vtkImageData()
image.SetDimensions(3, 3, 3)
images = make_blocks(vtkMultiBlockDataSet, *[image] * (rank + 1))
texts = []
piece = run(images if rank == 0 else mine, PROCESSES, texts)
assert len(texts) == (rank == 0) and all("Blocks left out" in text for text in texts), texts
assert (rows(piece[0].GetBlock(1)).size > 0 if rank else piece[0].GetBlock(0) is None)

# Then points, or queries, may be in some processes only.
mine = [make_points(cube[:90])] if rank == 3 else [make_points(cube[:0])] * (rank + 1)
piece = run(make_blocks(vtkPartitionedDataSet, *mine), PROCESSES,
            queries=make_points(queries[:40 if rank < 2 else 0]), **locating)
assert (piece[1].GetNumberOfBlocks() > 0 and piece[1].GetBlock(0) is not None) == (rank == 3)
blocks = [make_points(cube[:30]) if i == rank else None for i in range(PROCESSES)]
piece = run(mine_of(rank + 1), PROCESSES, queries=make_blocks(vtkMultiBlockDataSet, *blocks),
            **locating)
assert [i for i in range(PROCESSES) if piece[1].GetBlock(i) is not None] == [rank]

# Each then tells of its own queries, and nobody of what another one may have.
outside = {"UseCustomBounds": True, "CustomBounds": (2, 3, 2, 3, 2, 3)}
no_leaf = {"filter_": vtkHashedOctreeNeighborsFilter, "UseLeafKey": True, "LeafKey": 2}
for properties, words in ((outside, None), (no_leaf, None),
                          ({"queries": make_points(queries[17 - rank:18]), **locating},
                           f"1 of {rank + 1} query points")):
    texts = []
    run(mine_of(rank + 1), PROCESSES, texts, **properties)
    assert len(texts) == (words is not None) and all(words in text for text in texts), texts

# So it is without a controller.
octree = vtkHashedOctreeFilter()
octree.SetController(None)
mine = make_points(cube[rank::PROCESSES])
octree.SetInputData(mine)
octree.UpdatePiece(rank, PROCESSES, 0)
assert numpy.array_equal(rows(octree.GetOutputDataObject(0)), rows(run(mine, 1)[0]))

# And so with other pieces than the processes' own.
for number, pieces in [(rank, 2 * PROCESSES), ((rank + 1) % PROCESSES, PROCESSES)]:
    octree = vtkHashedOctreeFilter()
    octree.SetInputData(mine)
    octree.UpdatePiece(number, pieces, 0)
    assert numpy.array_equal(rows(octree.GetOutputDataObject(0)), rows(run(mine, 1)[0]))

# A hyper tree grid has the points of all in the nodes above several parts.
grid = run(mine, PROCESSES, OutputType=vtkHashedOctreeFilter.HyperTreeGrid)[0]
assert arrays(grid.GetCellData())["PointCount"][0] == len(cube)

# Nothing in all processes: no points, or none that are their own.
errors = []
for nothing in (make_points(cube[:0]), mark(make_points(cube), 0)):
    piece = run(nothing, PROCESSES, errors)
    assert errors == [], errors
    assert piece[0].GetNumberOfCells() == piece[1].GetNumberOfRows() == 0
    assert piece[0].GetFieldData().GetNumberOfArrays() == 0

# Warnings are said once, of the points of all.
empty = {"filter_": vtkHashedOctreeNeighborsFilter, "Center": (0.5, 0.5, 0.5),
         "IncludeEmptyLeaves": False}
for points, properties, words in ((holes, {}, f"{len(holes[::7])} of {len(holes)} points"),
                                  (cube, outside, "lies in CustomBounds"),
                                  (clusters, empty, "Center lies in an empty cell")):
    warnings = []
    run(make_points(points[rank::PROCESSES]), PROCESSES, warnings, **properties)
    assert len(warnings) == (1 if rank == 0 else 0), warnings
    assert all(words in warning for warning in warnings), warnings
# Also where only another process than the first meets what is warned of.
warnings = []
run(run(make_points(cube), 1)[0] if rank == 2 else make_points(cube), PROCESSES, warnings)
assert len(warnings) == (1 if rank == 0 else 0), warnings
assert all("corners" in warning for warning in warnings), warnings
# Or where two do, of the same block.
warnings = []
run(make_blocks(vtkMultiBlockDataSet, make_points(cube), image if rank > 1 else None), PROCESSES,
    warnings)
assert len(warnings) == (1 if rank == 0 else 0), warnings
assert all("images: 1." in warning for warning in warnings), warnings


def expect_abort(octree, port=0, progress=0.0):
    """Aborting one process, beyond this progress, ends the update of all, with an error in the
    others; the next update runs in all. Both updates are requested of output `port`."""
    requests = vtkInformationVector()
    requests.SetNumberOfInformationObjects(octree.GetNumberOfOutputPorts())
    request = requests.GetInformationObject(port)
    request.Set(vtkStreamingDemandDrivenPipeline.UPDATE_PIECE_NUMBER(), rank)
    request.Set(vtkStreamingDemandDrivenPipeline.UPDATE_NUMBER_OF_PIECES(), PROCESSES)
    request.Set(vtkStreamingDemandDrivenPipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
    errors = []
    octree.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    observer = octree.AddObserver("ProgressEvent", lambda *_: octree.SetAbortExecute(
        rank == 2 and octree.GetProgress() > progress))
    octree.GetExecutive().Update(port, requests)
    output = octree.GetOutputDataObject(0)
    assert output.GetNumberOfElements(vtkDataObject.POINT) == 0, output
    assert errors == ([] if rank == 2 else ["error"]), errors
    octree.RemoveObserver(observer)
    octree.SetAbortExecute(0)
    octree.GetExecutive().Update(port, requests)
    assert octree.GetOutputDataObject(0).GetNumberOfElements(vtkDataObject.POINT) > 0
    assert errors == ([] if rank == 2 else ["error"]), errors


# And one process that is aborted: the others wait for its points, for its queries or, where each
# has other blocks, for its end.
mine = make_points(cube[rank::PROCESSES])
for port in (0, 2):
    octree = make_filter(mine)
    expect_abort(octree, port)
    expect_same_tree([octree.GetOutputDataObject(i) for i in range(3)], run(make_points(cube), 1))
expect_abort(make_filter(mine, queries=mine, **locating), progress=0.3)
expect_abort(make_filter(mine_of(rank + 1)))

# Blocks in some processes and none in others.
for have_blocks in (rank == 0, rank > 0):
    blocks = make_blocks(vtkMultiBlockDataSet, mine) if have_blocks else mine
    for arguments in ({"data": blocks}, {"data": mine, "queries": blocks, **locating}):
        errors = []
        run(pieces=PROCESSES, errors=errors, **arguments)
        assert len(errors) == 1 and "give all of them blocks" in errors[0], errors


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
