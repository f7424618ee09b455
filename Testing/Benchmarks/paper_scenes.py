# SPDX-License-Identifier: BSD-3-Clause
"""Point sets of the paper's experiments with what the filters put out for them, and pictures of that by ParaView, as
arrays of colours. The plugin must be loaded before they are made, and a display is needed."""
import os
import sys
import tempfile

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgb
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin", "Demo"))
import demo

SIDE = 1200  # of a picture, in pixels
DARK = "#222222"
# What the array Case says, and colours that the colour-blind can tell apart.
CASES = {0: ("query leaf", "#333333"), 1: ("case 1: of the same depth", "#56B4E9"),
         2: ("case 2: deeper, found on the way down", "#F0C239"),
         3: ("case 3: higher, where no node of its depth is", "#D55E00")}
RADIUS_OF_SIDE = 2.2  # of in-radius searches, in sides of the query leaf
QUERIES_TRIED = 200  # leaves of which the one is taken that shows the cases best


class PointSet:
    """A point set, and what the octree filter puts out for it."""

    def __init__(self, folder, name, paper_name):
        self.name, self.paper_name = name, paper_name
        path = os.path.join(folder, f"{name}.xyz")
        if not os.path.isfile(path):
            raise demo.DemoError(f"{path} does not exist; "
                                 f"make it with /usr/bin/python3 Data/make_point_sets.py {folder}")
        self.points = np.fromfile(path, "<f4").reshape(-1, 3)
        self.source = to_source(self.points)
        self.octree = demo.apply_octree(self.source, path)
        self.figures = demo.field_data(self.octree)
        self.histogram, self.costs = demo.table(self.octree, 1), demo.table(self.octree, 2)
        self.stage = demo.Stage(self.octree.GetDataInformation().GetBounds())

    def __str__(self):
        return f"{self.name} ({len(self.points):,} points, for the paper's {self.paper_name})"

    def depth_shares(self):
        """The paper's p_l, of all leaves."""
        return self.histogram["Leaves"] / self.histogram["Leaves"].sum()

    def points_of_leaves_at(self, height):
        """Those whose leaves a plane across z cuts."""
        located = servermanager.Fetch(simple.HashedOctreeLocate(Input=self.source, QueryPoints=self.source))
        leaves = servermanager.Fetch(self.octree)
        corners = vtk_to_numpy(leaves.GetCells().GetConnectivityArray()).reshape(-1, 8)[:, [0, 7]]
        low, high = vtk_to_numpy(leaves.GetPoints().GetData())[corners, 2].T
        leaf = vtk_to_numpy(located.GetPointData().GetArray("LeafId"))
        return self.points[(low[leaf] < height) & (height < high[leaf])]


def to_source(points):
    data, coordinates = vtkPolyData(), vtkPoints()
    coordinates.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(coordinates)
    source = servermanager.sources.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


