# SPDX-License-Identifier: BSD-3-Clause
"""The leaves around a leaf, coloured by case as in the paper's Figures 5 and 6: those that touch it,
and those in a radius. The points lie in a plane, so that the tree is a quadtree; it is seen from
below."""
import os
import sys

import octreetesting
from matplotlib.colors import to_rgb
from paraview import simple

sys.path.insert(0, os.path.join(octreetesting.argument("-D"), "..", "Testing", "Benchmarks"))
from demo import white_view
from paper_scenes import CASES

GREY, DARK, WHITE = [0.6] * 3, [0.15] * 3, [1.0] * 3
NAMES = ["Query leaf", "Same depth", "Descended", "Above"]  # of the cases
QUERY, RADIUS = [-0.68, 0.45, 0.0], 0.3  # where all cases occur
view = white_view(1000, 430)

colors = simple.GetColorTransferFunction("Case")
colors.InterpretValuesAsCategories = 1
colors.Annotations = [text for case, name in enumerate(NAMES) for text in (str(case), name)]
colors.IndexedColors = [part for _, color in CASES.values() for part in to_rgb(color)]


def show(source, kind, place):
    """Shows a source moved to a place. What is lower is nearer to the eye, which is below."""
    moved = simple.Transform(Input=source)
    moved.Transform.Translate = place
    shown = simple.Show(moved, view)
    shown.SetRepresentationType(kind)
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    return shown


# As many points on each ring: the nearer to the middle, the denser.
disk = simple.Disk(InnerRadius=0.05, OuterRadius=1.0, RadialResolution=7,
                   CircumferentialResolution=24)
for mode, place in (("Adjacent", 1.1), ("InRadius", -1.1)):
    octree = show(simple.HashedOctree(Input=disk, IncludeEmptyLeaves=1), "Surface With Edges",
                  [place, 0.0, 0.0])
    octree.AmbientColor, octree.EdgeColor = WHITE, GREY

    source = simple.HashedOctreeNeighbors(Input=disk, IncludeEmptyLeaves=1, SearchMode=mode,
                                          Center=QUERY, Radius=RADIUS)
    neighbors = simple.Show(source, view)
    assert neighbors.Representation == "Wireframe", neighbors.Representation
    assert list(neighbors.ColorArrayName) == ["CELLS", "Case"], neighbors.ColorArrayName
    simple.Hide(source, view)
    neighbors = show(source, "Surface With Edges", [place, 0.0, -0.01])
    simple.ColorBy(neighbors, ("CELLS", "Case"))
    neighbors.EdgeColor = DARK

    points = show(disk, "Points", [place, 0.0, -0.02])
    points.AmbientColor, points.PointSize = DARK, 4.0

# The ball is around the center of the query leaf, not around the position.
source.UpdatePipeline()
bounds = octreetesting.fetch(source, 0).GetCell(0).GetBounds()
center = [(bounds[2 * axis] + bounds[2 * axis + 1]) / 2 for axis in range(3)]
ball = show(simple.Disk(InnerRadius=0.98 * RADIUS, OuterRadius=RADIUS,
                        CircumferentialResolution=90), "Surface",
            [center[0] - 1.1, center[1], -0.03])
ball.AmbientColor = DARK

legend = simple.GetScalarBar(colors, view)
legend.Title, legend.ComponentTitle = "Case", ""
legend.TitleColor = legend.LabelColor = DARK
legend.Visibility = 1
simple.ResetCamera(view)
view.CameraParallelProjection = 1
view.CameraParallelScale = 1.1
view.CameraPosition = [-0.4, 0.0, -9.0]
view.CameraFocalPoint = [-0.4, 0.0, 0.0]
view.CameraViewUp = [0.0, 1.0, 0.0]
simple.Render(view)
octreetesting.compare_with_baseline(view)
