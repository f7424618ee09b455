# SPDX-License-Identifier: BSD-3-Clause
"""What start.sh --batch writes: of files that bring more than points, of tables, and of points that have twins."""
import csv
import os
import signal
import sys

import numpy as np
import octreetesting  # first, which puts the demo on the path
import demo
import matplotlib.pyplot as plt
from vtkmodules.numpy_interface.dataset_adapter import numpyTovtkDataArray
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

folder = octreetesting.argument("-T")
PICTURES = "octree-depth.png", "octree-hitcost.png", "depth-histogram.png", "cost-curves.png"
NO_COLOR = 1.0, 1.0, 0.0  # what ParaView draws where a number has none
TABLES = "depth-histogram.csv", "cost-curves.csv"


def write_points(name, points, *field_data):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpyTovtkDataArray(np.float32(points)))
    for array in field_data:
        data.GetFieldData().AddArray(array)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(os.path.join(folder, name))
    writer.SetInputData(data)
    writer.SetDataModeToBinary()
    assert writer.Write()
    return writer.GetFileName()


def expect_demo(path, leaves):
    """All pictures and tables, with something in each half of a picture, and the number of leaves that hold points."""
    for name in PICTURES + TABLES:
        if os.path.exists(os.path.join(folder, name)):
            os.remove(os.path.join(folder, name))
    demo.write_all(path, folder)
    for name in PICTURES:
        picture = plt.imread(os.path.join(folder, name))[:, :, :3]
        assert picture.shape[1::-1] == demo.PICTURE_SIZE, (name, picture.shape)
        for half in np.array_split(picture[:demo.HALF[1]], 2, axis=1):
            colored = (np.ptp(half, axis=2) > 0.2).mean()
            assert colored > 0.0002, (path, name, colored)
        assert not (abs(picture - NO_COLOR).max(axis=2) < 0.02).any(), (path, name)
    with open(os.path.join(folder, TABLES[0]), newline="") as file:
        rows = list(csv.DictReader(file))
    assert sum(int(row["Leaves"]) - int(row["EmptyLeaves"]) for row in rows) == leaves, rows


words, nothing, many = vtkStringArray(), vtkDoubleArray(), vtkDoubleArray()
for array, name, values in ((words, "Title", ["a"]), (nothing, "Nothing", []), (many, "Many", [1, 2])):
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
random = np.random.default_rng(2301)
expect_demo(write_points("ball.vtp", random.standard_normal((400, 3)), words, nothing, many), 400)

# Hills before a slice, whose large leaves are above all that hold points.
hills = np.column_stack((random.random((3000, 2)), 0.02 * random.random(3000)))
expect_demo(write_points("hills.vtp", hills), 3000)

# A quadtree, seen from above with all of its leaves; not where they are too many.
flat = np.column_stack((random.random((900, 2)), np.zeros(900)))
expect_demo(write_points("flat.vtp", flat), 900)
most_leaves = demo.MOST_LEAVES_SHOWN
demo.MOST_LEAVES_SHOWN = 10
expect_demo(write_points("flat.vtp", flat), 900)
demo.MOST_LEAVES_SHOWN = most_leaves

# Leaves at the last depth, which are far too small to be seen but as dots.
expect_demo(write_points("twins.vtp", np.repeat(random.random((300, 3)), 2, axis=0)), 300)
expect_demo(write_points("flat twins.vtp", np.repeat(flat, 2, axis=0)), 900)

# A scan stands along z, a mesh in the same format along y.
for scene, height_axis in (demo.simple.Sphere(), 1), (demo.simple.PointSource(NumberOfPoints=50), 2):
    ply = os.path.join(folder, "scene.ply")
    demo.simple.SaveData(ply, demo.simple.ExtractSurface(Input=scene))
    assert demo.find_height_axis(demo.read_points(ply), ply) == height_axis, height_axis

# Rows of a table, of whatever columns ParaView or a scanner writes.
for first_line in ("Intensity,X,Y,Z", "a, x, y, z", "x,y,z,Points:3", "Points:0,Points:1,Points:2,a",
                   "Points_0,Points_1,Points_2,a"):
    rows = os.path.join(folder, "rows.csv")
    np.savetxt(rows, random.random((200, 4)), delimiter=",", header=first_line, comments="")
    expect_demo(rows, 200)
