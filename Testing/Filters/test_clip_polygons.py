# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Flat polygons stay polygons through all planes: few triangles, and still a closed manifold."""

import numpy as np
import pytest

import measures
import meshes
from booleans import cells_of, polydata, points_of, triangles_of
from clips import bad_edges, clip, cut, turned_planes


def prism(outline, height):
    """A prism over a polygon, with whole polygons for its caps: a vtkPolyData and its volume."""
    outline = np.asarray(outline, dtype=float)
    count = len(outline)
    points = np.vstack([np.column_stack([outline, np.full(count, z)]) for z in (0.0, height)])
    following = np.roll(np.arange(count), -1)
    polygons = [[i, n, n + count, i + count] for i, n in zip(range(count), following)]
    polygons += [list(range(count))[::-1], list(range(count, 2 * count))]
    rolled = outline[following]
    area = 0.5 * np.sum(outline[:, 0] * rolled[:, 1] - outline[:, 1] * rolled[:, 0])
    return polydata(meshes.mesh(points, []), polygons), area * height


STAR = [
    (r * x, r * y)
    for r, (x, y) in zip(
        [8, 3] * 6,
        [(8, 0), (7, 4), (4, 7), (0, 8), (-4, 7), (-7, 4), (-8, 0), (-7, -4), (-4, -7), (0, -8), (4, -7), (7, -4)],
    )
]
BODIES = {
    "box": prism([(-4, -4), (4, -4), (4, 4), (-4, 4)], 8),
    "ell": prism([(0, 0), (8, 0), (8, 2), (2, 2), (2, 8), (0, 8)], 4),
    "comb": prism([(0, 0), (9, 0), (9, 6), (7, 6), (7, 2), (5, 2), (5, 6), (3, 6), (3, 2), (1, 2), (1, 6), (0, 6)], 3),
    "star": prism(STAR, 16),
}


def random_planes(data, rng, count):
    points = points_of(data)
    lower, upper = points.min(axis=0), points.max(axis=0)
    for number in range(count):
        if number % 3 == 0:
            normal = rng.integers(-2, 3, 3).astype(float)
            origin = points[rng.integers(len(points))]
        elif number % 3 == 1:
            normal = np.eye(3)[rng.integers(3)] * rng.choice([-1, 1])
            origin = np.round(rng.uniform(lower, upper))
        else:
            normal, origin = rng.normal(size=3), rng.uniform(lower, upper)
        if np.any(normal):
            yield tuple(origin.tolist()), tuple(normal.tolist())


@pytest.mark.parametrize("name", BODIES)
def test_any_plane_leaves_closed_manifolds_that_add_up(name):
    data, volume = BODIES[name]
    rng = np.random.default_rng([31, len(name)])
    for plane in random_planes(data, rng, 120):
        halves = clip(data, [plane]), clip(data, turned_planes([plane]))
        for half in halves:
            assert bad_edges(half.body) == 0, plane
        assert halves[0].volume + halves[1].volume == pytest.approx(volume, rel=1e-13), plane


@pytest.mark.parametrize("name", BODIES)
def test_many_planes_give_what_the_triangles_alone_give(name):
    data, volume = BODIES[name]
    triangles = triangles_of(clip(data, []).surface)[0]  # whole polygons, cut into fans
    by_triangles = measures.volume(triangles) == pytest.approx(volume, rel=1e-13)
    rng = np.random.default_rng([32, len(name)])
    for _ in range(40):
        planes = list(random_planes(data, rng, 3))
        result = clip(data, planes)
        assert bad_edges(result.body) == 0, planes
        rest = clip(data, planes, InsideOut=True)
        assert bad_edges(rest.body) == 0, planes
        assert result.volume + rest.volume == pytest.approx(volume, rel=1e-13), planes
        if by_triangles:
            assert result.volume == pytest.approx(clip(triangles, planes).volume, rel=1e-12, abs=1e-12 * volume)


def test_a_cut_box_has_the_least_number_of_triangles():
    data, _ = BODIES["box"]
    half = clip(data, [((0.5, 0, 0), (1, 0, 0))])
    assert len(half.cell_data["SourceId"]) == 1 + 4 * 2 + 2  # one whole side, four cut ones, the cap
    assert len(half.body.points) == 8
    corner = clip(data, [((1, 1, 5), (1, 2, 1)), ((1, 1, 5), (-1, 1, 2))])
    polygons = len(corner.body.points)
    assert bad_edges(corner.body) == 0
    # A closed surface of genus 0 has 2 n - 4 triangles, however often it was cut.
    assert len(corner.body.triangles) == 2 * polygons - 4


def test_a_sequence_of_planes_does_not_shred_the_faces():
    data, _ = BODIES["comb"]
    planes = [((4.5, 3, 1.5), (np.cos(a), np.sin(a), 0.3)) for a in np.linspace(2, 2.1, 5)]
    at_once = clip(data, planes)
    # Points lie where the planes cut edges and each other, and nowhere else.
    used = {p.tobytes() for p in at_once.body.points[np.unique(at_once.body.triangles)] + 0.0}
    assert len(used) == len(np.unique(at_once.body.triangles))
    diagonal_free = sum(1 for p in at_once.body.points if np.isclose(p[2], [0, 3]).any())
    assert diagonal_free > 0 and bad_edges(at_once.body) == 0
    assert len(at_once.body.triangles) <= 2 * len(at_once.body.points) - 4 + 4


def test_cross_sections_have_no_points_on_the_diagonals_of_polygons():
    section = cut(BODIES["comb"][0], (0, 0, 1.3), (0, 0, 1), Triangulate=False)
    offsets, _ = cells_of(section.surface.GetLines())
    assert np.diff(offsets).tolist() == [12 + 1]
    filled = cut(BODIES["comb"][0], (0, 0, 1.3), (0, 0, 1))
    assert len(filled.body.triangles) == 10
