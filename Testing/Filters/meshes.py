# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces to test with: shapes whose volume is known, random bodies, and CGAL's demo meshes.

Nothing here uses VTK, so that what the tests expect does not come from the library under test.
"""

import itertools
import pathlib
import tarfile
import tempfile
from typing import NamedTuple

import numpy as np

CGAL_DATA = pathlib.Path("/usr/share/doc/libcgal-dev/data.tar.gz")  # Debian: libcgal-demo


class Mesh(NamedTuple):
    """Triangles over points; a triangle's corners turn left seen from outside."""

    points: np.ndarray  # float64, shape (number of points, 3)
    triangles: np.ndarray  # int32, shape (number of triangles, 3)


def mesh(points, triangles):
    """A Mesh of anything that looks like two arrays."""
    return Mesh(
        np.ascontiguousarray(points, dtype=np.float64).reshape(-1, 3),
        np.ascontiguousarray(triangles, dtype=np.int32).reshape(-1, 3),
    )


EMPTY = mesh([], [])


# ---- putting meshes together and in place ------------------------------------------------------


def joined(*parts):
    """The parts side by side in one mesh, none of their points shared."""
    first = np.cumsum([0] + [len(part.points) for part in parts])
    return mesh(
        np.concatenate([part.points for part in parts]),
        np.concatenate([part.triangles + start for part, start in zip(parts, first)]),
    )


def moved(body, by):
    return mesh(body.points + np.asarray(by, dtype=float), body.triangles)


def scaled(body, by):
    return mesh(body.points * by, body.triangles)


def turned(body, rotation, about=(0.0, 0.0, 0.0)):
    about = np.asarray(about, dtype=float)
    return mesh((body.points - about) @ np.asarray(rotation).T + about, body.triangles)


def inside_out(body):
    return mesh(body.points, body.triangles[:, ::-1])


def mirrored(body, axis, at):
    """The reflection in the plane where the coordinate `axis` is `at`, again oriented outwards."""
    points = body.points.copy()
    points[:, axis] = 2.0 * at - points[:, axis]
    return inside_out(mesh(points, body.triangles))


def shuffled(body, rng):
    """The same surface with its cells permuted and the corners of each cell rotated.

    Also returns the old id of each new cell.
    """
    order = rng.permutation(len(body.triangles))
    start = rng.integers(0, 3, len(order))
    columns = (np.arange(3)[None, :] + start[:, None]) % 3
    return mesh(body.points, body.triangles[order[:, None], columns]), order


def on_lattice(body, bits):
    """The points rounded to multiples of 2**-bits, which leaves room to move them exactly."""
    return mesh(np.round(body.points * 2.0**bits) / 2.0**bits, body.triangles)


def rotation(axis, angle):
    """Rodrigues' rotation matrix."""
    x, y, z = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def random_rotation(rng):
    """Uniform over all rotations: a random unit quaternion."""
    w, x, y, z = (lambda q: q / np.linalg.norm(q))(rng.normal(size=4))
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


# ---- shapes ------------------------------------------------------------------------------------

BOX_QUADS = np.array(
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
)


def box_corners(lower, upper):
    """Corner i has its bits as x, y, z: bit 0 set is the upper x, and so on."""
    bounds = np.array([lower, upper], dtype=float)
    return np.array(
        [[bounds[i & 1, 0], bounds[i >> 1 & 1, 1], bounds[i >> 2, 2]] for i in range(8)]
    )


def box(lower, upper):
    quads = BOX_QUADS
    return mesh(
        box_corners(lower, upper), np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    )


def cube(edge=1.0, center=(0.0, 0.0, 0.0)):
    center = np.asarray(center, dtype=float)
    return box(center - edge / 2, center + edge / 2)


def revolved(profile, around, first_angle=0.0):
    """The convex or ring-free body of revolution about z of a polyline (radius, height), from its
    lower pole to its upper one; both ends of the profile must lie on the axis.
    """
    profile = np.asarray(profile, dtype=float)
    angles = first_angle + 2 * np.pi * np.arange(around) / around
    points = [[0.0, 0.0, profile[0, 1]]]
    for radius, height in profile[1:-1]:
        points += [[radius * np.cos(a), radius * np.sin(a), height] for a in angles]
    points.append([0.0, 0.0, profile[-1, 1]])
    rings = len(profile) - 2
    top = len(points) - 1
    here = np.arange(around)
    following = (here + 1) % around
    triangles = [np.stack([0 * here, 1 + following, 1 + here], axis=1)]
    for ring in range(rings - 1):
        low, high = 1 + ring * around, 1 + (ring + 1) * around
        triangles.append(np.stack([low + here, low + following, high + following], axis=1))
        triangles.append(np.stack([low + here, high + following, high + here], axis=1))
    last = 1 + (rings - 1) * around
    triangles.append(np.stack([0 * here + top, last + here, last + following], axis=1))
    return mesh(points, np.concatenate(triangles))


