# SPDX-License-Identifier: BSD-3-Clause
"""The point sets of the paper's experiments: their sizes and kinds, the same in every run."""
import os
import subprocess
import sys

import numpy as np


def argument(option):
    return sys.argv[sys.argv.index(option) + 1]


SCRIPT = os.path.join(argument("-D"), "make_point_sets.py")
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
crowds = points["stadium_10k"][-7500:].reshape(-1, 5, 3).astype(float)
extent = np.ptp(points["stadium_10k"], axis=0).max()
assert np.ptp(crowds, axis=1).max() < extent / 2 ** 20, np.ptp(crowds, axis=1).max()
# A volume above a surface: the plume thins out upwards.
height = points["volcano_133k"][int(0.65 * 133_000):, 2]
assert np.median(height) - height.min() < 0.3 * np.ptp(height)

# A set that is there stays as it is; one that is not is made as before.
with open(path("sphere_1k"), "wb") as file:
    file.write(b"kept")
os.remove(path("stadium_10k"))
make()
assert os.path.getsize(path("sphere_1k")) == 4
assert np.array_equal(np.fromfile(path("stadium_10k"), "<f4").reshape(-1, 3), points["stadium_10k"])

# All sets of another version of the script are made anew: when it has changed, also those that --quick leaves
# out are removed; and when it is not known.
changed = os.path.join(folder, "changed.py")
with open(SCRIPT, encoding="utf-8") as file, open(changed, "w", encoding="utf-8") as copy:
    copy.write(file.read().replace('"sphere_1k": (sphere, 900)', '"sphere_1k": (sphere, 800)'))
for name in ("scan_35k", "flow_257k"):
    with open(path(name), "wb") as file:
        file.write(b"kept")
make(changed)
assert os.path.getsize(path("sphere_1k")) == 800 * 12
assert np.array_equal(np.fromfile(path("scan_35k"), "<f4").reshape(-1, 3), points["scan_35k"])
assert not os.path.exists(path("flow_257k"))
os.remove(os.path.join(folder, "made_by.sha256"))
make()
assert os.path.getsize(path("sphere_1k")) == 900 * 12
os.remove(changed)
for arguments in ([], ["--fast"], [folder, folder]):
    failed = subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True)
    assert failed.returncode != 0 and "usage" in failed.stderr, failed
