# SPDX-License-Identifier: BSD-3-Clause
"""Shows the octree of a file's points: its leaves, its depth histogram and what searches in it cost.

In ParaView:   HASHEDOCTREE_FILE=FILE PYTHONPATH=. paraview --plugins=HashedOctree --script=demo.py
As pictures:   HASHEDOCTREE_FILE=FILE pvpython demo.py --batch --plugin HashedOctree.so --output DIR

Both in this folder. FILE is what read_points.py reads. The second form writes four pictures and two tables into DIR,
all or none, and prints a summary. (ParaView does not tell a script where it lies, hence PYTHONPATH.)
"""
import argparse
import contextlib
import csv
import os
import signal
import sys
import tempfile

import numpy as np
from paraview import servermanager, simple
from read_points import DemoError, read_points
from vtkmodules.util.numpy_support import vtk_to_numpy

PICTURE_SIZE = 1600, 1000
HALF = PICTURE_SIZE[0] // 2, 860  # of a picture of the octree, above its legend
MOST_STEPS = 33  # depths and costs are less
# To show all of more leaves than these, or a slice through them, takes too long for a demo.
MOST_LEAVES_SHOWN = 4_000_000
TEXT, EDGE, WHITE, BLACK = [0.13] * 3, [0.13] * 3, [1.0] * 3, [0.0] * 3
# From shallow or cheap to deep or dear: matplotlib's viridis without its darkest quarter, in which no edges would be
# seen. It only grows lighter, so that the order is seen without colours and by the colour-blind, too.
SCALE = np.array([[0x3b, 0x52, 0x8b], [0x2c, 0x72, 0x8e], [0x21, 0x91, 0x8c], [0x28, 0xae, 0x80], [0x5e, 0xc9, 0x62],
                  [0xad, 0xdc, 0x30], [0xfd, 0xe7, 0x25]]) / 255


def stop(number, _):
    """Ends Python as a signal would end a program, but not before all that it holds open is tidied up."""
    sys.exit(128 + number)


@contextlib.contextmanager
def quiet():
    """Keeps what VTK writes off stderr, so that an error is one line; gives it back if Python itself fails."""
    sys.stderr.flush()
    kept = os.dup(2)
    with tempfile.TemporaryFile() as said:
        os.dup2(said.fileno(), 2)
        try:
            yield
        except DemoError:
            raise
        except Exception:
            said.seek(0)
            os.write(kept, said.read())
            raise
        finally:
            os.dup2(kept, 2)
            os.close(kept)


# ---- Data -----------------------------------------------------------------------------------------------------------

def apply_octree(source, path):
    octree = simple.HashedOctree(Input=source)
    octree.UpdatePipeline()
    if octree.GetDataInformation().GetNumberOfCells() == 0:
        raise DemoError(f"no octree could be built from {path}; are its coordinates finite?")
    return octree


def field_data(octree):
    """The figures of the octree by name; what else its file brought may be no number, or many."""
    data = servermanager.Fetch(octree, idx=0).GetFieldData()
    arrays = map(data.GetArray, range(data.GetNumberOfArrays()))
    return {array.GetName(): array.GetTuple1(0) for array in arrays if array and array.GetNumberOfValues() == 1}


def table(octree, port):
    """The columns of a table by name."""
    rows = servermanager.Fetch(octree, idx=port).GetRowData()
    return {rows.GetArrayName(i): vtk_to_numpy(rows.GetArray(i)) for i in range(rows.GetNumberOfArrays())}


def write_csv(path, columns):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(zip(*(column.tolist() for column in columns.values())))


def human_bytes(count):
    """In the largest unit of which it is one or more, and exactly."""
    exact = f"{count:,.0f} bytes"
    if count < 1024:
        return exact
    for unit in ("KiB", "MiB", "GiB"):
        count /= 1024
        if count < 1023.95 or unit == "GiB":
            return f"{count:.1f} {unit} ({exact})"


