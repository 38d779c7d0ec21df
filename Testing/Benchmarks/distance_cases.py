# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What distances are measured in the benchmark, and what they must be at some of the points.

Everything is made with numpy from a fixed seed. The expected distances come from brute force in double precision over
all triangles that may be nearest, the signs from the closed form of the surface.
"""

from dataclasses import dataclass, field

import numpy as np

from cases import bumpy_radius, icosphere

PHASE = np.array([0.1, 0.2, 0.3]).reshape(3, 1)
ALL = ("ours", "fcpw", "open3d", "libigl", "pymeshlab", "vtk", "packaged-vtk", "meshlib")
CHECKED = 40
FACETS = 0.01  # more than any facet is off the smooth surface


@dataclass
class DistanceCase:
    """Distances of queries to a surface."""

    name: str
    points: np.ndarray
    triangles: np.ndarray
    queries: np.ndarray
    contenders: tuple = ALL
    sample: np.ndarray = field(init=False)  # numbers of the queries that are checked
    expected: np.ndarray = field(init=False)  # their signed distances

    def __post_init__(self):
        radius = np.linalg.norm(self.queries, axis=1)
        height = radius - bumpy_radius(self.queries / radius[:, None], PHASE)
        clear = np.flatnonzero(np.abs(height) > FACETS)
        self.sample = clear[np.linspace(0, len(clear) - 1, CHECKED).astype(int)]
        some, inside = self.queries[self.sample], height[self.sample] < 0
        self.expected = np.where(inside, -1, 1) * brute_force(self.points[self.triangles], some)


def brute_force(corners, queries):
    middle = corners.mean(axis=1)
    reach = np.linalg.norm(corners - middle[:, None], axis=2).max(axis=1)
    result = []
    for query in queries:
        apart = np.linalg.norm(middle - query, axis=1)
        near = corners[apart - reach <= (apart + reach).min() + 1e-12]
        result.append(to_triangles(near[:, 0], near[:, 1], near[:, 2], query).min())
    return np.array(result)


def to_triangles(a, b, c, query):
    """Distances from a point to triangles: to the foot of the perpendicular, or to the edges."""
    normal = np.cross(b - a, c - a)
    over = np.ones(len(a), dtype=bool)
    best = np.full(len(a), np.inf)
    for u, v in ((a, b), (b, c), (c, a)):
        along, offset = v - u, query - u
        where = np.clip(np.einsum("ij,ij->i", offset, along) / np.einsum("ij,ij->i", along, along), 0, 1)
        best = np.minimum(best, np.linalg.norm(offset - where[:, None] * along, axis=1))
        over &= np.einsum("ij,ij->i", np.cross(normal, along), offset) >= 0
    height = np.abs(np.einsum("ij,ij->i", normal, query - a)) / np.linalg.norm(normal, axis=1)
    return np.where(over, height, best)


def bumpy(frequency):
    points, triangles = icosphere(frequency)
    return points * bumpy_radius(points, PHASE)[:, None], triangles


def all_distance_cases(quick):
    """Every case, made one at a time. Quick: the same, small, to try the harness."""
    random = np.random.default_rng(2005)
    count = 10_000 if quick else 1_000_000
    points, triangles = bumpy(24 if quick else 224)
    shifted = (points + [0.02, 0.014, 0.0])[triangles].mean(axis=1)[:count]
    yield DistanceCase("distance near", points, triangles, shifted, ALL + ("ours-1-thread",))
    anywhere = random.uniform(-2.1, 2.1, (count, 3))
    fast = ("ours", "ours-1-thread")
    # The peers need minutes for a million of these; a tenth tells as much.
    yield DistanceCase("distance anywhere", points, triangles, anywhere[: count // 10])
    direction = random.normal(size=(count // 10, 3))
    yield DistanceCase("distance far", points, triangles, 10 * direction)
    yield DistanceCase("distance anywhere, 1M queries", points, triangles, anywhere, fast)
    for frequency in (28, 56, 112) if not quick else ():
        points, triangles = bumpy(frequency)
        name = f"distance anywhere, {len(triangles):,} triangles"
        yield DistanceCase(name, points, triangles, anywhere, fast)
