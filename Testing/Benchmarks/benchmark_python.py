# SPDX-License-Identifier: BSD-3-Clause
"""The locator from Python beside scipy.spatial.cKDTree: NumPy arrays in and out, one thread.

Run by Testing/bench.sh python [points [positions [repetitions]]]. The locator and two kinds of cKDTree take
turns; times are medians. The answers must be the same. Prints a Markdown table.
"""
import argparse
import math
import statistics
import sys
import time

import numpy
from hashedoctree import vtkHashedOctreePointLocator
from hashedoctree.arrays import find_closest_n_points, find_closest_points, make_points
from scipy.spatial import cKDTree
from vtkmodules.vtkCommonCore import vtkSMPTools

MOST_CLOSEST = 8
OURS, DEFAULT, QUICK = "ours", "cKDTree", "quickly built cKDTree"


def measure(function):
    start = time.perf_counter()
    result = function()
    return time.perf_counter() - start, result


def build_locator(points):
    locator = vtkHashedOctreePointLocator()
    locator.SetDataSet(make_points(points))
    locator.BuildLocator()
    return locator


def build(name, points):
    if name == OURS:
        return build_locator(points)
    return cKDTree(points) if name == DEFAULT else cKDTree(points, balanced_tree=False, compact_nodes=False)


def find_closest(name, index, count, positions):
    """The ids of the closest points."""
    if name != OURS:
        return index.query(positions, count)[1]
    if count == 1:
        return find_closest_points(index, positions)[0]
    return find_closest_n_points(index, count, positions)[0]


def at_least(smallest):
    def read(text):
        try:
            number = float(text)  # so that 1e6 is a whole number, too
        except ValueError:
            number = math.nan
        if not (number.is_integer() and number >= smallest):
            raise argparse.ArgumentTypeError(f"whole numbers from {smallest} on, not '{text}'")
        return int(number)
    return read


def parse_arguments():
    parser = argparse.ArgumentParser(prog="bench.sh python", description=__doc__.splitlines()[0])
    parser.add_argument("points", nargs="?", type=at_least(MOST_CLOSEST), default=1000000)
    parser.add_argument("positions", nargs="?", type=at_least(1), default=1000000)
    parser.add_argument("repetitions", nargs="?", type=at_least(1), default=5)
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    vtkSMPTools.SetBackend("Sequential")
    random = numpy.random.default_rng(211)
    print("| coordinates | build | cKDTree | quick | closest | cKDTree | quick | 8 closest | cKDTree | quick |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for dtype in (numpy.float32, numpy.float64):
        points = random.random((arguments.points, 3)).astype(dtype)
        positions = random.random((arguments.positions, 3)).astype(dtype)
        times = {}
        for _ in range(arguments.repetitions):
            results = {}
            for name in (OURS, DEFAULT, QUICK):
                seconds, index = measure(lambda: build(name, points))
                times.setdefault(("build", name), []).append(seconds)
                for count in (1, MOST_CLOSEST):
                    seconds, ids = measure(lambda: find_closest(name, index, count, positions))
                    times.setdefault((count, name), []).append(seconds)
                    # Random points: no two are equally close to a position.
                    if not (results.setdefault(count, ids) == ids).all():
                        sys.exit(f"error: {count} closest: the answers differ")
        row = []
        for key, unit, factor in (("build", "ms", 1e3), (1, "ns", 1e9 / arguments.positions),
                                  (MOST_CLOSEST, "ns", 1e9 / arguments.positions)):
            ours, *others = (statistics.median(times[key, name]) for name in (OURS, DEFAULT, QUICK))
            row += [f"{ours * factor:.0f} {unit}"] + [f"{theirs / ours:.2f}" for theirs in others]
        print(f"| {dtype.__name__} | " + " | ".join(row) + " |", flush=True)
    print(f"\n{arguments.points} uniform points in a cube, {arguments.positions} positions, one thread, medians of "
          f"{arguments.repetitions}. Ours, then how many times as long cKDTree takes as it is by default and, quick, "
          "with balanced_tree and compact_nodes off, which builds it sooner.")


main()