# Text as it comes: columns between commas, semicolons, tabs or spaces, with names or without.
for suffix, delimiter, names in ((".xyz", " ", ""), (".txt", "   ", "x   y   z   a"), (".asc", "\t", ""),
                                 (".tsv", "\t", "X\tY\tZ\ta"), (".csv", ";", "z;y;x;a"), (".csv", ",", ""),
                                 (".xyz", " ", "# x y z a"), (".txt", ",", "//X,Y,Z,a"),
                                 (".csv", ",", "\ufeffx,y,z,a")):
    text = os.path.join(folder, "text" + suffix)
    columns = 100.0 * random.random((200, 4)) - 50.0
    np.savetxt(text, columns, delimiter=delimiter, header=names, comments="", encoding="utf-8")
    points = vtk_to_numpy(demo.servermanager.Fetch(demo.read_points(text)).GetPoints().GetData())
    assert np.allclose(points, columns[:, [2, 1, 0] if names.startswith("z") else [0, 1, 2]], rtol=1e-6), text
np.savetxt(rows, random.random((200, 4)), delimiter=",", header="u,v,w,x", comments="")
# The window: a quadtree is seen from above with all of its leaves; charts follow the octree, whatever becomes of it.
for name, points in (("flat.vtp", flat), ("hills.vtp", hills)):
    earlier = demo.simple.GetViews()
    demo.simple.RemoveViewsAndLayouts()
    demo.show(write_points(name, points))
    octree = demo.simple.GetActiveSource()
    assert octree.GetXMLName() == "HashedOctree", octree.GetXMLName()
    assert octree.IncludeEmptyLeaves == (name == "flat.vtp"), name
    view = demo.simple.GetActiveView()
    towards = np.subtract(view.CameraFocalPoint, view.CameraPosition)
    assert (abs(towards[2]) == np.linalg.norm(towards)) == (name == "flat.vtp"), towards
    labels = list(demo.simple.GetColorTransferFunction("Depth").Annotations)
    colors = np.reshape(demo.simple.GetColorTransferFunction("Depth").IndexedColors, (-1, 3))
    depths = demo.table(octree, 1)["Depth"][demo.table(octree, 1)["Leaves"] > 0]
    of_leaves = colors[[labels.index(str(depth)) // 2 for depth in depths]]
    assert len(np.unique(of_leaves, axis=0)) == len(depths), "each depth with leaves has its colour"
charts = [view for view in demo.simple.GetViews() if view.GetXMLName() != "RenderView" and view not in earlier]
assert len(charts) == 2, charts
for chart in charts:
    assert not chart.ChartTitle and not chart.LeftAxisUseCustomRange and not chart.BottomAxisUseCustomRange
octree.MaxPointsPerLeaf = 100
demo.simple.RenderAllViews()

assert demo.human_bytes(1023) == "1,023 bytes"
assert demo.human_bytes(1536) == "1.5 KiB (1,536 bytes)"
assert demo.human_bytes(2**20 - 1) == "1.0 MiB (1,048,575 bytes)"



def expect_refused(path, reason):
    try:
        demo.write_all(path, folder)
        sys.exit(f"{path} is shown, which should be refused since it {reason}.")
    except demo.DemoError as error:
        assert reason in str(error), error


expect_refused(rows, "without x, y and z")
expect_refused(os.path.join(folder, "missing.vtp"), "does not exist")
for text, reason in (("x,y,z\n", "without rows"), ("x,y,z\n1,2,3\n4,5,n/a\n", "column z of"),
                     ("x,y,z\n1,2,3\n4,5\n", "ends early"), ("x,y,z,\n1,2,3,\n", "without a name")):
    with open(rows, "w", encoding="ascii") as file:
        file.write(text)
    expect_refused(rows, reason)

odd = os.path.join(folder, "not UTF-8 \udcff.vtp")
os.link(os.path.join(folder, "hills.vtp"), odd)
expect_refused(odd, "rename it")
os.remove(odd)

# Stopped while it writes, it leaves what was there.
before = sorted(os.listdir(folder))
signal.signal(signal.SIGTERM, demo.stop)
demo.octree_pictures = lambda *_: signal.raise_signal(signal.SIGTERM)  # those of the charts are written by then
try:
    demo.write_all(os.path.join(folder, "hills.vtp"), folder)
    sys.exit("Nothing stops it.")
except SystemExit as stopped:
    assert stopped.code == 128 + signal.SIGTERM, stopped.code
assert sorted(os.listdir(folder)) == before, os.listdir(folder)
