# SPDX-License-Identifier: BSD-3-Clause
"""pvpython make_terrain.py OUT.vtp

Writes a measured terrain (138,632 points, see README.md) as a surface of quads in metres: x east, y north,
z the height above sea level, also as the point array "Elevation". The origin of x and y is the middle of
the terrain, so that float coordinates are exact to about a millimetre.
"""
import os
import signal
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

SAMPLE = "jacksboro_fault_dem.npz"


def fail(message):
    sys.exit(f"make_terrain: {message}")


def load_sample():
    try:
        from matplotlib.cbook import get_sample_data
        with np.load(get_sample_data(SAMPLE, asfileobj=False)) as sample:
            return {name: sample[name] for name in sample.files}
    except (ImportError, OSError) as error:
        fail(f"cannot read matplotlib's sample data {SAMPLE} ({error}); "
             "install matplotlib with its sample data (Debian: python3-matplotlib python-matplotlib-data)")


def metres_per_degree(latitude):
    """Length in metres of a degree of longitude and of latitude on the WGS 84 ellipsoid at a latitude in degrees."""
    phi = np.radians(latitude)
    first_e2, major_axis = 0.00669437999014, 6378137.0
    w = 1 - first_e2 * np.sin(phi) ** 2
    degree = major_axis * np.radians(1.0)
    return degree * np.cos(phi) / w ** 0.5, degree * (1 - first_e2) / w ** 1.5


def grid_points(sample):
    """The points, one line of pixels after the other from north to south, each from west to east."""
    height = sample["elevation"]
    rows, columns = height.shape
    # Line 0 is the northern one: what the sample calls ymin is its northern edge.
    east, north = metres_per_degree((sample["ymin"] + sample["ymax"]) / 2)
    x = (np.arange(columns) - (columns - 1) / 2) * sample["dx"] * east
    y = ((rows - 1) / 2 - np.arange(rows)) * sample["dy"] * north
    xx, yy = np.meshgrid(x, y)
    return np.column_stack((xx.ravel(), yy.ravel(), height.ravel())).astype(np.float32)


def grid_quads(rows, columns):
    """Corner ids of each quad, counter-clockwise seen from above."""
    first = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    return np.column_stack((first, first + columns, first + columns + 1, first + 1))


def make_surface(points, quads):
    surface = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    surface.SetPoints(vtk_points)
    cells = vtkCellArray()
    cells.SetData(quads.shape[1], numpy_to_vtkIdTypeArray(quads.astype(np.int64).ravel(), deep=True))
    surface.SetPolys(cells)
    elevation = numpy_to_vtk(np.ascontiguousarray(points[:, 2]), deep=True)
    elevation.SetName("Elevation")
    surface.GetPointData().SetScalars(elevation)
    return surface


def write(surface, path):
    """Writes beside the target first, so that a reader never meets half a file."""
    partial = f"{path}.{os.getpid()}.part"
    try:
        with open(partial, "wb"):
            pass  # VTK would only print where a path cannot be written
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(partial)
        writer.SetInputData(surface)
        # Not appended, the default: ParaView 5.11 cannot read that with the expat of Debian's security updates.
        writer.SetDataModeToBinary()
        if not writer.Write():
            raise OSError("the disk may be full")
        os.replace(partial, path)
    except OSError as error:
        fail(f"cannot write {path}: {error.strerror or error}")
    finally:  # also after Ctrl-C
        if os.path.exists(partial):
            os.remove(partial)


def main(arguments):
    if len(arguments) != 1 or arguments[0].startswith("-"):
        fail("usage: pvpython make_terrain.py OUT.vtp")
    for number in (signal.SIGINT, signal.SIGTERM):  # pvpython heeds neither by itself
        signal.signal(number, lambda number, _: sys.exit(128 + number))
    sample = load_sample()
    surface = make_surface(grid_points(sample), grid_quads(*sample["elevation"].shape))
    write(surface, arguments[0])
    print(f"{arguments[0]}: {surface.GetNumberOfPoints():,} points, {surface.GetNumberOfPolys():,} quads")


main(sys.argv[1:])
