# SPDX-License-Identifier: BSD-3-Clause
"""Batches of searches with NumPy arrays, against comparing with every point."""
from decimal import Decimal
from fractions import Fraction

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkIdList, vtkObject
from vtkmodules.vtkCommonDataModel import vtkPolyData
from hashedoctree import vtkHashedOctreePointLocator
from hashedoctree.arrays import (
    find_closest_n_points, find_closest_points, find_points_within_radius, make_points)

random = numpy.random.default_rng(201)


def expect_error(kind, function, *arguments, words=""):
    try:
        function(*arguments)
    except kind as error:
        assert words in str(error), error
        return
    raise AssertionError(f"no {kind.__name__}")


def boxes_of_leaves(locator):
    """The lower and the upper corner of each leaf that holds points, and its depth."""
    leaves = vtkPolyData()
    locator.GenerateRepresentation(-1, leaves)
    bounds = numpy.array([leaves.GetCell(i).GetBounds() for i in range(leaves.GetNumberOfCells())])
    return bounds[:, ::2], bounds[:, 1::2], vtk_to_numpy(leaves.GetCellData().GetArray("Depth"))


def expect_single_queries_to_find(locator, x, order, within, points, leaves):
    """The queries for one position, in the forms with x and with x, y and z."""
    ids = vtkIdList()
    for position in ((x,), tuple(x)):
        assert locator.FindClosestPoint(*position) == order[0]
        locator.FindClosestNPoints(9, *position, ids)
        assert ids_of(ids) == order[:9].tolist()
        locator.FindPointsWithinRadius(0.1, *position, ids)
        assert sorted(ids_of(ids)) == sorted(within)
    dist2 = reference(-1.0)
    assert locator.FindClosestPointWithinRadius(0.1, x, dist2) == (order[0] if len(within) else -1)
    assert (dist2.get() >= 0.0) == (len(within) > 0)
    box = numpy.column_stack((x - 0.1, x + 0.1)).ravel()
    locator.FindPointsWithinBox(box, ids)
    in_box = ((points >= box[::2]) & (points <= box[1::2])).all(axis=1)
    assert sorted(ids_of(ids)) == numpy.flatnonzero(in_box).tolist()
    lower, upper, depths = leaves
    corner = points.min(axis=0)
    inside = numpy.clip(x, corner, corner + numpy.ptp(points, axis=0).max())
    around = numpy.flatnonzero(((lower <= inside) & (inside <= upper)).all(axis=1)).tolist()
    assert [locator.GetLeafId(x)] == (around or [-1]), around
    depth = locator.GetDepth(x)
    assert depth == depths[around[0]] if around else 0 < depth <= locator.GetLevel()
    assert locator.GetHitCost(x) == 1 + abs(depth - locator.GetStartDepth())
    assert locator.GetClosestNPointsCost(1, x) == locator.GetClosestPointCost(x) >= 1
    assert locator.GetPointsWithinBoxCost(box) >= 1


def ids_of(ids):
    return [ids.GetId(i) for i in range(ids.GetNumberOfIds())]


for dtype in (numpy.float32, numpy.float64):
    points = random.random((3000, 3)).astype(dtype)
    positions = random.random((200, 3)).astype(dtype)
    differences = positions[:, None, :].astype(float) - points[None, :, :].astype(float)
    all_dist2 = (differences * differences).sum(axis=2)
    order = numpy.argsort(all_dist2, axis=1, kind="stable")
    locator = vtkHashedOctreePointLocator()
    locator.SetDataSet(make_points(points))
    leaves = boxes_of_leaves(locator)

    ids, dist2 = find_closest_points(locator, positions)
    assert ids.shape == dist2.shape == (200,) and ids.dtype == numpy.int64, (ids, dist2)
    assert (ids == order[:, 0]).all()
    assert numpy.allclose(dist2, all_dist2.min(axis=1), rtol=1e-14, atol=0)

    ids, dist2 = find_closest_n_points(locator, 9, positions)
    assert ids.shape == dist2.shape == (200, 9)
    assert (ids == order[:, :9]).all()
    assert numpy.allclose(dist2, numpy.take_along_axis(all_dist2, ids, axis=1), rtol=1e-14, atol=0)

    offsets, ids, dist2 = find_points_within_radius(locator, 0.1, positions)
    assert offsets.shape == (201,) and offsets[0] == 0 and offsets[-1] == len(ids) == len(dist2)
    for i in range(200):
        found = ids[offsets[i]:offsets[i + 1]]
        assert (found == order[i, :len(found)]).all()
        assert numpy.allclose(dist2[offsets[i]:offsets[i + 1]], all_dist2[i, found], rtol=1e-14, atol=0)
        assert len(found) == (all_dist2[i] <= 0.1 * 0.1).sum()
        expect_single_queries_to_find(
            locator, positions[i].astype(float), order[i], found, points.astype(float), leaves)

