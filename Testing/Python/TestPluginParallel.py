# SPDX-License-Identifier: BSD-3-Clause
"""Several processes, each with its piece of the points; all run this script."""
import os

from octreetesting import argument, write_sphere
from paraview import simple
from vtkmodules.vtkCommonDataModel import VTK_PIXEL, VTK_VOXEL
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
rank = controller.GetLocalProcessId()
assert controller.GetNumberOfProcesses() == 4


def run(source, cell_type, **properties):
    """Numbers of points, of cells, which all have this type, and of rows of both tables, in this
    process."""
    errors = []
    octree = simple.HashedOctree(Input=source, **properties)
    filter_ = octree.GetClientSideObject()
    filter_.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    octree.UpdatePipeline()
    assert not errors
    points = source.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints()
    cells, histogram, costs = (filter_.GetOutputDataObject(port) for port in range(3))
    assert {cells.GetCellType(i) for i in range(cells.GetNumberOfCells())} <= {cell_type}
    return points, cells.GetNumberOfCells(), histogram.GetNumberOfRows(), costs.GetNumberOfRows()


def leaves_in_grid(source):
    """Number of leaves with points in this process's hyper tree grid."""
    octree = simple.HashedOctree(Input=source, OutputType="HyperTreeGrid")
    leaves = simple.HyperTreeGridToUnstructuredGrid(Input=octree)
    leaves.UpdatePipeline()
    return leaves.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()


# A source that every process makes its part of: each has a tree of its own points.
sphere = simple.Sphere(ThetaResolution=64, PhiResolution=64)
points, cells, rows, cost_rows = run(sphere, VTK_VOXEL)
assert 0 < points < 64 * 62
assert 0 < cells <= points and rows == cost_rows > 1, (rank, points, cells, rows)
assert leaves_in_grid(sphere) == cells
points, cells, rows, cost_rows = run(sphere, VTK_PIXEL, Dimension="Two", Plane="XY")
assert 0 < cells <= points and rows == cost_rows > 1, (rank, points, cells, rows)

# All points in one process: the others have none, which is no error.
if rank == 0:
    path, number_of_points = write_sphere()
controller.Barrier()
path = os.path.join(argument("-T"), "sphere.vtp")
reader = simple.XMLPolyDataReader(FileName=[path])
points, cells, rows, cost_rows = run(reader, VTK_VOXEL)
assert leaves_in_grid(reader) == cells
if rank == 0:
    assert cells == points == number_of_points and rows == cost_rows > 1, (cells, points, rows)
else:
    assert (points, cells, rows, cost_rows) == (0, 0, 0, 0), (rank, points, cells, rows)