def summary(path, figures):
    def count(name):
        return f"{figures[name]:,.0f}"

    lines = [("file", path),
             ("points", count("NumberOfPoints")),
             ("nodes", count("NumberOfNodes")),
             ("leaves", count("NumberOfLeaves")),
             ("empty leaves", count("NumberOfEmptyLeaves")),
             ("deepest", count("DeepestDepth")),
             ("start depth by points", count("StartDepthPoints")),
             ("start depth by grid", count("StartDepthGrid")),
             ("start depth by leaves", count("StartDepthLeaves")),
             ("mean cost from it", f"{figures['MeanHitCost']:.3f} nodes, leaves equally often"),
             ("mean cost from root", f"{figures['MeanRootCost']:.3f} nodes"),
             ("ratio", f"{figures['CostRatio']:.2f}"),
             ("tree", human_bytes(figures["TreeBytes"])),
             ("build time", f"{1000 * figures['BuildSeconds']:,.1f} ms")]
    if figures["SkippedPoints"]:
        lines.append(("skipped", f"{count('SkippedPoints')} points that are not finite, or too large"))
    return "\n".join(f"{name:<22} {value}" for name, value in lines)


# ---- Octree in space ------------------------------------------------------------------------------------------------

def find_height_axis(source, path):
    """Meshes in these formats mostly stand along y, scans and all else along z."""
    may_be_object = os.path.splitext(path)[1].lower() in (".obj", ".ply", ".gltf", ".glb")
    return 1 if may_be_object and source.GetDataInformation().GetNumberOfCells() > 0 else 2


def make_stage(source, path, octree, figures):
    """A quadtree is seen from above, all of it, unless most leaves are dots."""
    from_above = figures["Dimension"] == 2 and figures["NumberOfLeaves"] <= MOST_LEAVES_SHOWN and not are_dots(figures)
    return Stage(octree.GetDataInformation().GetBounds(), find_height_axis(source, path), from_above)


class Stage:
    """Where the leaves are and from where to look at them; all in the units of the data. Heights are along the thin
    axis of what is flat, else along `height_axis`."""

    def __init__(self, bounds, height_axis=2, from_above=False):
        self.from_above = from_above
        low, high = np.array(bounds).reshape(3, 2).T
        extent = high - low
        self.middle, self.side = (low + high) / 2, max(extent) or 1.0
        thin = int(np.argmin(extent))
        self.flat = 0 < max(extent) and extent[thin] < self.side / 4
        up_axis = thin if self.flat else height_axis
        back_axis = 2 if up_axis == 1 else 1
        self.up = np.eye(3)[up_axis]
        self.front = np.eye(3)[back_axis] * (1 if up_axis == 1 else -1)
        self.right = np.cross(self.up, self.front)
        # The slice stands at the back of what is flat and goes through the middle of what is not; inside the root,
        # which begins at the lower corner, and by odd fractions off the faces of cells.
        behind = 0.4927 * extent[back_axis] if self.flat else 0.00137 * self.side
        origin = self.middle - behind * self.front
        self.slice_origin = np.clip(origin, low + 0.00137 * self.side, low + 0.99863 * self.side)

    def look(self, view, sideways, height):
        """From straight above, or from the front, moved to the right and up, at all there is in the view."""
        direction = self.up if self.from_above else self.front + sideways * self.right + height * self.up
        view.CameraFocalPoint = list(self.middle)
        view.CameraPosition = list(self.middle + 3 * self.side * direction)
        view.CameraViewUp = list(-self.front if self.from_above else self.up)
        view.SMProxy.ResetCamera(True)  # True: as near as the shape of the view allows

    def look_closely(self, view, target, width):
        """At a target in the same direction; the view is about that wide at the target, if that is nearer."""
        away = np.subtract(view.CameraPosition, view.CameraFocalPoint)
        distance = width / 2 / np.tan(np.radians(view.CameraViewAngle / 2))
        if distance < np.linalg.norm(away):
            view.CameraFocalPoint = list(target)
            view.CameraPosition = list(target + away * (distance / np.linalg.norm(away)))