# Layouts and types that are not read where they are, and results that outlive everything.
ids, _ = find_closest_points(locator, numpy.asfortranarray(positions))
assert (ids == order[:, 0]).all()
ids, _ = find_closest_points(locator, [[0, 0, 0], [1, 1, 1]])
ids_of_view, _ = find_closest_points(locator, positions[::2])
assert (ids_of_view == order[::2, 0]).all()
unaligned = numpy.frombuffer(b"-" + positions.tobytes(), positions.dtype, offset=1).reshape(-1, 3)
assert not unaligned.flags.aligned
assert vtk_to_numpy(make_points(unaligned).GetPoints().GetData()).flags.aligned
ids_of_unaligned, _ = find_closest_points(locator, unaligned)
assert (ids_of_unaligned == order[:, 0]).all()
del locator, positions
assert len(ids) == 2 and (ids >= 0).all()

locator = vtkHashedOctreePointLocator()
expect_error(RuntimeError, find_closest_points, locator, numpy.zeros((3, 3)), words="SetDataSet()")
locator.SetDataSet(make_points(numpy.zeros((0, 3))))
ids, dist2 = find_closest_n_points(locator, 2, numpy.zeros((3, 3)))
assert (ids == -1).all() and numpy.isinf(dist2).all()
assert find_closest_n_points(locator, 0, numpy.zeros((3, 3)))[0].shape == (3, 0)
assert find_closest_n_points(locator, True, numpy.zeros((3, 3)))[0].shape == (3, 1)
assert find_closest_points(locator, numpy.zeros((0, 3)))[0].shape == (0,)
expect_error(ValueError, find_closest_points, locator, numpy.zeros(3), words="one alone is [x]")
expect_error(ValueError, find_closest_points, locator, 5.0, words="not ()")
expect_error(ValueError, find_closest_points, locator, numpy.zeros((4, 2)))
expect_error(TypeError, find_closest_points, locator, numpy.zeros((4, 3), dtype=complex))
expect_error(TypeError, find_closest_points, locator, numpy.ma.masked_less(numpy.zeros((4, 3)), 1))
masked_row = numpy.ma.masked_less(numpy.arange(3.0), 1)
for rows in ([masked_row, masked_row], (masked_row,), [[0, 0, 0], masked_row],
             [(0, 0, 0), (numpy.ma.masked, 0, 0)]):
    expect_error(TypeError, find_closest_points, locator, rows)
expect_error(TypeError, find_closest_points, locator, [["1", "2", "3"]])
expect_error(TypeError, find_closest_points, locator, numpy.zeros((4, 3), dtype="datetime64[s]"))
expect_error(TypeError, find_closest_points, locator, [[1 + 2j, 0, 0]])
for value in ("1", b"1", None, 1j, numpy.ma.masked, numpy.datetime64("2008-01-01")):
    expect_error(TypeError, find_closest_points, locator, numpy.array([[value, 0, 0]], dtype=object))
locator.SetDataSet(make_points([[0.5, 0.5, 0.5], [1.0, 1.0, 0.0], [0.0, 0.0, 9.0]]))
halves = numpy.array([[Decimal("0.5"), Fraction(1, 2), numpy.float32(0.5)]], dtype=object)
assert find_closest_points(locator, halves) == (0, 0.0)
truths = numpy.array([[True, numpy.True_, numpy.False_]], dtype=object)
assert find_closest_points(locator, truths) == (1, 0.0)
for radius, number in ((numpy.array([0.9]), 1), (numpy.float32(1.5), 2), (numpy.int8(2), 2), (True, 1), (0.8, 0),
                       (Fraction(3, 2), 2), (Decimal("0.9"), 1), (10**30, 3)):
    offsets, _, _ = find_points_within_radius(locator, radius, numpy.zeros((2, 3)))
    assert offsets.tolist() == [0, number, 2 * number], (radius, offsets)
for radius in (numpy.zeros(2), [], "0.5", None, 1j, numpy.ma.masked, numpy.ma.array(0.5), [numpy.ma.masked]):
    expect_error(TypeError, find_points_within_radius, locator, radius, numpy.zeros((2, 3)),
                 words="radius must be one real number")

# Points that change: a viewed array, which the locator is told of, and one that is copied.
moving = numpy.zeros((5, 3))
data = make_points(moving)
copied = numpy.zeros((5, 3), dtype=int)
copy = make_points(copied)
locator.SetDataSet(data)
assert find_closest_points(locator, [[0, 0, 0]])[1] == 0.0
moving += 1.0
copied += 1
data.GetPoints().Modified()
copy.GetPoints().Modified()
assert find_closest_points(locator, [[0, 0, 0]])[1] == 3.0
locator.SetDataSet(copy)
assert find_closest_points(locator, [[0, 0, 0]])[1] == 0.0

# What went wrong is in the exception.
expect_error(RuntimeError, find_closest_n_points, locator, 2**31 - 1, numpy.zeros((2**20, 3)),
             words="There is not enough memory for what the batch finds")
assert not locator.HasObserver("ErrorEvent")
vtkObject.GlobalWarningDisplayOff() # VTK then does not say why.
expect_error(RuntimeError, find_closest_n_points, locator, 2**31 - 1, numpy.zeros((2**20, 3)),
             words="was not done; vtkObject.GlobalWarningDisplayOn()")
vtkObject.GlobalWarningDisplayOn()
locator.SetDataSet(make_points(random.random((100000, 3))))
locator.AddObserver("ProgressEvent", lambda caller, event: caller.AbortBatch())
expect_error(RuntimeError, find_closest_points, locator, random.random((100000, 3)),
             words="stopped by AbortBatch()")
