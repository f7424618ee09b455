# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the locator's benchmark, of invented times."""
import json
import os
import subprocess
import sys

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.image import imread


def argument(option):
    return sys.argv[sys.argv.index(option) + 1]


SCRIPT = os.path.join(argument("-D"), "..", "Testing", "Benchmarks", "plot_locator.py")
COLOURS = {"median": "#0072B2", "static": "#D55E00", "kdtree": "#E69F00"}
folder = argument("-T")
for name in os.listdir(folder):
    os.remove(os.path.join(folder, name))


def write(runs):
    path = os.path.join(folder, "locator.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"benchmarks": runs}, file)
    return path


def draw(path):
    """The files that the script names, its errors and its exit status."""
    done = subprocess.run([sys.executable, "-B", SCRIPT, path, folder], capture_output=True, text=True, check=False)
    return done.stdout.splitlines(), done.stderr, done.returncode


def make_runs(data, sizes, peers, threads=1):
    return [{"run_type": "iteration", "seconds_each": 1e-9 * size * (1 + place) * (1 + repetition),
             "run_name": f"{data}/{size}/{queries}/{operation}/{threads}/{peer}/iterations:1/manual_time"}
            for size in sizes for place, peer in enumerate(peers) for repetition in range(3)
            for operation, queries in [("build", "-"), ("closest", "near"), ("radius", "uniform")]]


def find_colour(picture, peer):
    """Rows and columns of the picture in which the peer's colour is."""
    return np.nonzero(np.abs(picture[..., :3] - to_rgb(COLOURS[peer])).max(axis=-1) < 0.01)


def has_colour(picture, peer):
    return find_colour(picture, peer)[0].size > 0


# A picture for each data set and number of threads, with the peers that were measured. One that failed has no time.
failed = make_runs("my cube", [1000], ["kdtree"])
for run in failed:
    run.update(error_occurred=True, seconds_each=1.0)
paths, errors, status = draw(write(make_runs("my cube", [1000, 10000], ["median", "static"]) + failed +
                                   make_runs("my cube", [1000, 10000], ["median"], threads=2)))
assert status == 0 and not errors, errors
assert [os.path.basename(path) for path in paths] == ["locator-my cube-1.png", "locator-my cube-2.png"], paths
one, two = (imread(path) for path in paths)
assert has_colour(one, "median") and has_colour(one, "static") and not has_colour(one, "kdtree")
assert has_colour(two, "median") and not has_colour(two, "static")
# Curves go up with the number of points, the slower one above.
rows, columns = find_colour(one, "median")
third = one.shape[1] // 3
first = columns < third
assert rows[first][columns[first].argmin()] > rows[first][columns[first].argmax()] + 50
static_rows, static_columns = find_colour(one, "static")
assert static_rows[static_columns < third].min() < rows[first].min()

# With one number of points a row for each peer, the slower one to the right.
paths, errors, status = draw(write(make_runs("scan", [5000], ["median", "kdtree"])))
assert status == 0 and not errors, errors
picture = imread(paths[0])
rows, columns = find_colour(picture, "median")
other_rows, other_columns = find_colour(picture, "kdtree")
third = picture.shape[1] // 3
assert columns[columns < third].max() < other_columns[other_columns < third].min()
assert rows.max() < other_rows.min()
assert picture.shape[0] < one.shape[0], "rows take less room than curves"

# No times, and no file.
for path, text in ((write([]), "holds no times"), (os.path.join(folder, "none.json"), "cannot read")):
    paths, errors, status = draw(path)
    assert status == 1 and not paths and errors.startswith("plot_locator: ") and text in errors, errors