def slice_all_leaves(source, stage):
    """A cut through the whole octree, empty leaves too; of a quadtree, which is one, all leaves."""
    leaves = simple.HashedOctree(Input=source, IncludeEmptyLeaves=1)
    if stage.from_above:
        leaves.UpdatePipeline()
        return leaves
    cut = simple.Slice(Input=leaves)
    cut.SliceType.Origin, cut.SliceType.Normal = list(stage.slice_origin), list(stage.front)
    cut.Triangulatetheslice = 0
    cut.UpdatePipeline()
    return cut


def leaves_between(cells, least_depth, greatest_depth):
    return simple.Threshold(Input=cells, Scalars=["CELLS", "Depth"], ThresholdMethod="Between",
                            LowerThreshold=least_depth, UpperThreshold=greatest_depth)


def most_varied_place(octree, stage):
    """A leaf amid the tile, of 8 x 8 seen from above, where depths differ most; and the tile's median depth."""
    centers = servermanager.Fetch(simple.CellCenters(Input=octree))
    places, depths = vtk_to_numpy(centers.GetPoints().GetData()), vtk_to_numpy(centers.GetPointData().GetArray("Depth"))
    across = places @ np.column_stack((stage.right, stage.front))
    tile = np.floor((across - across.min(0)) / (stage.side * 1.0001) * 8).astype(int) @ [8, 1]
    count = np.bincount(tile, minlength=64)
    mean = np.bincount(tile, depths, 64) / np.maximum(1, count)
    # A few leaves make no picture: they count as if there were fifty, most of them alike.
    spread = np.bincount(tile, (depths - mean[tile]) ** 2, 64) / np.maximum(50, count)
    inside = tile == np.argmax(spread)
    amid = np.argmin(np.linalg.norm(places[inside] - places[inside].mean(0), axis=1))
    return places[inside][amid], np.median(depths[inside])


def find_depths(octree):
    """The depths of the highest and the deepest leaf, empty ones too."""
    histogram = table(octree, 1)
    depths = histogram["Depth"][histogram["Leaves"] > 0]
    return depths.min(), depths.max()


def set_colors(array, least, greatest, may_change=False):
    """One colour and one label for each whole number from the least to the greatest; for others, too, if the octree may
    change, of which ParaView then shows those between the extremes."""
    steps = np.arange(MOST_STEPS) if may_change else np.arange(int(least), int(greatest) + 1)
    # One alone has the colour in the middle, which is seen on white and on black.
    at = np.clip((steps - least) / max(1, greatest - least) + 0.5 * (least == greatest), 0, 1) * (len(SCALE) - 1)
    colors = np.column_stack([np.interp(at, np.arange(len(SCALE)), channel) for channel in SCALE.T])
    function = simple.GetColorTransferFunction(array)
    function.InterpretValuesAsCategories = 1
    function.AnnotationsInitialized = 1
    function.ShowCategoricalColorsinDataRangeOnly = int(may_change)
    function.Annotations = [str(step) for step in steps for _ in range(2)]
    function.IndexedColors = list(colors.ravel())
    return function


def show_cells(source, view, edges, ambient=0.5):
    shown = simple.Show(source, view)
    shown.Representation = "Surface With Edges" if edges else "Surface"
    shown.EdgeColor, shown.Ambient, shown.Diffuse = EDGE, ambient, 1 - ambient
    simple.ColorBy(shown, ("CELLS", "Depth"))
    return shown


def show_occupied(octree, view, figures, edges):
    """The leaves that hold points; as dots, where most are so small that nothing else would be seen of them. In pictures
    these are on black, as light ones would not be seen on white."""
    shown = show_cells(octree, view, edges)
    if are_dots(figures):
        shown.Representation, shown.PointSize, view.Background = "Points", 4, BLACK
    return shown


def shows_edges(figures, pixels):
    """Whether the edges of most leaves leave some of their colour to be seen in a view of that many pixels."""
    return pixels > 10 * 2 ** figures["StartDepthPoints"]


