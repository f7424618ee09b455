# SPDX-License-Identifier: BSD-3-Clause
"""/usr/bin/python3 make_point_sets.py FOLDER [--quick]

Writes point sets of the kinds and sizes of the paper's Table 1 (see README.md): FOLDER/NAME.xyz, raw
little-endian float32, x y z of one point after the other, in random order. Files that this very script has
made before are left as they are, which FOLDER/made_by.sha256 tells; those of another version are removed
first. --quick leaves out the sets above 150,000 points. Each set has a seed of its own.
"""
import hashlib
import os
import signal
import sys
import zlib

import numpy as np

QUICK_LIMIT = 150_000


def unit_vectors(rng, count):
    v = rng.standard_normal((count, 3))
    return v / np.linalg.norm(v, axis=1, keepdims=True)


def lengths2(v):
    """Squared lengths of vectors: by columns, since rows of three take NumPy's sum() several times as long."""
    x, y, z = v.T
    return x * x + y * y + z * z


def sphere(rng, count):
    """Evenly spread, like the vertices of a mesh: a spiral from pole to pole."""
    i = np.arange(count)
    z = 1 - (2 * i + 1) / count
    angle = i * np.pi * (3 - 5 ** 0.5)
    r = np.sqrt(1 - z * z)
    return np.column_stack((r * np.cos(angle), r * np.sin(angle), z))


def random_sphere(rng, count):
    return unit_vectors(rng, count)


def random_cube(rng, count):
    return rng.random((count, 3))


def project(points, field, steps=4, chunk=1 << 14):
    """Moves points to where a field vanishes, by Newton's steps along its gradient; those that arrive, with the
    normals there. In chunks that stay in the cache."""
    found, normals = [], []
    h = 1e-5
    for first in range(0, len(points), chunk):
        x = points[first:first + chunk].copy()
        for _ in range(steps):
            value = field(x)
            gradient = np.stack([(field(x + h * axis) - value) / h for axis in np.eye(3)], axis=1)
            slope2 = np.maximum(lengths2(gradient), 1e-4)
            x -= np.clip(value / slope2, -0.5, 0.5)[:, None] * gradient
        arrived = (np.abs(field(x)) < 1e-4) & (np.abs(x) < 1.5).all(axis=1)
        found.append(x[arrived])
        normals.append((gradient / np.sqrt(slope2)[:, None])[arrived])
    return np.concatenate(found), np.concatenate(normals)


def sample_surface(rng, count, field):
    """Points of the surface where a field vanishes, as many as asked for."""
    points, normals = np.empty((0, 3)), np.empty((0, 3))
    while len(points) < count:
        more = project(rng.uniform(-1, 1, (count - len(points) + 1000, 3)), field)
        points, normals = np.concatenate((points, more[0])), np.concatenate((normals, more[1]))
    return points[:count], normals[:count]


def gather(rng, count, points):
    """Which points of many are kept so that they are the denser the nearer they lie to one of four of them."""
    details = points[rng.integers(0, len(points), 4)]
    distance2 = ((points[:, None] - details) ** 2).sum(axis=2).min(axis=1)
    weights = (distance2 + 0.003) ** -1.5
    # As rng.choice() without replacement, which would draw anew as often as the rounding of the weights has it.
    return np.argpartition(rng.standard_exponential(len(points)) / weights, count)[:count]


def scan(rng, count, field, spare=1):
    """A surface as merged scans have it: each point is seen from the nearest of eight sides, with noise along the
    line of sight, and each side is a little out of place. Both are fractions of the points' mean distance. With
    `spare` times as many points to choose from they lie denser around details, as far as there are enough."""
    points, normals = sample_surface(rng, spare * count, field)
    if spare > 1:
        kept = gather(rng, count, points)
        points, normals = points[kept], normals[kept]
    spacing = 4 / count ** 0.5
    sides = unit_vectors(rng, 8)
    shifts = 0.3 * spacing * rng.standard_normal(sides.shape)
    side = (normals @ sides.T).argmax(axis=1)
    noise = 0.1 * spacing * rng.standard_normal(count)
    return points + noise[:, None] * sides[side] + shifts[side]


def blob_scan(rng, count, spare=1):
    """Of a body of rounded limbs."""
    centers = 0.5 * unit_vectors(rng, 6) * rng.random((6, 1)) ** 0.3
    sharpness = 1 / rng.uniform(0.15, 0.35, 6) ** 2

    def field(x):
        return sum(np.exp(-k * lengths2(x - c)) for c, k in zip(centers, sharpness)) - 0.5
    return scan(rng, count, field, spare)


def gyroid_scan(rng, count, spare=1):
    """Of a body full of holes."""
    def field(x):
        s, c = np.sin(6 * x), np.cos(6 * x)
        return s[:, 0] * c[:, 1] + s[:, 1] * c[:, 2] + s[:, 2] * c[:, 0]
    return scan(rng, count, field, spare)


def csg(rng, count):
    """The surface of a machine part: a box and a cylinder together, less a ball and a bore."""
    def cylinder(u, v, w, radius, half):
        return np.maximum(np.hypot(u, v) - radius, np.abs(w) - half)

    def field(p):
        x, y, z = p.T
        box = np.maximum(np.maximum(np.abs(x) - 0.9, np.abs(y) - 0.6), np.abs(z) - 0.3)
        body = np.minimum(box, cylinder(x, y, z, 0.4, 0.8))
        ball = np.sqrt((x - 0.9) ** 2 + (y - 0.6) ** 2 + z ** 2) - 0.35
        return np.maximum(body, -np.minimum(ball, cylinder(x, y, z, 0.2, 2.0)))
    return sample_surface(rng, count, field)[0]


