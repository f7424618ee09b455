# SPDX-License-Identifier: BSD-3-Clause
"""Batches of searches with NumPy arrays, against comparing with every point."""
import numpy
from hashedoctree import vtkHashedOctreePointLocator
from hashedoctree.arrays import (
    find_closest_n_points, find_closest_points, find_points_within_radius, make_points)

random = numpy.random.default_rng(201)


def expect_error(kind, function, *arguments):
    try:
        function(*arguments)
    except kind:
        return
    raise AssertionError(f"no {kind.__name__}")


for dtype in (numpy.float32, numpy.float64):
    points = random.random((3000, 3)).astype(dtype)
    positions = random.random((200, 3)).astype(dtype)
    differences = positions[:, None, :].astype(float) - points[None, :, :].astype(float)
    all_dist2 = (differences * differences).sum(axis=2)
    order = numpy.argsort(all_dist2, axis=1, kind="stable")
    locator = vtkHashedOctreePointLocator()
    locator.SetDataSet(make_points(points))

    ids, dist2 = find_closest_points(locator, positions)
    assert ids.shape == dist2.shape == (200,) and ids.dtype == numpy.int64, (ids, dist2)
    assert (ids == order[:, 0]).all()
    assert numpy.allclose(dist2, all_dist2.min(axis=1), rtol=1e-14, atol=0)

    ids, dist2 = find_closest_n_points(locator, 9, positions)
    assert ids.shape == dist2.shape == (200, 9)
    assert (ids == order[:, :9]).all() and (numpy.diff(dist2) >= 0).all()

    offsets, ids, dist2 = find_points_within_radius(locator, 0.1, positions)
    assert offsets.shape == (201,) and offsets[0] == 0 and offsets[-1] == len(ids) == len(dist2)
    for i in range(200):
        found = ids[offsets[i]:offsets[i + 1]]
        assert (found == order[i, :len(found)]).all()
        assert len(found) == (all_dist2[i] <= 0.1 * 0.1).sum()

# Layouts and types that are not read where they are, and results that outlive everything.
ids, _ = find_closest_points(locator, numpy.asfortranarray(positions))
assert (ids == order[:, 0]).all()
ids, _ = find_closest_points(locator, [[0, 0, 0], [1, 1, 1]])
ids_of_view, _ = find_closest_points(locator, positions[::2])
assert (ids_of_view == order[::2, 0]).all()
del locator, positions
assert len(ids) == 2 and (ids >= 0).all()

locator = vtkHashedOctreePointLocator()
ids, dist2 = find_closest_n_points(locator, 2, numpy.zeros((3, 3)))
assert (ids == -1).all() and numpy.isinf(dist2).all()
assert find_closest_n_points(locator, 0, numpy.zeros((3, 3)))[0].shape == (3, 0)
assert find_closest_points(locator, numpy.zeros((0, 3)))[0].shape == (0,)
expect_error(ValueError, find_closest_points, locator, numpy.zeros(3))
expect_error(ValueError, find_closest_points, locator, numpy.zeros((4, 2)))
locator.SetDataSet(make_points(random.random((100000, 3))))
locator.AddObserver("ProgressEvent", lambda caller, event: caller.AbortBatch())
expect_error(RuntimeError, find_closest_points, locator, random.random((100000, 3)))
