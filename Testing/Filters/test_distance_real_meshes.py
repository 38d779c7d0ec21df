# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Distances to thirty real meshes from libcgal-demo: against brute force in long double, the sign against winding
numbers. Points lie all over space, close to faces, edges and vertices, on them, and far away."""

import numpy as np
import pytest

import measures
import meshes
from distances import cloud, distances
from reference_distance import brute_force

pytestmark = pytest.mark.skipif(
    not meshes.CGAL_DATA.exists(), reason="the package libcgal-demo is not installed"
)

PLAIN = """elephant dino hand blob-closed 3torus P cross fandisk knot1 rotor anchor spool pinion couplingdown joint bull
    cactus anchor_dense helmet femur retinal eight handle knot blobby star sphere966""".split()
OVERLAPPING = ["bones", "camel", "cow", "elk"]  # they run through themselves: a nearest face may lie inside
COUNT = 300  # points a mesh and kind; more take longer and find no more
PRECISION = 1e-14  # of the size of the box, which is 2 here


def places(body, rng, count):
    """Points of all kinds, and which of them lie on the surface as nearly as doubles can say."""
    corners = body.points[body.triangles[rng.integers(0, len(body.triangles), count)]]
    third = count // 3
    weights = rng.dirichlet((1, 1, 1), count)
    weights[:third] = np.eye(3)[rng.integers(0, 3, third)]  # vertices
    weights[third : 2 * third] *= 1 - np.eye(3)[rng.integers(0, 3, third)]  # points of edges
    weights /= weights.sum(axis=1)[:, None]
    surface = np.einsum("ij,ijk->ik", weights, corners)
    direction = rng.normal(size=surface.shape)
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    near = surface + direction * 10.0 ** rng.uniform(-6, -0.5, (count, 1))
    lower, upper = body.points.min(axis=0), body.points.max(axis=0)
    return {
        "anywhere": rng.uniform(lower - 0.5 * (upper - lower), upper + 0.5 * (upper - lower), (count, 3)),
        "near": near,
        "on": surface,
        "far": direction[: count // 20] * 1e6 * np.linalg.norm(upper - lower),
    }


def is_inside(body, points):
    return measures.winding(body, points) != 0


@pytest.mark.parametrize("name", PLAIN + OVERLAPPING)
def test_distances_and_signs(name):
    body = meshes.cgal_mesh(name)
    rng = np.random.default_rng([4, len(name), len(body.triangles)])
    for kind, points in places(body, rng, COUNT).items():
        found = distances(cloud(points), body)
        wanted = brute_force(body, points)
        limit = PRECISION * max(2.0, float(wanted.max()))
        assert np.abs(np.abs(found) - wanted).max() <= limit, kind
        apart = wanted > 1e-12
        if kind == "on":
            assert np.abs(found).max() <= limit
            continue
        inside = is_inside(body, points[apart])
        by_winding = distances(cloud(points), body, SignMethod=1)
        if name in PLAIN:
            assert np.array_equal(found[apart] < 0, inside), kind
            assert np.array_equal(found[apart], by_winding[apart]), kind
        assert np.array_equal(by_winding[apart] < 0, inside), kind
