# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The referee: measures of surfaces that share no code, and no method, with the kernel.

Volumes are sums of determinants, closedness is a balance of directed edges, inside is a count of
crossings along a ray, and the exact volume of a convex intersection comes from clipping by
half-spaces in whole numbers.
"""

import math
from fractions import Fraction

import numpy as np

# ---- volume and area ---------------------------------------------------------------------------


def volume(body):
    """Signed volume, in extended precision about the box's centre: good to 1e-15 of the body."""
    if len(body.triangles) == 0:
        return 0.0
    center = (body.points.min(axis=0) + body.points.max(axis=0)) / 2
    corners = (body.points.astype(np.longdouble) - center)[body.triangles]
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    return float(np.sum(a * np.cross(b, c)) / 6)


def area(body):
    corners = body.points.astype(np.longdouble)[body.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return float(np.sum(np.sqrt(np.sum(normals * normals, axis=1))) / 2)


def whole(points):
    """The points as whole numbers of a power of two: (array of Python integers, that power)."""
    _, exponents = np.frexp(points[points != 0.0]) if np.any(points) else (None, np.array([0]))
    step = int(exponents.min()) - 53
    mantissas, exponents = np.frexp(points)
    numbers = np.array([int(m * 2**53) for m in mantissas.ravel()], dtype=object)
    shifts = np.array([max(int(e) - 53 - step, 0) for e in exponents.ravel()], dtype=object)
    return (numbers << shifts).reshape(points.shape), step


def exact_volume(body):
    """Signed volume without any rounding."""
    if len(body.triangles) == 0:
        return Fraction(0)
    points, step = whole(body.points)
    a, b, c = (points[body.triangles[:, k]].T for k in range(3))
    six = a[0] * (b[1] * c[2] - b[2] * c[1])
    six = six + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    return Fraction(int(six.sum()), 6) * Fraction(2) ** (3 * step)


def rounding(*bodies):
    """How far volumes may be off where every point is rounded to double once."""
    largest = max((np.abs(body.points).max() for body in bodies if len(body.points)), default=0.0)
    return 2.0**-52 * largest * sum(area(body) for body in bodies)


# ---- closedness --------------------------------------------------------------------------------


def edge_uses(points, polygons):
    """For each edge by its coordinates: how often it is used forward, and backward.

    `polygons` is a list of arrays of corner ids, each of shape (number, corners). A point is its
    coordinates: two points at one place are the same, and 0.0 is -0.0. Edges of no length are left
    out.
    """
    _, place = np.unique(points + 0.0, axis=0, return_inverse=True)
    edges = []
    for corners in polygons:
        corners = place[corners]
        edges.append(np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1).reshape(-1, 2))
    edges = np.concatenate(edges) if edges else np.zeros((0, 2), dtype=int)
    edges = edges[edges[:, 0] != edges[:, 1]]
    if len(edges) == 0:
        return np.zeros(0, dtype=int), np.zeros(0, dtype=int)
    _, number = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True)
    forward = edges[:, 0] < edges[:, 1]
    return np.bincount(number, forward), np.bincount(number, ~forward)


def open_edges(body):
    """Edges whose uses do not balance. None: the surface is closed and consistently oriented."""
    forward, backward = edge_uses(body.points, [body.triangles])
    return int(np.count_nonzero(forward != backward))


def non_manifold_edges(body):
    forward, backward = edge_uses(body.points, [body.triangles])
    return int(np.count_nonzero(forward + backward > 2))


def is_closed(body):
    return open_edges(body) == 0


# ---- winding numbers ---------------------------------------------------------------------------


def winding(body, points):
    """The winding number of a closed surface about each point: signed crossings of a ray along z.

    Exact but for the rounding of 2D orientations, which are evaluated alike for both triangles of
    an edge, so that no ray slips through; a ray through an edge is shifted by (e, e*e) in thought.
    """
    points = np.asarray(points, dtype=float).reshape(-1, 3)
    result = np.zeros(len(points), dtype=int)
    if len(body.triangles) == 0 or len(points) == 0:
        return result
    for point, triangle in candidates(body.points[body.triangles][:, :, :2], points[:, :2]):
        corners = body.points[body.triangles[triangle]]
        p = points[point]
        sides = [side_of_edge(corners[:, k], corners[:, (k + 1) % 3], p) for k in range(3)]
        left = (sides[0] > 0) & (sides[1] > 0) & (sides[2] > 0)
        right = (sides[0] < 0) & (sides[1] < 0) & (sides[2] < 0)
        facing = np.where(left, 1, np.where(right, -1, 0))
        a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
        height = np.einsum("ij,ij->i", np.cross(b - a, c - a), a - p)  # of the plane over the point
        above = height * facing > 0
        result += np.bincount(point, facing * above, len(points)).astype(int)
    return result


