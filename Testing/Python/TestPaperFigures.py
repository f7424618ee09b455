# SPDX-License-Identifier: BSD-3-Clause
"""The figures of the paper are drawn, from small sets of points: all are there, none is blank."""
import os
import sys

import numpy as np
import octreetesting

sys.path.insert(0, os.path.join(octreetesting.argument("-D"), "..", "Testing", "Benchmarks"))
import draw_paper
import matplotlib.pyplot as plt
import paper_scenes
from paper_charts import draw_start_depths, get_continuous_cost, get_minimisers

paper_scenes.SIDE, paper_scenes.QUERIES_TRIED = 400, 60  # enough to see that something is drawn
folder = octreetesting.argument("-T")
rng = np.random.default_rng(2008)
sphere = rng.standard_normal((900, 3))
sphere /= np.linalg.norm(sphere, axis=1, keepdims=True)
for (name, _), points in ((draw_paper.SCAN, sphere), (draw_paper.STADIUM, rng.random((300, 3)) ** 8)):
    points.astype("<f4").tofile(os.path.join(folder, f"{name}.xyz"))

markdown = draw_paper.write_figures(folder, folder)
for number, (width, height) in draw_paper.SIZES.items():
    name = f"paper-figure-{number}.png"
    picture = plt.imread(os.path.join(folder, name))[:, :, :3]
    assert picture.shape == (height, width, 3), (name, picture.shape)
    # Each of the panels has something in it, and more than grey text.
    for panel in np.array_split(picture, 3 if number in (1, 7) else 2, axis=1):
        drawn = (panel < 0.99).any(axis=2).mean()
        assert 0.01 < drawn < 0.9, (name, drawn)
    colored = (np.ptp(picture, axis=2) > 0.2).mean()
    assert colored > 0.001, (name, colored)
    assert f"### Figure {number}: " in markdown and f"]({name})" in markdown, name

# Figure 1 marks the root, the median and the deepest depth, each at its cost.
scan = draw_paper.PointSet(folder, *draw_paper.SCAN)
axes = plt.figure().subplots()
draw_start_depths(axes, scan)
marks = {line.get_label().split(":")[0]: (line.get_xdata()[0], line.get_ydata()[0]) for line in axes.get_lines()[1:]}
depths = np.repeat(np.arange(len(scan.histogram["Leaves"])), scan.histogram["Leaves"])
expected = {"top-down": 0, "statistical": np.sort(depths)[(len(depths) - 1) // 2], "bottom-up": depths.max()}
assert marks.keys() == expected.keys(), marks
for name, depth in expected.items():
    assert marks[name][0] == depth, (name, marks[name], depth)
    assert np.isclose(marks[name][1], (1 + np.abs(depths - depth)).mean(), rtol=1e-12), (name, marks[name])

# What is drawn between the values of the filter goes through them, and E9 holds.
for name, paper_name in (draw_paper.SCAN, draw_paper.STADIUM):
    point_set = draw_paper.PointSet(folder, name, paper_name)
    drawn = get_continuous_cost(point_set.depth_shares(), point_set.costs["StartDepth"] + 0.5)
    assert np.allclose(drawn, point_set.costs["ContinuousLeaves"], rtol=1e-12), name
    discrete, continuous = get_minimisers(point_set)
    assert discrete == int(continuous) == point_set.figures["StartDepthLeaves"], (discrete, continuous)

# The searches that are shown have neighbours of each case, and none that hides the others.
query = draw_paper.Query(draw_paper.PointSet(folder, *draw_paper.SCAN))
figures = draw_paper.demo.field_data(query.adjacent)
assert min(count for name, count in figures.items() if name.endswith("Neighbors")) > 0, figures
cells = paper_scenes.servermanager.Fetch(query.adjacent)
sides = [cells.GetCell(i).GetBounds()[1] - cells.GetCell(i).GetBounds()[0] for i in range(cells.GetNumberOfCells())]
assert max(sides) < 2.5 * query.side, (max(sides), query.side)

try:
    draw_paper.write_figures(os.path.join(folder, "no such folder"), folder)
    sys.exit("Point sets that are not there are drawn.")
except draw_paper.demo.DemoError as error:
    assert "make_point_sets.py" in str(error), error