class Query:
    """A leaf of a point set, and the neighbours filter that searches around it."""

    def __init__(self, point_set):
        self.point_set = point_set
        filters = {mode: simple.HashedOctreeNeighbors(Input=point_set.source, SearchMode=mode, IncludeEmptyLeaves=1)
                   for mode in ("Adjacent", "InRadius")}
        self.adjacent, self.in_radius = filters["Adjacent"], filters["InRadius"]
        self.move_to(max(point_set.points[::len(point_set.points) // QUERIES_TRIED + 1], key=self.least_case))
        cell = servermanager.Fetch(self.adjacent).GetCell(0)
        low, high = np.array(cell.GetBounds()).reshape(3, 2).T
        self.center, self.side = (low + high) / 2, high[0] - low[0]
        self.plane = self.get_plane((low[2], high[2]))
        self.dots = point_set.points_of_leaves_at(self.plane)[:, :2]
        self.radius = RADIUS_OF_SIDE * self.side
        self.in_radius.Radius = self.radius
        self.in_radius.UpdatePipeline()

    @staticmethod
    def get_plane(heights):
        """Height of the plane through a leaf, given its bottom and top: off the middle, where deeper leaves meet."""
        return np.interp(0.57, (0, 1), heights)

    def move_to(self, point):
        for search in (self.adjacent, self.in_radius):
            search.Center = [float(x) for x in point]
        self.adjacent.UpdatePipeline()

    def least_case(self, point):
        """Neighbours of the case that has the fewest, around the leaf of a point and in a plane with it; none where a
        neighbour is so large that it hides the others."""
        self.move_to(point)
        cells = servermanager.Fetch(self.adjacent)
        bounds = np.array([cells.GetCell(i).GetBounds() for i in range(cells.GetNumberOfCells())])
        case = vtk_to_numpy(cells.GetCellData().GetArray("Case"))
        plane = self.get_plane(bounds[0, 4:])
        in_plane = (bounds[:, 4] < plane) & (plane < bounds[:, 5])
        sides = bounds[:, 1] - bounds[:, 0]
        least = min(np.count_nonzero(case[in_plane] == which) for which in list(CASES)[1:])
        return least if sides.max() < 2.5 * sides[0] else 0


def render(view):
    """What a view shows, as an array of colours, without the white around it."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.png")
        simple.SaveScreenshot(path, view, ImageResolution=(SIDE, SIDE))
        colors = plt.imread(path)[:, :, :3]
    simple.Delete(view)
    rows, columns = np.nonzero((colors < 0.999).any(axis=2))
    return colors[rows.min():rows.max() + 1, columns.min():columns.max() + 1] if len(rows) else colors


def octree_scene(point_set):
    """The leaves that hold points, coloured by depth."""
    view = demo.white_view(SIDE, SIDE)
    demo.show_cells(point_set.octree, view, demo.shows_edges(point_set.figures, SIDE))
    point_set.stage.look(view, 0.5, 0.6)
    return render(view)


def set_depth_colors(point_set):
    """One colour for each depth of leaves that hold points, in the scenes from here on; as a dictionary."""
    least, greatest = point_set.octree.CellData["Depth"].GetRange()
    colors = np.reshape(demo.set_colors("Depth", least, greatest).IndexedColors, (-1, 3))
    return dict(zip(range(int(least), int(greatest) + 1), colors))


def set_case_colors():
    function = simple.GetColorTransferFunction("Case")
    function.InterpretValuesAsCategories = 1
    function.AnnotationsInitialized = 1
    function.Annotations = [str(case) for case in CASES for _ in range(2)]
    function.IndexedColors = [channel for _, color in CASES.values() for channel in to_rgb(color)]


def moved(source, by):
    """A copy of a source elsewhere. (ParaView 5.13 calls the property for that by another name than 5.11.)"""
    copy = simple.Transform(Input=source)
    copy.Transform.Translate = [*by]
    return copy


def show_plain(source, view, representation, color=DARK):
    """Shows a source in one colour."""
    shown = simple.Show(source, view)
    shown.SetRepresentationType(representation)
    shown.AmbientColor = shown.DiffuseColor = list(to_rgb(color))
    shown.Ambient, shown.Diffuse = 1, 0
    return shown


def plane_scene(query, search):
    """What the plane through the query leaf cuts: all leaves with their points, those found by case, the ball."""
    view, width, middle = demo.white_view(SIDE, SIDE), 3.3 * query.radius, [*query.center[:2], query.plane]
    every = simple.HashedOctree(Input=query.point_set.source, IncludeEmptyLeaves=1)
    # The found ones lie a little nearer to the eye, the circle and the points nearer still.
    for source, height in ((every, 0), (search, 0.01 * width)):
        cut = simple.Slice(Input=source, Triangulatetheslice=0)
        cut.SliceType.Origin, cut.SliceType.Normal = middle, [0, 0, 1]
        shown = demo.show_cells(moved(cut, (0, 0, height)), view, edges=True, ambient=1)
        simple.ColorBy(shown, ("CELLS", "Case") if source is search else None)
        if source is every:
            shown.AmbientColor, shown.EdgeColor = [1, 1, 1], [0.75] * 3
    if search is query.in_radius:
        radius = np.sqrt(query.radius ** 2 - (query.plane - query.center[2]) ** 2)
        circle = simple.Disk(InnerRadius=0.99 * radius, OuterRadius=radius, CircumferentialResolution=180)
        show_plain(moved(circle, (*query.center[:2], query.plane + 0.02 * width)), view, "Surface")
    for color, size, height in (("white", width / 50, 0.02 * width), (DARK, width / 70, 0.03 * width)):
        raised = np.column_stack((query.dots, np.full(len(query.dots), query.plane + height)))
        show_plain(simple.Glyph(Input=to_source(raised), GlyphType="Sphere", GlyphMode="All Points", ScaleFactor=size,
                                ScaleArray=["POINTS", "No scale array"]), view, "Surface", color)
    view.CameraParallelProjection, view.CameraParallelScale = 1, width / 2
    view.CameraFocalPoint, view.CameraViewUp = middle, [0, 1, 0]
    view.CameraPosition = [*query.center[:2], query.plane + 10 * width]
    return render(view)


def space_scene(query, search):
    """The leaves found, by case: their edges, and in them smaller boxes, between which those behind are seen."""
    view = demo.white_view(SIDE, SIDE)
    shown = demo.show_cells(simple.Shrink(Input=search, ShrinkFactor=0.6), view, edges=True)
    simple.ColorBy(shown, ("CELLS", "Case"))
    simple.Show(search, view).SetRepresentationType("Feature Edges")
    query.point_set.stage.look(view, 0.5, 0.6)
    return render(view)
