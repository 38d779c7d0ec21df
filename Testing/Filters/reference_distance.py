# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Distances from points to triangles by brute force, in long double; shares no code with what it checks."""

import numpy as np

LONG = np.longdouble


def to_segment(a, b, p):
    """Squared distances of points from segments, row by row."""
    along, offset = b - a, p - a
    length = np.einsum("ij,ij->i", along, along)
    where = np.einsum("ij,ij->i", offset, along) / np.where(length > 0, length, 1)
    rest = offset - np.clip(where, 0, 1)[:, None] * along
    return np.einsum("ij,ij->i", rest, rest)


def to_triangle(a, b, c, p):
    """Squared distances of points from triangles: the nearest of the three edges and the foot of the perpendicular."""
    best = np.minimum(np.minimum(to_segment(a, b, p), to_segment(b, c, p)), to_segment(c, a, p))
    normal = np.cross(b - a, c - a)
    area = np.einsum("ij,ij->i", normal, normal)
    over = area > 0
    for u, v in ((a, b), (b, c), (c, a)):
        over &= np.einsum("ij,ij->i", np.cross(normal, v - u), p - u) >= 0
    height = np.einsum("ij,ij->i", normal, p - a)
    return np.where(over, height * height / np.where(over, area, 1), best)


def brute_force(body, points, batch=500):
    """Distances of points from a mesh. In double precision only what cannot be nearest is left out."""
    corners = body.points[body.triangles]
    middles = corners.mean(axis=1)
    reach = np.linalg.norm(corners - middles[:, None], axis=2).max(axis=1)
    result = np.zeros(len(points), dtype=LONG)
    for start in range(0, len(points), batch):
        p = points[start : start + batch]
        scale = np.abs(p).max() + np.abs(middles).max()
        apart = np.sqrt(np.maximum(squared_distances(p, middles), 0))
        slack = 1e-7 * scale  # many times the rounding of the line above
        most = (apart + reach).min(axis=1) + slack
        query, triangle = np.nonzero(apart - reach - slack <= most[:, None])
        exact = corners[triangle].astype(LONG)
        squared = to_triangle(exact[:, 0], exact[:, 1], exact[:, 2], p[query].astype(LONG))
        first = np.flatnonzero(np.diff(query, prepend=-1))
        result[start : start + batch] = np.sqrt(np.minimum.reduceat(squared, first))
    return result


def squared_distances(p, q):
    return (p * p).sum(axis=1)[:, None] + (q * q).sum(axis=1)[None] - 2 * p @ q.T
