# SPDX-License-Identifier: BSD-3-Clause
"""Batches of searches of vtkHashedOctreePointLocator, NumPy arrays in and out.

Positions are arrays of shape (m, 3) of numbers, other shapes a ValueError; float32 and float64 in C
order are read where they are. Masked arrays (whether a value is masked or not), also as rows of a
list or values in them, and what is no real number (complex numbers, strings, dates, None), also in
arrays of objects, are a TypeError. Results are views of the memory that the search filled, nothing
is copied: ids are int64, squared distances float64. A batch that could not be done is a
RuntimeError that says why, unless VTK's warnings are off: no data set, not enough memory, or stopped
by AbortBatch(). One position at a time is faster searched for by the locator's own methods, which
take NumPy rows.

The searches run on the threads of vtkSMPTools. Python's other threads, and Ctrl-C, wait until a
batch is done: give the positions in parts to be heard sooner. Only an observer of ProgressEvent can
stop a batch from Python; VTK wants it added in the thread that runs the batch, and ends the program
on Ctrl-C while one is called.
"""
from decimal import Decimal
from itertools import chain
from numbers import Real
from operator import index

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray, vtkObject, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

__all__ = ["make_points", "find_closest_points", "find_closest_n_points", "find_points_within_radius"]


def make_points(positions):
    """A vtkPolyData with these points and no cells, to give to SetDataSet(). It views an aligned
    array of float32 or float64 in C order, and copies any other. The locator has a copy of its own
    from its first query on: after a change of a viewed array call GetPoints().Modified() of the
    vtkPolyData, of any other make new points."""
    points = vtkPoints()
    points.SetData(_view(positions))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def find_closest_points(locator, positions):
    """The point closest to each position: ids and squared distances, both of shape (m,); -1 and
    infinity where there is none."""
    ids, dist2 = vtkIdTypeArray(), vtkDoubleArray()
    _run(locator, locator.FindClosestPoints, _view(positions), ids, dist2)
    return vtk_to_numpy(ids), vtk_to_numpy(dist2)


def find_closest_n_points(locator, count, positions):
    """The count points closest to each position, by distance, then by id: ids and squared
    distances, both of shape (m, count); -1 and infinity where there are fewer."""
    ids, dist2 = vtkIdTypeArray(), vtkDoubleArray()
    count = int(index(count))
    view = _view(positions)
    _run(locator, locator.FindClosestNPoints, count, view, ids, dist2)
    shape = (view.GetNumberOfTuples(), max(count, 0))
    return vtk_to_numpy(ids).reshape(shape), vtk_to_numpy(dist2).reshape(shape)


def find_points_within_radius(locator, radius, positions):
    """The points within a radius of each position, by distance, then by id: offsets of shape
    (m + 1,), ids and squared distances. Those of position i are ids[offsets[i]:offsets[i + 1]].
    Takes up to 32 bytes for each point found while it runs, 16 afterwards."""
    requirement = "radius must be one real number for all positions"
    number = _to_reals(radius, requirement)
    if number.size != 1:
        raise TypeError(f"{requirement}, not {radius!r}")
    offsets, ids, dist2 = vtkIdTypeArray(), vtkIdTypeArray(), vtkDoubleArray()
    _run(locator, locator.FindPointsWithinRadius, float(number.item()), _view(positions), offsets, ids, dist2)
    return vtk_to_numpy(offsets), vtk_to_numpy(ids), vtk_to_numpy(dist2)


def _to_reals(values, requirement):
    """An aligned array of real numbers, in C order; the requirement is what errors begin with."""
    rows = values if isinstance(values, (list, tuple)) else ()
    in_rows = (value for row in rows if isinstance(row, (list, tuple)) for value in row)
    if any(map(numpy.ma.isMaskedArray, chain((values,), rows, in_rows))):
        raise TypeError(f"{requirement}, not masked; give the values that count")
    array = numpy.require(values, requirements="CAE")
    if array.dtype.kind not in "biufO":
        raise TypeError(f"{requirement}, not {array.dtype}")
    if array.dtype.kind == "O":
        for value in array.flat:
            if not isinstance(value, (Real, Decimal, numpy.bool_)):
                raise TypeError(f"{requirement}, not {value!r}")
    return array


def _view(positions):
    """A VTK array over the positions, which keeps them alive."""
    positions = _to_reals(positions, "positions must be real numbers")
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise ValueError(f"positions must have the shape (m, 3), not {positions.shape}; one alone is [x]")
    if positions.dtype not in (numpy.float32, numpy.float64):
        positions = positions.astype(numpy.float64)
    return numpy_to_vtk(positions)


def _run(locator, search, *arguments):
    """Runs a batch; what the locator says of its errors is in the exception, and not printed."""
    errors = []

    def add_error(_locator, _event, text):
        errors.append(text.split("): ", 1)[-1].strip())

    add_error.CallDataType = "string0"
    observer = locator.AddObserver("ErrorEvent", add_error)
    try:
        done = search(*arguments)
    finally:
        locator.RemoveObserver(observer)
    if not done and not errors and not vtkObject.GetGlobalWarningDisplay():
        errors.append("The batch of searches was not done; vtkObject.GlobalWarningDisplayOn() lets VTK say why.")
    if not done:
        raise RuntimeError(" ".join(errors) or "The batch of searches was stopped by AbortBatch().")