def stadium(rng, count):
    """An empty bowl around a field, and in it fans so close together that only the last depths part them."""
    fans = count * 3 // 4 // 5
    angle = rng.uniform(0, 2 * np.pi, fans + count - 5 * fans)
    row = rng.integers(0, 40, len(angle)) / 40
    r = 0.3 + 0.15 * row
    seats = np.column_stack((1.1 * r * np.cos(angle), 0.9 * r * np.sin(angle), 0.2 * row ** 1.5))
    crowds = np.repeat(seats[:fans], 5, axis=0)
    return np.concatenate((seats[fans:], crowds + rng.uniform(-2e-7, 2e-7, crowds.shape)))


def volcano(rng, count):
    """The terrain on a lattice, and above the crater a plume that widens and thins out."""
    side = int((0.65 * count) ** 0.5)
    x, y = (2 * a.ravel() / (side - 1) - 1 for a in np.meshgrid(np.arange(side), np.arange(side)))
    r = np.hypot(x, y)
    waves = rng.uniform(-12, 12, (24, 2))
    rough = sum(np.sin(kx * x + ky * y + kx) / (2 + kx * kx + ky * ky) for kx, ky in waves)
    terrain = np.column_stack((x, y, 0.7 * np.exp(-3 * r) - 0.3 * np.exp(-60 * r * r) + 0.1 * rough))
    height = rng.exponential(0.4, count - side * side)
    spread = (0.02 + 0.25 * height)[:, None] * rng.standard_normal((len(height), 2))
    plume = np.column_stack((spread[:, 0] + 0.3 * height ** 2, spread[:, 1], 0.4 + height))
    return np.concatenate((terrain, plume))


def flow(rng, count, finest):
    """A volume around a delta wing, the denser the nearer to it: distances from `finest` on, even in logarithm."""
    along = np.sqrt(rng.random(count))
    wing = np.column_stack((along, along * rng.uniform(-0.5, 0.5, count), np.zeros(count)))
    distance = np.exp(rng.uniform(np.log(finest), 0, count))
    return wing + distance[:, None] * unit_vectors(rng, count)


SPARE = 32  # Points to choose from for each of a scan whose density varies.

# In the order of the paper's Table 1, with the name that the set has there.
SETS = {
    "sphere_1k": (sphere, 900),                                   # Sphere
    "scan_35k": (blob_scan, 35_000),                              # Bunny
    "stadium_10k": (stadium, 10_000),                             # Maracanã
    "scan_100k": (lambda r, n: blob_scan(r, n, SPARE), 100_000),  # David head
    "gyroid_100k": (lambda r, n: gyroid_scan(r, n, SPARE), 100_000),  # Pig
    "csg_82k": (csg, 82_000),                                     # CSG
    "volcano_133k": (volcano, 133_000),                           # Volcano
    "flow_257k": (lambda r, n: flow(r, n, 1e-3), 257_000),        # Fighter
    "flow_208k": (lambda r, n: flow(r, n, 1e-6), 208_000),        # Deltao
    "scan_350k": (blob_scan, 350_000),                            # David
    "random_sphere_500k": (random_sphere, 500_000),               # Rnd Sphere
    "scan_438k": (blob_scan, 438_000),                            # Dragon
    "scan_544k": (blob_scan, 544_000),                            # Happy
    "gyroid_883k": (gyroid_scan, 883_000),                        # Blade
    "scan_1669k": (blob_scan, 1_669_000),                         # Chair
    "random_cube_4000k": (random_cube, 4_000_000),                # Rnd Cube
    "scan_5000k": (blob_scan, 5_000_000),                         # Thai Statue
}


def write(points, path):
    """Writes beside the target first, so that a reader never meets half a file."""
    partial = f"{path}.{os.getpid()}.part"
    try:
        points.astype("<f4").tofile(partial)
        os.replace(partial, path)
    finally:  # also after Ctrl-C and SIGTERM
        if os.path.exists(partial):
            os.remove(partial)


def remove_outdated(folder):
    """Removes the sets of another version of this script, and only then says that those to come are of this one:
    whenever it is interrupted, no set is taken for one that it is not."""
    with open(__file__, "rb") as script:
        version = hashlib.sha256(script.read()).hexdigest() + "\n"
    path = os.path.join(folder, "made_by.sha256")
    if os.path.exists(path):
        with open(path, encoding="ascii", errors="replace") as file:
            if file.read() == version:
                return
    for name in SETS:
        if os.path.exists(os.path.join(folder, f"{name}.xyz")):
            os.remove(os.path.join(folder, f"{name}.xyz"))
    with open(path, "w", encoding="ascii") as file:
        file.write(version)


def main(arguments):
    quick = "--quick" in arguments
    folders = [a for a in arguments if a != "--quick"]
    if len(folders) != 1 or folders[0].startswith("-"):
        sys.exit("make_point_sets: usage: /usr/bin/python3 make_point_sets.py FOLDER [--quick]")
    signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))
    try:
        os.makedirs(folders[0], exist_ok=True)
        remove_outdated(folders[0])
        for name, (make, count) in SETS.items():
            path = os.path.join(folders[0], f"{name}.xyz")
            if not os.path.exists(path) and not (quick and count > QUICK_LIMIT):
                rng = np.random.default_rng(zlib.crc32(name.encode()))
                write(rng.permutation(make(rng, count)), path)
                print(f"{path}: {count:,} points", flush=True)
    except OSError as error:
        sys.exit(f"make_point_sets: cannot write to {folders[0]}: {error.strerror or error}")


if __name__ == "__main__":
    main(sys.argv[1:])