def are_dots(figures):
    return 2 ** figures["StartDepthPoints"] > 8 * PICTURE_SIZE[1]


def white_view(width, height):
    view = simple.CreateView("RenderView")
    view.ViewSize = width, height
    view.UseColorPaletteForBackground, view.Background = 0, WHITE
    view.OrientationAxesVisibility = 0
    return view


def show_whole(stage, octree, cut, figures):
    """A view of what is flat with the slice behind it, of the rest of the slice, or the quadtree, alone."""
    view, shown = white_view(*HALF), []
    if not cut or stage.flat and not stage.from_above:
        shown.append(show_occupied(octree, view, figures, shows_edges(figures, HALF[1])))
    if cut:
        # Edges of leaves that are only a few pixels wide would hide their colours.
        edged = int(np.log2(HALF[0] / 6))
        shown.append(show_cells(leaves_between(cut, 0, edged), view, edges=True, ambient=1))
        shown.append(show_cells(leaves_between(cut, edged + 1, figures["DeepestDepth"]), view, edges=False, ambient=1))
    stage.look(view, *((0.4, 0.75) if stage.flat else (0, 0) if cut else (0.5, 0.35)))
    return view, shown


def show_leaves(stage, octree, figures):
    """A view of the octree's leaves; of what is flat a part, near enough to tell the leaves apart."""
    view = white_view(*HALF)
    shown = [show_occupied(octree, view, figures, stage.flat or shows_edges(figures, HALF[1]))]
    stage.look(view, *((0.4, 0.75) if stage.flat else (0.5, 0.35)))
    if stage.flat:
        place, depth = most_varied_place(octree, stage)
        # Nearer still, and the leaves would lie before what the camera can see along with the rest.
        nearest = 0.2 if are_dots(figures) else 0.02
        stage.look_closely(view, place, np.clip(80 / 2 ** depth, nearest, 0.4) * stage.side)
    return view, shown


def show_captions(captions):
    """A view with one caption below each half of the picture and room for a colour bar."""
    view = white_view(PICTURE_SIZE[0], PICTURE_SIZE[1] - HALF[1])
    for half, caption in enumerate(captions):
        text = simple.Show(simple.Text(Text=caption), view)
        text.Color, text.FontSize, text.WindowLocation = TEXT, 20, "Any Location"
        text.Position = [0.02 + 0.5 * half, 0.75]
    return view


def show_color_bar(view, array, title):
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(array), view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.Orientation, bar.WindowLocation, bar.Position = "Horizontal", "Any Location", [0.15, 0.22]
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.7, 22
    bar.TitleColor = bar.LabelColor = TEXT
    bar.TitleFontSize, bar.LabelFontSize, bar.Visibility = 20, 20, 1
    return bar


def lay_out(whole, leaves, captions):
    layout = simple.CreateLayout()
    layout.SplitVertical(0, HALF[1] / PICTURE_SIZE[1])
    layout.SplitHorizontal(1, 0.5)
    for cell, view in ((3, whole), (4, leaves), (2, captions)):
        layout.AssignView(cell, view)
    layout.SetSize(PICTURE_SIZE)
    return layout