def sphere(radius=0.5, center=(0.0, 0.0, 0.0), around=16, along=16, first_angle=0.0):
    """A globe of `around` meridians and `along` parallels, the two poles counted, poles on z."""
    latitude = np.pi * np.arange(along) / (along - 1)
    profile = np.stack([radius * np.sin(latitude), -radius * np.cos(latitude)], axis=1)
    profile[[0, -1], 0] = 0.0
    return moved(revolved(profile, around, first_angle), center)


def cylinder(radius=0.5, height=1.0, center=(0.0, 0.0, 0.0), around=16, axis=(0.0, 0.0, 1.0)):
    """A capped prism; its caps are fans about their centre."""
    half = height / 2
    body = revolved([(0, -half), (radius, -half), (radius, half), (0, half)], around)
    return moved(turned(body, rotation_from_z(axis)), center)


def cone(radius=0.5, height=1.0, center=(0.0, 0.0, 0.0), around=16, axis=(0.0, 0.0, 1.0)):
    """A capped cone that points along `axis`; its centre is half-way up."""
    half = height / 2
    body = revolved([(0, -half), (radius, -half), (0, half)], around)
    return moved(turned(body, rotation_from_z(axis)), center)


def rotation_from_z(axis):
    axis = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    if axis[2] > 1 - 1e-15:
        return np.eye(3)
    if axis[2] < -1 + 1e-15:
        return np.diag([1.0, -1.0, -1.0])
    return rotation(np.cross([0.0, 0.0, 1.0], axis), np.arccos(axis[2]))


def cylinder_between(start, end, radius, around=50):
    start, end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    length = np.linalg.norm(end - start)
    return cylinder(radius, length, (start + end) / 2, around, end - start)


def torus(ring, tube, around=32, across=16, center=(0.0, 0.0, 0.0)):
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * u / around, 2 * np.pi * v / across
    reach = ring + tube * np.cos(b)
    points = np.stack([reach * np.cos(a), reach * np.sin(a), tube * np.sin(b)], axis=-1)

    def number(i, j):
        return (i % around) * across + j % across

    one = np.stack([number(u, v), number(u + 1, v), number(u + 1, v + 1)], axis=-1)
    two = np.stack([number(u, v), number(u + 1, v + 1), number(u, v + 1)], axis=-1)
    return moved(mesh(points, np.concatenate([one.reshape(-1, 3), two.reshape(-1, 3)])), center)


def sheet(height, xs, ys):
    """The open surface z = height(x, y) over a grid; its normals point up."""
    x, y = np.meshgrid(xs, ys, indexing="ij")
    points = np.stack([x, y, np.broadcast_to(height(x, y), x.shape)], axis=-1)
    i, j = np.meshgrid(np.arange(len(xs) - 1), np.arange(len(ys) - 1), indexing="ij")
    corner = i * len(ys) + j
    one = np.stack([corner, corner + len(ys), corner + len(ys) + 1], axis=-1)
    two = np.stack([corner, corner + len(ys) + 1, corner + 1], axis=-1)
    return mesh(points, np.concatenate([one.reshape(-1, 3), two.reshape(-1, 3)]))


def icosphere(level, radius=1.0):
    """An icosahedron, each triangle split into four `level` times, the points pushed outwards."""
    golden = (1 + 5**0.5) / 2
    points = [
        p for a in (-1, 1) for b in (-golden, golden) for p in ((0, a, b), (a, b, 0), (b, 0, a))
    ]
    body = convex_hull(np.array(points, dtype=float))
    for _ in range(level):
        body = split_in_four(body)
        body = mesh(body.points / np.linalg.norm(body.points, axis=1)[:, None], body.triangles)
    return scaled(
        mesh(body.points / np.linalg.norm(body.points, axis=1)[:, None], body.triangles), radius
    )


def split_in_four(body):
    t = body.triangles
    edges = np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1)
    unique, number = np.unique(edges, axis=0, return_inverse=True)
    middle = body.points[unique].mean(axis=1)
    a, b, c = len(body.points) + number.reshape(3, -1)
    triangles = np.concatenate(
        [
            np.stack([t[:, 0], a, c], axis=1),
            np.stack([t[:, 1], b, a], axis=1),
            np.stack([t[:, 2], c, b], axis=1),
            np.stack([a, b, c], axis=1),
        ]
    )
    return mesh(np.concatenate([body.points, middle]), triangles)


