# SPDX-License-Identifier: BSD-3-Clause
"""The quadtree of points in a plane, a spiral, as ParaView shows it: squares coloured by depth."""
import numpy
import octreetesting
from demo import white_view
from paraview import servermanager, simple
from vtk.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_PIXEL, vtkCellArray, vtkPolyData

DARK, WHITE = [0.15] * 3, [1.0] * 3


def make_spiral():
    """Four arms, whose points lie the closer to each other the nearer they are to the middle."""
    turn = numpy.linspace(0.0, 1.0, 90)
    angle = 2.3 * numpy.pi * turn
    radius = 0.03 * (1 / 0.03) ** turn
    x, y = radius * numpy.cos(angle), radius * numpy.sin(angle)
    arms = [numpy.column_stack((a, b, 0.0 * turn)) for a, b in ((x, y), (-y, x), (-x, -y), (y, -x))]
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.concatenate(arms), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    vertices = vtkCellArray()
    for i in range(points.GetNumberOfPoints()):
        vertices.InsertNextCell(1, [i])
    data.SetVerts(vertices)
    source = servermanager.sources.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


view = white_view(640, 540)

spiral = make_spiral()
octree = simple.HashedOctree(Input=spiral, IncludeEmptyLeaves=1)
shown = simple.Show(octree, view)
assert list(shown.ColorArrayName) == ["CELLS", "Depth"], shown.ColorArrayName
shown.Representation = "Surface With Edges"
shown.EdgeColor, shown.Ambient, shown.Diffuse = [0.35] * 3, 1.0, 0.0

cells = octreetesting.fetch(octree, 0)
assert {cells.GetCellType(i) for i in range(cells.GetNumberOfCells())} == {VTK_PIXEL}
figures = octreetesting.arrays(cells.GetFieldData())
assert figures["Dimension"][0] == 2
depths = octreetesting.arrays(cells.GetCellData())["Depth"]
assert (4.0 ** -depths).sum() == 1.0, "the leaves tile the root"

# Light where leaves are large, dark where they are small, a colour for each depth.
steps = numpy.arange(depths.min(), depths.max() + 1)
colors = simple.GetColorTransferFunction("Depth")
colors.InterpretValuesAsCategories = 1
colors.Annotations = [str(step) for step in steps for _ in range(2)]
share = numpy.linspace(0.0, 1.0, len(steps))[:, None]
ends = numpy.array([[0.97, 0.97, 0.9], [0.55, 0.8, 0.72], [0.1, 0.35, 0.6]])
colors.IndexedColors = list(numpy.where(
    share < 0.5, ends[0] + 2 * share * (ends[1] - ends[0]),
    ends[1] + (2 * share - 1) * (ends[2] - ends[1])).ravel())

# A little nearer to the camera than the leaves.
nearer = simple.Transform(Input=spiral)
nearer.Transform.Translate = [0.0, 0.0, 0.01]
points = simple.Show(nearer, view)
points.SetRepresentationType("Points")
points.AmbientColor, points.PointSize = [0.85, 0.2, 0.1], 3.0
points.Ambient, points.Diffuse = 1.0, 0.0

legend = simple.GetScalarBar(colors, view)
legend.Title, legend.ComponentTitle = "Depth", ""
legend.TitleColor = legend.LabelColor = DARK
legend.Visibility = 1
simple.ResetCamera(view)
low, high = cells.GetBounds()[0::2], cells.GetBounds()[1::2]
middle = [(a + b) / 2 for a, b in zip(low, high)]
view.CameraParallelProjection = 1
view.CameraParallelScale = 0.51 * (high[1] - low[1])
middle[0] += 0.07 * (high[0] - low[0])  # room for the legend
view.CameraPosition = [middle[0], middle[1], 9.0]
view.CameraFocalPoint = middle
view.CameraViewUp = [0.0, 1.0, 0.0]
simple.Render(view)
octreetesting.compare_with_baseline(view)
