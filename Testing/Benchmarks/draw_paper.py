# SPDX-License-Identifier: BSD-3-Clause
"""Draws Figures 1, 5, 6, 7 and 8 of the paper from what the filters of the plugin put out.

pvpython draw_paper.py --plugin HashedOctree.so --points FOLDER --output DIR --markdown FILE

FOLDER holds the point sets of Data/make_point_sets.py. Writes a picture for each figure into DIR, and appends them to
FILE, each with a caption. Needs a display.
"""
import argparse
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.patches import Patch
from paper_charts import DARK, draw_costs, draw_density, draw_depths, draw_start_depths, get_minimisers
from paper_scenes import (CASES, RADIUS_OF_SIDE, PointSet, Query, demo, octree_scene, plane_scene, set_case_colors,
                          set_depth_colors, space_scene)

# The point sets that stand for those of the paper's figures.
SCAN, STADIUM = ("scan_35k", "Bunny"), ("stadium_10k", "Maracanã")
SIZES = {1: (1800, 620), 5: (1500, 800), 6: (1500, 800), 7: (1800, 620), 8: (1500, 620)}  # in pixels
PIXELS_PER_INCH = 100


def new_figure(number, columns, **options):
    """A figure of one row, and its axes."""
    size = [pixels / PIXELS_PER_INCH for pixels in SIZES[number]]
    figure, axes = plt.subplots(1, columns, figsize=size, dpi=PIXELS_PER_INCH, layout="constrained", **options)
    figure.get_layout_engine().set(w_pad=0.15, h_pad=0.1, wspace=0.03)
    return figure, axes


def show_scene(axes, scene, title):
    axes.imshow(scene)
    axes.set_axis_off()
    axes.set_title(title)


def describe_octree(point_set):
    return f"octree of {point_set}, one point per leaf"


def draw_figure_1(scan):
    colors = set_depth_colors(scan)
    figure, axes = new_figure(1, 3, width_ratios=[1, 1.1, 1.1])
    show_scene(axes[0], octree_scene(scan), "Leaves that hold points, by depth")
    draw_depths(axes[1], scan, colors)
    draw_start_depths(axes[2], scan)
    return figure, "Why start at the root?", (
        f"The {describe_octree(scan)}. Left: output Octree of vtkHashedOctreeFilter, coloured by its array Depth. "
        "Middle: output Depth Histogram, columns Leaves and EmptyLeaves. Right: output Cost Curves, column CostLeaves, "
        "with the three start depths that the paper marks: the root, the median depth of the leaves, and the deepest "
        'depth (E10: "zero or l_max" are two different ends).')


def draw_searches(number, query, scene):
    """The adjacent and the in-radius search side by side, and what the filter counted."""
    set_case_colors()
    figure, axes = new_figure(number, 2)
    show_scene(axes[0], scene(query, query.adjacent), "Adjacent search")
    show_scene(axes[1], scene(query, query.in_radius), f"In-radius search, radius {RADIUS_OF_SIDE:g} sides of the leaf")
    figure.legend(handles=[Patch(facecolor=color, edgecolor=DARK, label=text) for text, color in CASES.values()],
                  loc="lower center", ncol=len(CASES), frameon=False)
    figure.get_layout_engine().set(rect=(0, 0.06, 1, 0.94))  # above the legend
    return figure


def count_cases(search):
    figures = demo.field_data(search)
    return (f"{figures['NumberOfSameDepthNeighbors']:.0f} leaves of case 1, "
            f"{figures['NumberOfDescendedNeighbors']:.0f} of case 2 and "
            f"{figures['NumberOfAboveNeighbors']:.0f} of case 3, and examines {figures['ExaminedNodes']:.0f} nodes")


def draw_figure_5(query):
    return draw_searches(5, query, plane_scene), "Searches for neighbours, in a plane", (
        "Outputs of vtkHashedOctreeNeighborsFilter, coloured by the array Case, and of vtkHashedOctreeFilter (grey "
        f"lines), empty leaves included: the {describe_octree(query.point_set)}. A plane through the query leaf cuts "
        "the leaves and the ball (circle); dots are the points of the leaves that it cuts.")