def side_of_edge(a, b, p):
    """Sign of p's side of the line a -> b in the xy plane; zero only where a and b coincide."""
    swap = (a[:, 0] > b[:, 0]) | ((a[:, 0] == b[:, 0]) & (a[:, 1] > b[:, 1]))
    low, high = np.where(swap[:, None], b, a), np.where(swap[:, None], a, b)
    dx, dy = (high - low)[:, 0], (high - low)[:, 1]
    side = np.sign(dx * (p[:, 1] - low[:, 1]) - dy * (p[:, 0] - low[:, 0]))
    side = np.where(side == 0, np.where(dy != 0, -np.sign(dy), np.sign(dx)), side)
    return np.where(swap, -side, side)


def candidates(triangles, points):
    """Batches of pairs (point, triangle) of which the triangle's 2D box may hold the point.

    A grid over the triangles' boxes; made coarser until large triangles no longer fill it.
    """
    lower, upper = triangles.min(axis=1), triangles.max(axis=1)
    origin = lower.min(axis=0)
    extent = np.maximum(upper.max(axis=0) - origin, 1e-300)
    cells = int(np.clip(4 * math.sqrt(len(triangles)), 1, 512))
    while True:
        first = np.clip(((lower - origin) / extent * cells).astype(int) - 1, 0, cells - 1)
        last = np.clip(((upper - origin) / extent * cells).astype(int) + 1, 0, cells - 1)
        spans = last - first + 1
        count = spans[:, 0] * spans[:, 1]
        if cells == 1 or count.sum() <= 40 * len(triangles) + 2_000_000:
            break
        cells //= 2
    owner = np.repeat(np.arange(len(triangles)), count)
    rank = np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
    cell = (
        (first[owner, 0] + rank // spans[owner, 1]) * cells
        + first[owner, 1]
        + rank % spans[owner, 1]
    )
    order = np.argsort(cell, kind="stable")
    owner, start = owner[order], np.searchsorted(cell[order], np.arange(cells * cells + 1))
    within = np.all((points >= origin) & (points <= origin + extent), axis=1)
    inside_points = np.flatnonzero(within)
    at = np.clip(((points[within] - origin) / extent * cells).astype(int), 0, cells - 1)
    at = at[:, 0] * cells + at[:, 1]
    number = start[at + 1] - start[at]
    batch = np.cumsum(number) // 2_000_000
    for b in range(int(batch[-1]) + 1 if len(batch) else 0):
        mine = batch == b
        point = np.repeat(inside_points[mine], number[mine])
        offset = np.arange(len(point)) - np.repeat(
            np.cumsum(number[mine]) - number[mine], number[mine]
        )
        triangle = owner[np.repeat(start[at[mine]], number[mine]) + offset]
        p = points[point]
        hit = np.all((p >= lower[triangle]) & (p <= upper[triangle]), axis=1)
        yield point[hit], triangle[hit]


def solid_angle_winding(body, points):
    """The same number from solid angles (van Oosterom, Strackee 1983): slow, and fit to check."""
    result = np.zeros(len(points))
    for i, p in enumerate(np.asarray(points, dtype=float)):
        a, b, c = (body.points[body.triangles[:, k]] - p for k in range(3))
        la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
        top = np.einsum("ij,ij->i", a, np.cross(b, c))
        dot = [np.einsum("ij,ij->i", u, v) for u, v in ((a, b), (b, c), (c, a))]
        bottom = la * lb * lc + dot[0] * lc + dot[1] * la + dot[2] * lb
        result[i] = np.sum(np.arctan2(top, bottom)) / (2 * np.pi)
    return result


def inside(body, points):
    """Whether each point is inside a closed surface: enclosed at least once."""
    return winding(body, points) >= 1


def expected_inside(operation, inputs, tools, points):
    """Which points belong to the result, by the definition in the kernel's Boolean.h."""
    in_inputs = [inside(body, points) for body in inputs]
    in_tools = [inside(body, points) for body in tools]
    nowhere = np.zeros(len(points), dtype=bool)
    any_input = np.any(in_inputs, axis=0) if inputs else nowhere
    any_tool = np.any(in_tools, axis=0) if tools else nowhere
    if operation in ("Union", "Resolve"):
        return any_input | any_tool
    if operation == "Intersection":
        return any_input & any_tool if tools else np.all(in_inputs, axis=0)
    if operation == "Difference":
        return any_input & ~any_tool
    return any_input ^ any_tool


def probes(rng, bodies, count, step):
    """Points to ask a referee about: `count` anywhere in the box, and `count` a body close to its
    triangles, `step` off to either side, where a missing or superfluous piece shows.
    """
    bodies = [body for body in bodies if len(body.triangles)]
    everything = np.concatenate([body.points for body in bodies])
    lower, upper = everything.min(axis=0), everything.max(axis=0)
    points = [rng.uniform(lower, upper, (count, 3))]
    for body in bodies:
        corners = body.points[body.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        size = np.linalg.norm(normals, axis=1)
        wide = np.flatnonzero(size > step * step)
        if len(wide) == 0:
            continue
        chosen = rng.choice(wide, count)
        weights = rng.dirichlet((1.0, 1.0, 1.0), count)
        offset = normals[chosen] / size[chosen, None] * rng.choice([-step, step], (count, 1))
        points.append(np.einsum("ij,ijk->ik", weights, corners[chosen]) + offset)
    return np.concatenate(points)


# ---- the exact intersection of convex bodies ---------------------------------------------------


class ConvexBody:
    """A convex polyhedron whose corners are exact, as homogeneous whole numbers, cut by planes."""

    def __init__(self, points, faces):
        self.points = [(*p, 1) for p in points]  # Python integers x, y, z, w > 0
        self.approximate = np.array([[float(c) for c in p] for p in points])
        self.faces = faces

    def cut(self, normal, offset):
        """Keep the part where normal . x <= offset; all whole numbers."""
        signs = self.signs(normal, offset)
        used = {i for face in self.faces for i in face}
        if all(signs[i] <= 0 for i in used):
            return
        made, kept = {}, []
        for face in self.faces:
            corners = []
            for i, j in zip(face, face[1:] + face[:1]):
                if signs[i] <= 0:
                    corners.append(i)
                if signs[i] * signs[j] < 0:
                    corners.append(self.crossing(made, min(i, j), max(i, j), normal, offset))
            if len(corners) > 2:
                kept.append(corners)
        directed = {edge for face in kept for edge in zip(face, face[1:] + face[:1])}
        rim = {j: i for i, j in directed if (j, i) not in directed}
        while rim:
            lid = [next(iter(rim))]
            while lid[-1] in rim:
                lid.append(rim.pop(lid[-1]))
            if len(lid) > 3:
                kept.append(lid[:-1])
        self.faces = kept

    def signs(self, normal, offset):
        """The sign of every corner; exact numbers only where doubles cannot tell."""
        n = np.array([float(c) for c in normal])
        length = np.linalg.norm(n)
        values = self.approximate @ (n / length) - float(offset) / length
        doubt = 1e-12 * (np.abs(self.approximate).max() + abs(float(offset) / length))
        signs = np.sign(values).astype(int)
        for i in np.flatnonzero(np.abs(values) <= doubt):
            x, y, z, w = self.points[i]
            exact = normal[0] * x + normal[1] * y + normal[2] * z - offset * w
            signs[i] = (exact > 0) - (exact < 0)
        return signs.tolist()

    def crossing(self, made, i, j, normal, offset):
        if (i, j) not in made:
            p, q = self.points[i], self.points[j]
            value = [sum(n * c for n, c in zip(normal, r)) - offset * r[3] for r in (p, q)]
            new = [q[k] * value[0] - p[k] * value[1] for k in range(4)]
            shared = math.gcd(*new) * (1 if new[3] > 0 else -1)
            new = tuple(c // shared for c in new)
            made[i, j] = len(self.points)
            self.points.append(new)
            position = [float(Fraction(c, new[3])) for c in new[:3]]
            self.approximate = np.vstack([self.approximate, position])
        return made[i, j]

    def volume(self):
        six = Fraction(0)
        for face in self.faces:
            corners = [[Fraction(c, self.points[i][3]) for c in self.points[i][:3]] for i in face]
            a = corners[0]
            for b, c in zip(corners[1:], corners[2:]):
                six += a[0] * (b[1] * c[2] - b[2] * c[1])
                six += a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        return six / 6


def planes(points, triangles):
    """The distinct planes (normal, offset) of triangles over whole-number points, outward."""
    found = set()
    for i, j, k in triangles.tolist():
        a, b, c = points[i], points[j], points[k]
        u, v = [b[m] - a[m] for m in range(3)], [c[m] - a[m] for m in range(3)]
        normal = (
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        )
        shared = math.gcd(*normal)
        if shared:
            normal = tuple(n // shared for n in normal)
            found.add((normal, sum(n * c for n, c in zip(normal, a))))
    return sorted(found)


def convex_intersection_volume(*bodies):
    """The exact volume common to convex bodies: the finest one clipped by all others' faces.

    Where a body is convex but for rounding errors, the answer is that of its faces' half-spaces.
    """
    bodies = sorted(bodies, key=lambda body: -len(body.triangles))  # few planes cut fast
    points, step = whole(np.concatenate([body.points for body in bodies]))
    points = [tuple(int(c) for c in p) for p in points]
    start = len(bodies[0].points)
    result = ConvexBody(points[:start], [list(t) for t in bodies[0].triangles.tolist()])
    for body in bodies[1:]:
        for normal, offset in planes(points[start : start + len(body.points)], body.triangles):
            result.cut(normal, offset)
            if not result.faces:
                return Fraction(0)
        start += len(body.points)
    return result.volume() * Fraction(2) ** (3 * step)


def is_exactly_convex(body):
    """Whether no point lies in front of any triangle's plane, without rounding."""
    points, _ = whole(body.points)
    points = [tuple(int(c) for c in p) for p in points]
    shell = ConvexBody(points, [])
    return all(max(shell.signs(*plane)) <= 0 for plane in planes(points, body.triangles))


# ---- box soups ---------------------------------------------------------------------------------


def voxel_volume_and_area(inside_cells):
    """Volume and boundary area of a set of unit cells, given as a boolean array."""
    padded = np.pad(inside_cells, 1)
    walls = sum(int(np.count_nonzero(np.diff(padded.astype(np.int8), axis=k))) for k in range(3))
    return int(np.count_nonzero(inside_cells)), walls