# ---- random bodies -----------------------------------------------------------------------------


def bumpy_sphere(rng, level=3, radius=1.0, height=0.2, bumps=8):
    """A star-shaped closed surface: a sphere with waves of random direction on it."""
    ball = icosphere(level)
    reach = np.ones(len(ball.points))
    for _ in range(bumps):
        direction = rng.normal(size=3) * rng.uniform(2, 6)
        reach += height / bumps * 2 * np.sin(ball.points @ direction + rng.uniform(0, 2 * np.pi))
    return scaled(mesh(ball.points * reach[:, None], ball.triangles), radius)


def convex_hull(points):
    """The hull of points in general position, as triangles; exact where the points are integers."""
    values = [tuple(p) for p in np.asarray(points).tolist()]

    def above(face, p):
        a, b, c = (values[i] for i in face)
        ux, uy, uz = b[0] - a[0], b[1] - a[1], b[2] - a[2]
        vx, vy, vz = c[0] - a[0], c[1] - a[1], c[2] - a[2]
        wx, wy, wz = p[0] - a[0], p[1] - a[1], p[2] - a[2]
        return wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz) + wz * (ux * vy - uy * vx)

    first = next(
        s for s in itertools.combinations(range(len(values)), 4) if above(s[:3], values[s[3]])
    )
    a, b, c, d = (
        first
        if above(first[:3], values[first[3]]) < 0
        else (first[0], first[2], first[1], first[3])
    )
    faces = [(a, b, c), (a, c, d), (a, d, b), (b, d, c)]
    for i in range(len(values)):
        if i in first:
            continue
        seen = [face for face in faces if above(face, values[i]) > 0]
        edges = {edge for f in seen for edge in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0]))}
        faces = [face for face in faces if face not in set(seen)]
        faces += [(u, v, i) for u, v in edges if (v, u) not in edges]
    faces = sorted(faces)
    used, triangles = np.unique(np.array(faces), return_inverse=True)
    return mesh(np.asarray(points)[used], triangles)


