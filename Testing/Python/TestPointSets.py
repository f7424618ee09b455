# SPDX-License-Identifier: BSD-3-Clause
"""The point sets of the paper's experiments: their sizes and kinds, the same in every run; those that take long by
their generators, with few points."""
import os
import subprocess
import sys
import zlib

import numpy as np


def argument(option):
    return sys.argv[sys.argv.index(option) + 1]


SCRIPT = os.path.join(argument("-D"), "make_point_sets.py")
sys.path.insert(0, argument("-D"))
import make_point_sets as sets  # noqa: E402
COUNTS = {"sphere_1k": 900, "scan_35k": 35_000, "stadium_10k": 10_000, "scan_100k": 100_000, "gyroid_100k": 100_000,
          "csg_82k": 82_000, "volcano_133k": 133_000}
folder = argument("-T")


def path(name):
    return os.path.join(folder, f"{name}.xyz")


def make(script=SCRIPT):
    subprocess.run([sys.executable, script, folder, "--quick"], check=True)


for name in os.listdir(folder):
    os.remove(os.path.join(folder, name))
make()
assert sorted(os.listdir(folder)) == sorted(["made_by.sha256"] + [f"{name}.xyz" for name in COUNTS]), \
    os.listdir(folder)
points = {name: np.fromfile(path(name), "<f4").reshape(-1, 3) for name in COUNTS}
for name, count in COUNTS.items():
    assert len(points[name]) == count and np.isfinite(points[name]).all(), name

# Surfaces: a sphere, and a part whose faces lie at known places.
assert np.allclose(np.linalg.norm(points["sphere_1k"], axis=1), 1, atol=1e-6)
x, y, z = np.abs(points["csg_82k"].T)
on_faces = (np.abs(x - 0.9) < 1e-3) | (np.abs(y - 0.6) < 1e-3) | (np.abs(z - 0.3) < 1e-3) | (np.abs(z - 0.8) < 1e-3)
assert 0.4 < on_faces.mean() < 1, on_faces.mean()
# Varying density: three quarters of the stadium stand in crowds of five, each within 2^-21 of the whole.
rng = np.random.default_rng(zlib.crc32(b"stadium_10k"))
crowds = sets.stadium(rng, 10_000)[-7500:].astype("<f4").reshape(-1, 5, 3).astype(float)
extent = np.ptp(points["stadium_10k"], axis=0).max()
assert np.ptp(crowds, axis=1).max() < extent / 2 ** 20, np.ptp(crowds, axis=1).max()
# A volume above a surface: the plume thins out upwards.
height = sets.volcano(np.random.default_rng(8), 133_000)[int(0.65 * 133_000):, 2]
assert np.median(height) - height.min() < 0.3 * np.ptp(height)
# The files hold what the generators make, in another order, in which neighbours in space are far from each other.
made = sets.sphere(np.random.default_rng(9), 900).astype("<f4")
assert np.array_equal(np.sort(made, axis=0), np.sort(points["sphere_1k"], axis=0))
for name, there in points.items():
    steps = np.linalg.norm(np.diff(there, axis=0), axis=1)
    assert np.median(steps) > 0.1 * np.ptp(there, axis=0).max(), name

# A set that is there stays as it is; one that is not is made as before.
with open(path("sphere_1k"), "wb") as file:
    file.write(b"kept")
os.remove(path("stadium_10k"))
make()
assert os.path.getsize(path("sphere_1k")) == 4
assert np.array_equal(np.fromfile(path("stadium_10k"), "<f4").reshape(-1, 3), points["stadium_10k"])

# All sets of another version of the script are made anew: when it has changed, also those that --quick leaves
# out are removed; and when it is not known. (With fewer points to choose from that takes less long.)
changed = os.path.join(folder, "changed.py")
with open(SCRIPT, encoding="utf-8") as file, open(changed, "w", encoding="utf-8") as copy:
    copy.write(file.read().replace('"sphere_1k": (sphere, 900)', '"sphere_1k": (sphere, 800)')
               .replace(f"SPARE = {sets.SPARE}", "SPARE = 2"))
for name in ("scan_35k", "flow_257k"):
    with open(path(name), "wb") as file:
        file.write(b"kept")
make(changed)
assert os.path.getsize(path("sphere_1k")) == 800 * 12
assert np.array_equal(np.fromfile(path("scan_35k"), "<f4").reshape(-1, 3), points["scan_35k"])
assert not os.path.exists(path("flow_257k"))
os.remove(os.path.join(folder, "made_by.sha256"))
with open(path("sphere_1k"), "wb") as file:
    file.write(b"kept")
make(changed)
assert os.path.getsize(path("sphere_1k")) == 800 * 12
os.remove(changed)
for arguments in ([], ["--fast"], [folder, folder]):
    failed = subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True)
    assert failed.returncode != 0 and "usage" in failed.stderr, failed