def draw_figure_6(query):
    return draw_searches(6, query, space_scene), "Searches for neighbours, in space", (
        "The searches of Figure 5 as they are in space. Lines are the edges of the leaves, in which boxes of 0.6 of "
        "their sides are drawn, so that those behind are seen. The adjacent search finds "
        f"{count_cases(query.adjacent)}; the in-radius search finds {count_cases(query.in_radius)}.")


def draw_figure_7(scan, stadium):
    figure, axes = new_figure(7, 3, width_ratios=[1.1, 1, 1.1])
    draw_density(axes[0], scan, {})
    colors = set_depth_colors(stadium)
    show_scene(axes[1], octree_scene(stadium), f"Leaves that hold points, by depth, {stadium.name}")
    draw_density(axes[2], stadium, colors)
    return figure, "The density of depths", (
        "Left, as in the paper: the share of the leaves at each depth as a density, a parabola of area p_l over "
        f"[l, l + 1]; {describe_octree(scan)}. Middle and right: the same for points of varying density, the "
        f"{describe_octree(stadium)}, whose deepest leaves are too small to be seen. Outputs Depth Histogram (column "
        "Leaves) and Octree (coloured by the array Depth) of vtkHashedOctreeFilter.")


def draw_figure_8(scan):
    figure, axes = new_figure(8, 2)
    draw_costs(axes[0], scan, zoomed=False)
    draw_costs(axes[1], scan, zoomed=True)
    discrete, continuous = get_minimisers(scan)
    return figure, "Discrete and continuous cost", (
        f"The {describe_octree(scan)}: output Cost Curves of vtkHashedOctreeFilter, columns CostLeaves and "
        "ContinuousLeaves, and between the latter's values what the density of Figure 7 integrates to. The discrete "
        f"minimiser is {discrete}, the continuous one {continuous:.2f}: its integer part is {int(continuous)}, rounded "
        f"it would be {round(continuous)} (E9). The continuous cost at l + 1/2 is the discrete cost at l plus 3/16 of "
        "the share of depth l, so it does not interpolate (E8).")


def draw_figures(points):
    """Number, figure, title and caption of each."""
    scan, stadium = PointSet(points, *SCAN), PointSet(points, *STADIUM)
    query = Query(scan)
    yield 1, *draw_figure_1(scan)
    yield 5, *draw_figure_5(query)
    yield 6, *draw_figure_6(query)
    yield 7, *draw_figure_7(scan, stadium)
    yield 8, *draw_figure_8(scan)


def write_figures(points, output):
    """Writes all pictures into a folder; returns the Markdown that shows them, for a file in the same folder."""
    markdown = ["", "## Figures", "", "Drawn from the outputs of the filters by Testing/Benchmarks/draw_paper.py. "
                "(E...) are errors of the paper's text, see README.md.", ""]
    for number, figure, title, caption in draw_figures(points):
        name = f"paper-figure-{number}.png"
        figure.savefig(os.path.join(output, name))
        plt.close(figure)
        markdown += [f"### Figure {number}: {title}", "", f"![{title}]({name})", "", caption, ""]
    return "\n".join(markdown)


def main():
    parser = argparse.ArgumentParser(prog="draw_paper.py", description=__doc__.splitlines()[0])
    for option, text in (("--plugin", "the plugin's library"), ("--points", "folder of the point sets"),
                         ("--output", "folder for the pictures"), ("--markdown", "file that they are appended to")):
        parser.add_argument(option, required=True, help=text)
    arguments = parser.parse_args()
    try:
        with demo.quiet():
            demo.load_plugin(arguments.plugin)
            markdown = write_figures(arguments.points, arguments.output)
        with open(arguments.markdown, "a", encoding="utf-8") as file:
            file.write(markdown)
    except (demo.DemoError, OSError) as error:
        sys.exit(f"draw_paper: {error}")


if __name__ == "__main__":
    main()
