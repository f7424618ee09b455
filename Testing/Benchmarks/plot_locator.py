# SPDX-License-Identifier: BSD-3-Clause
"""plot_locator.py LOCATOR.json DIRECTORY

Draws what BenchmarkPointLocator measured: for each data set and number of threads one PNG in the directory,
with one picture for each operation and kind of position: the median time of each peer against the number of
points, or, where there is one number only, beside the others' times.
"""
import json
import os
import statistics
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator, NullFormatter

OPERATIONS = {
    "build": "Build",
    "closest": "Closest point",
    "closest8": "8 closest points",
    "closest32": "32 closest points",
    "closest100": "100 closest points",
    "radius": "Points within a radius",
}
QUERIES = {
    "near": "near the points",
    "uniform": "uniform in the box",
    "ordered": "near, in order",
    "points": "at the points",
    "above": "far above",
    "-": "",
}
# The colours can be told apart by the colour-blind, and the marks without colours; ours are solid, the others dashed.
PEERS = {
    "local": ("ours, local", "#009E73", "^-"),
    "median": ("ours, median", "#0072B2", "o-"),
    "root": ("ours, root", "#56B4E9", "s-"),
    "static": ("vtkStaticPointLocator", "#D55E00", "s--"),
    "octree": ("vtkOctreePointLocator", "#CC79A7", "^--"),
    "kdtree": ("vtkKdTreePointLocator", "#E69F00", "v--"),
    "nanoflann": ("nanoflann", "#000000", "D--"),
}


def fail(message):
    sys.exit(f"plot_locator: {message}")


def load_medians(path):
    """Median seconds by (data, threads), then by (operation, queries), then by peer: {points: seconds}."""
    try:
        with open(path, encoding="utf-8") as file:
            runs = json.load(file)["benchmarks"]
    except (OSError, ValueError, KeyError) as error:
        fail(f"cannot read {path}: {error}")
    times = defaultdict(list)
    for run in runs:
        if run["run_type"] == "iteration" and not run.get("error_occurred"):
            times[tuple(run["run_name"].split("/")[:6])].append(run["seconds_each"])
    figures = defaultdict(lambda: defaultdict(lambda: defaultdict(dict)))
    for (data, points, queries, operation, threads, peer), seconds in times.items():
        figures[data, int(threads)][operation, queries][peer][int(points)] = statistics.median(seconds)
    return figures


def draw_times(axes, operation, peers, get_places, marker_size):
    """Draws the times of each peer, in milliseconds for builds and in microseconds for queries.
    get_places(times, row, points) gives the x and y of its marks; row counts the peers."""
    factor = 1e3 if operation == "build" else 1e6
    for row, name in enumerate(name for name in PEERS if name in peers):
        label, colour, style = PEERS[name]
        points = sorted(peers[name])
        # The median is the default, and seen where others lie on it.
        axes.plot(*get_places([factor * peers[name][n] for n in points], row, points), style, color=colour,
                  label=label, markersize=marker_size,
                  markerfacecolor="white" if name in ("local", "root") else colour,
                  linewidth=2 if name == "median" else 1.5, zorder=3 if name == "median" else 2)


def label_times(axis, operation):
    lower, upper = axis.get_view_interval()
    axis.set_label_text(f"time per {'build [ms]' if operation == 'build' else 'query [µs]'}")
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if upper < 300 * lower else (1,)))
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter(NullFormatter())


def draw_curves(axes, operation, peers):
    draw_times(axes, operation, peers, lambda times, row, points: (points, times), 4)
    axes.set(xscale="log", yscale="log", xlabel="points")
    label_times(axes.yaxis, operation)


def draw_rows(axes, operation, peers):
    draw_times(axes, operation, peers, lambda times, row, points: (times, [row]), 7)
    labels = [line.get_label() for line in axes.get_lines()]
    axes.set(xscale="log", ylim=(len(labels) - 0.5, -0.5))
    axes.set_yticks(range(len(labels)), labels, fontsize=9)
    label_times(axes.xaxis, operation)


def draw_figure(data, threads, pictures, directory):
    order = [(operation, queries) for operation in OPERATIONS for queries in QUERIES
             if (operation, queries) in pictures]
    sizes = {points for peers in pictures.values() for times in peers.values() for points in times}
    has_one_size = len(sizes) == 1
    # The legend has a strip below the pictures; rows have their names beside them.
    draw, panel_width, panel_height, legend = (draw_rows, 5.2, 2.4, 0) if has_one_size else (draw_curves, 4.2, 3.3, 0.8)
    columns = min(3, len(order))
    rows = -(-len(order) // columns)
    title = 0.35
    height = panel_height * rows + title + legend
    figure, grid = plt.subplots(rows, columns, figsize=(max(7.5, panel_width * columns), height), squeeze=False)
    for axes, (operation, queries) in zip(grid.flat, order):
        draw(axes, operation, pictures[operation, queries])
        axes.set_title(", ".join(filter(None, (OPERATIONS[operation], QUERIES[queries]))), fontsize=11)
        axes.grid(True, which="major", alpha=0.4)
    for axes in grid.flat[len(order):]:
        axes.set_visible(False)
    of_points = f", {next(iter(sizes)):,} points" if has_one_size else ""
    figure.suptitle(f"Point locators on {data}{of_points}, {threads} thread{'s' if threads > 1 else ''} (medians)",
                    y=1 - 0.3 * title / height)
    figure.tight_layout(rect=(0, legend / height, 1, 1))
    if legend:
        handles = {line.get_label(): line for axes in grid.flat[:len(order)] for line in axes.get_lines()}
        figure.legend(handles.values(), handles.keys(), loc="lower center", ncol=min(columns + 1, 4), fontsize=9)
    path = os.path.join(directory, f"locator-{data}-{threads}.png")
    figure.savefig(path, dpi=110)
    plt.close(figure)
    return path


def main(arguments):
    if len(arguments) != 2:
        fail("usage: plot_locator.py LOCATOR.json DIRECTORY")
    figures = load_medians(arguments[0])
    if not figures:
        fail(f"{arguments[0]} holds no times")
    for (data, threads), pictures in sorted(figures.items()):
        print(draw_figure(data, threads, pictures, arguments[1]))


main(sys.argv[1:])