def random_convex_body(rng, corners=16, bits=20):
    """The hull of random points on an ellipsoid, on a lattice of step 2**-bits: exactly convex."""
    directions = rng.normal(size=(corners, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    points = directions * rng.uniform(0.4, 1.0, 3) + rng.uniform(-0.5, 0.5, 3)
    hull = convex_hull(np.round(points * 2**bits).astype(np.int64).astype(object))
    return mesh(hull.points.astype(float) / 2**bits, hull.triangles)


def random_grid_body(rng, grid=4, bodies=1):
    """Closed bodies of few corners on a small grid, on top of each other: no place is generic."""
    parts = []
    while len(parts) < bodies:
        corners = np.unique(rng.integers(0, grid + 1, (rng.integers(4, 9), 3)), axis=0)
        if len(corners) > 3 and np.linalg.matrix_rank(corners[1:] - corners[0]) == 3:
            part = convex_hull(corners.astype(object))
            parts += [part] if len(part.triangles) > 3 else []
    return joined(*parts)


def flip_all_reflex(points, triangles, exact):
    """Turn diagonals of nearly flat quads until no edge is reflex; `exact` holds integer points.

    A globe whose points were rounded to a lattice is convex but for these diagonals.
    """
    triangles = triangles.copy()
    again = True
    while again:
        again = False
        owner = {}
        for t, corners in enumerate(triangles):
            for k in range(3):
                owner[corners[k], corners[(k + 1) % 3]] = (t, corners[(k + 2) % 3])
        touched = set()
        for (u, v), (t, w) in owner.items():
            other, x = owner[v, u]
            if u > v or t in touched or other in touched:
                continue
            if orientation([exact[i] for i in (u, v, w, x)]) > 0:
                triangles[t], triangles[other] = (u, x, w), (x, v, w)
                touched |= {t, other}
                again = True
    return mesh(points, triangles)


def orientation(corners):
    """Positive where the fourth corner lies in front of the triangle of the first three."""
    a, b, c, d = corners
    u, v, w = ([q[k] - a[k] for k in range(3)] for q in (b, c, d))
    return (
        w[0] * (u[1] * v[2] - u[2] * v[1])
        + w[1] * (u[2] * v[0] - u[0] * v[2])
        + w[2] * (u[0] * v[1] - u[1] * v[0])
    )


def lattice_sphere(
    radius=0.5, center=(0.0, 0.0, 0.0), around=16, along=16, bits=20, first_angle=0.0
):
    """A globe that is convex without any rounding error: an exact reference can cut it."""
    ball = on_lattice(sphere(radius, center, around, along, first_angle), bits)
    exact = [
        [int(c) for c in p] for p in np.asarray(np.round(ball.points * 2.0**bits), dtype=object)
    ]
    return flip_all_reflex(ball.points, ball.triangles, exact)


def random_boxes(rng, count, size):
    """`count` boxes with integer corners in a cube of edge `size`: pairs (lower, upper)."""
    boxes = []
    for _ in range(count):
        lower = rng.integers(0, size - 1, 3)
        boxes.append((lower, lower + 1 + rng.integers(0, np.minimum(size // 2, size - lower))))
    return boxes


def box_soup(boxes):
    return joined(*[box(lower, upper) for lower, upper in boxes])


def voxels(boxes, size):
    """How often each unit cell of the cube of edge `size` is covered: its winding number."""
    covered = np.zeros((size,) * 3, dtype=int)
    for (x, y, z), (u, v, w) in boxes:
        covered[x:u, y:v, z:w] += 1
    return covered


# ---- the pairs of the paper's Figure 5 ---------------------------------------------------------


def figure_5_pairs(fine=1):
    """Five pairs of solids that are convex without rounding error; `fine` multiplies their facets.

    After Quammen, Weigle, Taylor (2011), Figure 5: box and box, two cylinders whose caps lie in the
    same planes, sphere and sphere, sphere and box, cone and cylinder.
    """
    n = 24 * fine
    ball = lattice_sphere(0.5, around=n, along=n // 2 + 1)
    third = moved(ball, (0.25, 0.125, 0.1875))
    upright = on_lattice(cylinder(0.4, 1.0, around=n), 20)
    funnel = on_lattice(cone(0.5, 1.125, around=n), 20)
    bar = on_lattice(cylinder(0.25, 1.25, around=n), 20)
    lying = mesh(bar.points[:, [2, 0, 1]] + [0.0, 0.0, -0.1875], bar.triangles)
    return {
        "box-box": (
            box((-0.5,) * 3, (0.5,) * 3),
            box((-0.1875, -0.25, -0.125), (0.75, 0.6875, 0.8125)),
        ),
        "cylinder-cylinder": (upright, moved(upright, (0.375, 0.1875, 0.0))),
        "sphere-sphere": (ball, third),
        "sphere-box": (ball, box((0.0, -0.3125, -0.25), (0.75, 0.4375, 0.5))),
        "cone-cylinder": (funnel, lying),
    }


# ---- real meshes -------------------------------------------------------------------------------


def cgal_directory():
    """Where the meshes of libcgal-demo are unpacked; once a user and package version."""
    stamp = int(CGAL_DATA.stat().st_mtime)
    folder = pathlib.Path(tempfile.gettempdir()) / f"libcgal-demo-{stamp}"
    if not folder.exists():
        with tempfile.TemporaryDirectory(dir=folder.parent) as fresh:
            with tarfile.open(CGAL_DATA) as archive:
                wanted = [m for m in archive.getmembers() if m.name.endswith(".off") and m.isfile()]
                archive.extractall(fresh, wanted)
            try:
                pathlib.Path(fresh, "data").rename(folder)
            except OSError:  # another test process was faster
                pass
    return folder / "meshes"


def read_off(path):
    """An OFF file; polygons are cut into a fan."""
    with open(path, encoding="ascii", errors="replace") as file:
        words = [line.split("#")[0].split() for line in file]
    lines = [line for line in words if line]
    counts, body = (lines[1], lines[2:]) if len(lines[0]) == 1 else (lines[0][1:], lines[1:])
    number_of_points, number_of_faces = int(counts[0]), int(counts[1])
    points = [[float(c) for c in line[:3]] for line in body[:number_of_points]]
    triangles = []
    for line in body[number_of_points : number_of_points + number_of_faces]:
        corners = [int(c) for c in line[1 : 1 + int(line[0])]]
        triangles += [(corners[0], *corners[k : k + 2]) for k in range(1, len(corners) - 1)]
    return mesh(points, triangles)


def cgal_mesh(name):
    """A mesh of libcgal-demo, moved to the origin and scaled so that its box has diagonal 2."""
    body = read_off(cgal_directory() / f"{name}.off")
    used = body.points[body.triangles].reshape(-1, 3)
    lower, upper = used.min(axis=0), used.max(axis=0)
    return scaled(moved(body, -(lower + upper) / 2), 2 / np.linalg.norm(upper - lower))