# The generators of all sets.
COUNT = 4000
assert len(sets.SETS) == 17
for name, (generate, count) in sets.SETS.items():
    few = generate(np.random.default_rng(1), COUNT)
    assert few.shape == (COUNT, 3) and np.isfinite(few).all(), name
    assert count == COUNTS.get(name, count) and (count <= sets.QUICK_LIMIT) == (name in COUNTS), name


def assert_even(shares, count):
    """Shares of points in places of the same size, of which none may differ by five standard deviations."""
    expected = 1 / len(shares)
    assert np.abs(shares - expected).max() < 5 * (expected / count) ** 0.5, shares


# Random points fill the sphere, and the cube, evenly.
ball = sets.SETS["random_sphere_500k"][0](np.random.default_rng(2), COUNT)
assert np.allclose(np.linalg.norm(ball, axis=1), 1, atol=1e-12)
slices = np.histogram(ball[:, 2], 10, (-1, 1))[0]
assert_even(slices / COUNT, COUNT)  # Archimedes: slices of a sphere have the area of their thickness.
assert_even(np.histogramdd(ball, 2, [(-1, 1)] * 3)[0].ravel() / COUNT, COUNT)
cube = sets.SETS["random_cube_4000k"][0](np.random.default_rng(3), COUNT)
assert cube.min() >= 0 and cube.max() < 1
assert_even(np.histogramdd(cube, 4, [(0, 1)] * 3)[0].ravel() / COUNT, COUNT)


def distances(points, field):
    """From where a field vanishes, to first order."""
    h = 1e-5
    gradient = np.stack([(field(points + h * axis) - field(points - h * axis)) / (2 * h) for axis in np.eye(3)], axis=1)
    return field(points) / np.maximum(np.linalg.norm(gradient, axis=1), 1e-9)


# Scans lie near an implicit surface, but not on it, by parts of the distance of their points; the surface itself is
# met.
scan = sets.scan
for generate in (sets.blob_scan, sets.gyroid_scan):
    fields = []
    sets.scan = lambda rng, count, field, _: fields.append(field) or scan(rng, count, field)
    scanned = generate(np.random.default_rng(4), COUNT)
    sets.scan = scan
    spacing = 4 / COUNT ** 0.5
    off = np.abs(distances(scanned, fields[0])) / spacing
    assert 0.05 < np.median(off) < 0.5 and (off > 1e-3).mean() > 0.98, (generate, np.median(off))
    surface = sets.sample_surface(np.random.default_rng(4), COUNT, fields[0])[0]
    assert np.abs(distances(surface, fields[0])).max() < 1e-3 * spacing, generate


def vary(points):
    """The deviation of the logarithm of the number of points in cells, of the cells that have some."""
    counts = np.unique(np.floor(points * 8), axis=0, return_counts=True)[1]
    return np.log(counts).std()


# Two scans are much denser in some places than in others.
for name, even in (("scan_100k", sets.blob_scan), ("gyroid_100k", sets.gyroid_scan)):
    varied = sets.SETS[name][0](np.random.default_rng(10), COUNT)
    assert vary(varied) > 1.2 * vary(even(np.random.default_rng(10), COUNT)), (name, vary(varied))
# A plane is seen from one side only: the shift of that side is the same for all points, and what differs is noise.
height = scan(np.random.default_rng(5), COUNT, lambda x: x[:, 2])[:, 2] / spacing
assert 0.03 < height.std() < 0.11, height.std()
assert abs(height.mean()) > 0.05, height.mean()

# Flows are ever denser towards the wing, in the plane z = 0: with a distance that is even in logarithm, and a
# direction of which the cosine to that plane's normal is even, ln |z| has the mean ln(finest) / 2 - 1 and the
# variance ln(finest)^2 / 12 + 1.
for name, finest in (("flow_257k", 1e-3), ("flow_208k", 1e-6)):
    logarithm = np.log(np.abs(sets.SETS[name][0](np.random.default_rng(6), COUNT)[:, 2]))
    deviation = (np.log(finest) ** 2 / 12 + 1) ** 0.5
    assert abs(logarithm.mean() - (np.log(finest) / 2 - 1)) < 5 * deviation / COUNT ** 0.5, (name, logarithm.mean())
    assert abs(logarithm.std() / deviation - 1) < 0.05, (name, logarithm.std())

# The stadium's bowl is empty, and its seats stand in 40 rows around it.
seats = sets.stadium(np.random.default_rng(7), COUNT)
radius = np.hypot(seats[:, 0] / 1.1, seats[:, 1] / 0.9)
assert 0.3 - 1e-6 < radius.min() and radius.max() < 0.45
assert len(np.unique(np.round(radius, 5))) == 40
assert len(np.unique(seats[: COUNT - COUNT * 3 // 4, 2])) == 40