def octree_pictures(folder, stage, source, octree, figures):
    # Of a quadtree that is not seen from above a slice would be lines.
    has_cut = stage.from_above or figures["Dimension"] == 3 and figures["NumberOfLeaves"] <= MOST_LEAVES_SHOWN
    cut = slice_all_leaves(source, stage) if has_cut else None
    held = "Leaves that hold points" + (", as dots" if are_dots(figures) else "")
    if stage.from_above:
        captions = "All leaves", "A closer look"
    elif stage.flat:
        captions = held + (", in front of a slice through all leaves" if cut else ""), "A closer look"
    else:
        captions = "Slice through all leaves" if cut else held, held
    whole, shown = show_whole(stage, octree, cut, figures)
    leaves, more_shown = show_leaves(stage, cut if stage.from_above else octree, figures)
    below = show_captions(captions)
    layout = lay_out(whole, leaves, below)
    for array, title in (("Depth", "Depth of the leaf (0 = root)"),
                         ("HitCost", "Hit cost: nodes that a search examines to find the leaf, "
                                     f"starting at depth {figures['StartDepth']:.0f}")):
        ranges = [cells.CellData[array].GetRange() for cells in (octree, cut) if cells]
        ranges += [find_depths(octree)] if array == "Depth" else []  # as in the window
        set_colors(array, min(low for low, _ in ranges), max(high for _, high in ranges))
        for representation in shown + more_shown:
            simple.ColorBy(representation, ("CELLS", array))
        bar = show_color_bar(below, array, title)
        simple.SaveScreenshot(os.path.join(folder, f"octree-{array.lower()}.png"), layout,
                              ImageResolution=PICTURE_SIZE, SeparatorWidth=2, SeparatorColor=WHITE)
        bar.Visibility = 0


# ---- Charts ---------------------------------------------------------------------------------------------------------

def chart_view(octree, port):
    """The chart of a table, which follows what becomes of the octree."""
    view = simple.CreateView({1: "HashedOctreeDepthHistogramView", 2: "HashedOctreeCostCurvesView"}[port])
    simple.Show(simple.OutputPort(octree, port), view)
    return view


def title_histogram(view, octree, figures):
    """For a picture: numbers, and axes that fit the table as it is."""
    leaves, empty = figures["NumberOfLeaves"], figures["NumberOfEmptyLeaves"]
    view.ChartTitle = f"{leaves:,.0f} leaves, {empty:,.0f} of them empty" if leaves != 1 else "One leaf"
    histogram = table(octree, 1)
    label_axis(view, "Bottom", -0.6, histogram["Depth"].max() + 0.6, 1)
    most = max(histogram[name].max() for name in ("Leaves", "EmptyLeaves", "Points"))
    label_axis(view, "Left", 0, 1.05 * most, step_between_labels(most))


def title_costs(view, octree, figures):
    """The same for costs."""
    view.ChartTitle = f"Mean over all leaves: {figures['MeanHitCost']:.2f} nodes " \
                      f"from depth {figures['StartDepth']:.0f}, {figures['MeanRootCost']:.2f} from the root"
    costs = table(octree, 2)
    label_axis(view, "Bottom", -0.1, costs["StartDepth"].max() + 0.1, 1)
    highest = max(column.max() for name, column in costs.items() if name.startswith(("Cost", "Measured")))
    label_axis(view, "Left", 0, highest + 0.5, step_between_labels(highest))


def step_between_labels(top):
    """The least whole number 1, 2 or 5 times a power of ten that needs at most ten labels up to the top."""
    power = 1
    while top > 100 * power:
        power *= 10
    return next((factor * power for factor in (1, 2, 5) if factor * power * 10 >= top), 10 * power)


def label_axis(view, axis, low, high, step):
    """Whole numbers at each step from 0 to the end of the axis."""
    labels = [(str(at), f"{at:,}") for at in range(0, int(high) + 1, int(step))]
    setattr(view, f"{axis}AxisUseCustomRange", 1)
    setattr(view, f"{axis}AxisRangeMinimum", float(low))
    setattr(view, f"{axis}AxisRangeMaximum", float(high))
    setattr(view, f"{axis}AxisUseCustomLabels", 1)
    setattr(view, f"{axis}AxisLabels", [word for label in labels for word in label])


def chart_picture(path, view, axis_titles, legend_position):
    view.ViewSize = PICTURE_SIZE
    view.BottomAxisTitle, view.LeftAxisTitle = axis_titles
    view.ChartTitleFontSize = 26
    for axis in ("Left", "Bottom"):
        setattr(view, f"{axis}AxisTitleFontSize", 24)
        setattr(view, f"{axis}AxisLabelFontSize", 20)
    view.LegendFontSize, view.LegendSymbolWidth = 20, 40
    view.LegendLocation, view.LegendPosition = "Custom", legend_position
    simple.SaveScreenshot(path, view, ImageResolution=PICTURE_SIZE)
    simple.Delete(view)


