# SPDX-License-Identifier: BSD-3-Clause
"""plot_locator.py LOCATOR.json DIRECTORY

Draws what BenchmarkPointLocator measured: for each data set and number of threads one PNG in the directory,
with the median time of each peer against the number of points, one picture for each operation and kind of
position.
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


def spans_little(axes):
    lower, upper = axes.get_ylim()
    return upper < 300 * lower


def draw_picture(axes, operation, queries, peers):
    # Microseconds for queries; builds take longer.
    unit, factor = ("ms", 1e3) if operation == "build" else ("µs", 1e6)
    for name, (label, colour, style) in PEERS.items():
        if name in peers:
            points = sorted(peers[name])
            # The median is the default, and seen where others lie on it.
            axes.loglog(points, [factor * peers[name][n] for n in points], style, color=colour, label=label,
                        markersize=4, markerfacecolor="white" if name in ("local", "root") else colour,
                        linewidth=2 if name == "median" else 1.5, zorder=3 if name == "median" else 2)
    axes.set_title(", ".join(filter(None, (OPERATIONS[operation], QUERIES[queries]))), fontsize=11)
    axes.set_xlabel("points")
    axes.set_ylabel(f"time per {'build' if operation == 'build' else 'query'} [{unit}]")
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if spans_little(axes) else (1,)))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.grid(True, which="major", alpha=0.4)


def draw_figure(data, threads, pictures, directory):
    order = [(operation, queries) for operation in OPERATIONS for queries in QUERIES
             if (operation, queries) in pictures]
    columns = min(3, len(order))
    rows = -(-len(order) // columns)
    # Strips of their own: the title above the pictures, the legend below.
    title, legend = 0.35, 0.8
    height = 3.3 * rows + title + legend
    figure, grid = plt.subplots(rows, columns, figsize=(4.2 * columns, height), squeeze=False)
    for axes, key in zip(grid.flat, order):
        draw_picture(axes, *key, pictures[key])
    for axes in grid.flat[len(order):]:
        axes.set_visible(False)
    handles = {}
    for axes in grid.flat[:len(order)]:
        handles.update((line.get_label(), line) for line in axes.get_lines())
    figure.suptitle(f"Point locators on {data}, {threads} thread{'s' if threads > 1 else ''} (medians)",
                    y=1 - 0.3 * title / height)
    figure.tight_layout(rect=(0, legend / height, 1, 1))
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
