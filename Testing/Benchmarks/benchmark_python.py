# SPDX-License-Identifier: BSD-3-Clause
"""The locator from Python beside scipy.spatial.cKDTree: NumPy arrays in and out, one thread.

Run by Testing/bench.sh python [points [positions [repetitions]]]. The two take turns; medians. The
answers must be the same. Prints a Markdown table.
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


def measure(function):
    start = time.perf_counter()
    result = function()
    return time.perf_counter() - start, result


def build_locator(points):
    locator = vtkHashedOctreePointLocator()
    locator.SetDataSet(make_points(points))
    locator.BuildLocator()
    return locator


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
    print("| coordinates | build | ratio | closest | ratio | 8 closest | ratio |")
    print("|---|---|---|---|---|---|---|")
    for dtype in (numpy.float32, numpy.float64):
        points = random.random((arguments.points, 3)).astype(dtype)
        positions = random.random((arguments.positions, 3)).astype(dtype)
        times = {}
        for _ in range(arguments.repetitions):
            results = {}
            for name in ("ours", "theirs"):
                is_ours = name == "ours"
                seconds, index = measure(
                    lambda: build_locator(points) if is_ours else cKDTree(points))
                times.setdefault(("build", name), []).append(seconds)
                for count in (1, MOST_CLOSEST):
                    if not is_ours:
                        seconds, (_, ids) = measure(lambda: index.query(positions, count))
                    elif count == 1:
                        seconds, (ids, _) = measure(lambda: find_closest_points(index, positions))
                    else:
                        seconds, (ids, _) = measure(
                            lambda: find_closest_n_points(index, count, positions))
                    times.setdefault((count, name), []).append(seconds)
                    results[count, name] = ids
            for count in (1, MOST_CLOSEST):
                # Random points: no two are equally close to a position.
                if not (results[count, "ours"] == results[count, "theirs"]).all():
                    sys.exit(f"error: {count} closest: the answers differ")
        row = []
        for key, unit, factor in (("build", "ms", 1e3), (1, "ns", 1e9 / arguments.positions),
                                  (MOST_CLOSEST, "ns", 1e9 / arguments.positions)):
            ours, theirs = (statistics.median(times[key, name]) for name in ("ours", "theirs"))
            row += [f"{ours * factor:.0f} {unit}", f"{theirs / ours:.2f}"]
        print(f"| {dtype.__name__} | " + " | ".join(row) + " |", flush=True)
    print(f"\n{arguments.points} uniform points in a cube, {arguments.positions} positions, one thread, "
          f"medians of {arguments.repetitions}; ratio: cKDTree's time divided by ours.")


main()