def chart_pictures(folder, octree, figures):
    view = chart_view(octree, 1)
    title_histogram(view, octree, figures)
    chart_picture(os.path.join(folder, "depth-histogram.png"), view,
                  ("Depth (0 = root)", "Number at this depth"), (160, 800))
    view = chart_view(octree, 2)
    title_costs(view, octree, figures)
    chart_picture(os.path.join(folder, "cost-curves.png"), view,
                  ("Start depth of the search (0 = root)", "Mean cost (nodes examined to find a leaf)"), (680, 710))


# ---- The two ways to run it -----------------------------------------------------------------------------------------

def show(path):
    """In ParaView: the octree at the left, the two charts above each other at the right."""
    with quiet():
        source = read_points(path)
        octree = apply_octree(source, path)
    figures = field_data(octree)
    view = simple.GetActiveViewOrCreate("RenderView")
    layout = simple.GetLayout(view)
    layout.SplitHorizontal(0, 0.55)
    layout.SplitVertical(2, 0.5)
    stage = make_stage(source, path, octree, figures)
    set_colors("Depth", *find_depths(octree), may_change=True)
    octree.IncludeEmptyLeaves = int(stage.from_above)
    shown = show_occupied(octree, view, figures, shows_edges(figures, view.ViewSize[1]))
    shown.SetScalarBarVisibility(view, True)
    stage.look(view, 0.4, 0.75 if stage.flat else 0.35)
    layout.AssignView(5, chart_view(octree, 1))
    layout.AssignView(6, chart_view(octree, 2))
    simple.SetActiveSource(octree)
    simple.SetActiveView(view)


def write_all(path, folder):
    """In batch: pictures and tables into the folder, all of them or none."""
    with quiet():
        source = read_points(path)
        octree = apply_octree(source, path)
        figures = field_data(octree)
        os.makedirs(folder, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder) as unfinished:
            # Charts first: after pictures of layouts, ParaView leaves traces of earlier text in them.
            chart_pictures(unfinished, octree, figures)
            stage = make_stage(source, path, octree, figures)
            octree_pictures(unfinished, stage, source, octree, figures)
            write_csv(os.path.join(unfinished, "depth-histogram.csv"), table(octree, 1))
            write_csv(os.path.join(unfinished, "cost-curves.csv"), table(octree, 2))
            for name in os.listdir(unfinished):
                os.replace(os.path.join(unfinished, name), os.path.join(folder, name))
    print(summary(path, figures))


def parse_arguments():
    parser = argparse.ArgumentParser(prog="demo.py", description=__doc__.splitlines()[0])
    parser.add_argument("--batch", action="store_true", help="write pictures and tables instead of showing them")
    parser.add_argument("--plugin", metavar="FILE", help="the plugin's library, where it is not loaded yet")
    parser.add_argument("--output", metavar="DIR", default=".", help="where to write; default: the current directory")
    return parser.parse_args()


def load_plugin(path):
    try:
        simple.LoadPlugin(path, remote=False, ns=vars(simple))
    except RuntimeError:
        raise DemoError(f"cannot load the plugin {path}; build it first") from None


def main():
    arguments = parse_arguments()
    path = os.environ.get("HASHEDOCTREE_FILE", "")
    try:
        if arguments.plugin:
            with quiet():
                load_plugin(arguments.plugin)
        if arguments.batch:
            for number in (signal.SIGINT, signal.SIGTERM):  # pvpython heeds neither by itself
                signal.signal(number, stop)
            write_all(path, arguments.output)
        else:
            show(path)
    except (DemoError, OSError) as error:
        os.write(2, f"demo: {error}\n".encode(errors="surrogateescape"))  # in ParaView's window sys.stderr is a widget
        os._exit(1)  # ParaView itself would go on, and leave with 0
    except SystemExit as stopped:
        os._exit(stopped.code)  # in the middle of a picture ParaView would fail to end


if __name__ == "__main__":
    main()
