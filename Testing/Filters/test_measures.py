# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The referee is checked first: its measures of known shapes, and that it sees what is broken."""

from fractions import Fraction

import numpy as np
import pytest

import meshes
from measures import (
    area,
    convex_intersection_volume,
    exact_volume,
    expected_inside,
    is_closed,
    is_exactly_convex,
    non_manifold_edges,
    open_edges,
    solid_angle_winding,
    volume,
    voxel_volume_and_area,
    winding,
)


def prism_area(around):
    """Area of a regular polygon in the unit circle."""
    return around / 2 * np.sin(2 * np.pi / around)


SHAPES = {
    "box": (meshes.box((1, 2, 3), (3, 5, 8)), 30.0),
    "cylinder": (meshes.cylinder(1.0, 3.0, around=40), 3 * prism_area(40)),
    "lying cylinder": (meshes.cylinder(1.0, 3.0, (4, 5, 6), 40, (1, 2, 3)), 3 * prism_area(40)),
    "cone": (meshes.cone(1.0, 3.0, around=40), prism_area(40)),
    "octahedron": (meshes.sphere(1.0, around=4, along=3), 4 / 3),
}


@pytest.mark.parametrize("name", SHAPES)
def test_the_volume_of_a_known_shape_is_right_and_its_surface_closed(name):
    body, expected = SHAPES[name]
    assert volume(body) == pytest.approx(expected, rel=1e-14)
    assert float(exact_volume(body)) == pytest.approx(expected, rel=1e-13)
    assert volume(meshes.inside_out(body)) == pytest.approx(-expected, rel=1e-14)
    assert is_closed(body) and non_manifold_edges(body) == 0


def test_the_exact_volume_of_a_box_has_no_rounding():
    assert exact_volume(meshes.box((0, 0, 0), (0.1, 0.1, 0.1))) == Fraction(0.1) ** 3
    assert exact_volume(meshes.box((1e-30, 0, 0), (1e30, 1, 1))) == Fraction(1e30) - Fraction(1e-30)


def test_the_area_of_a_known_shape_is_right():
    assert area(meshes.box((0, 0, 0), (1, 2, 3))) == pytest.approx(22.0, rel=1e-15)


def test_a_volume_does_not_suffer_from_distance():
    far = meshes.moved(meshes.cube(1.0), (2.0**40, -(2.0**40), 2.0**30))
    assert volume(far) == 1.0


def test_closedness_sees_a_missing_a_turned_and_a_doubled_triangle():
    body = meshes.sphere(1.0)
    assert open_edges(meshes.mesh(body.points, body.triangles[1:])) == 3
    turned = body.triangles.copy()
    turned[7] = turned[7][::-1]
    assert open_edges(meshes.mesh(body.points, turned)) == 3
    assert (
        open_edges(meshes.mesh(body.points, np.vstack([body.triangles, body.triangles[:1]]))) == 3
    )


def test_closedness_goes_by_coordinates_not_by_ids():
    body = meshes.cube()
    soup = meshes.mesh(body.points[body.triangles].reshape(-1, 3), np.arange(36).reshape(-1, 3))
    assert is_closed(soup)
    soup.points[0, 0] = np.nextafter(soup.points[0, 0], 1.0)
    assert open_edges(soup) > 0


def test_two_cubes_that_share_an_edge_are_closed_and_not_manifold():
    pair = meshes.joined(meshes.box((0, 0, 0), (1, 1, 1)), meshes.box((1, 1, 0), (2, 2, 1)))
    assert is_closed(pair)
    assert non_manifold_edges(pair) == 1


def test_a_t_junction_is_an_open_edge():
    body = meshes.cube()
    a, b, c = body.triangles[0]
    points = np.vstack([body.points, (body.points[a] + body.points[b]) / 2])
    split = np.vstack([body.triangles[1:], [[a, 8, c], [8, b, c]]])
    assert open_edges(meshes.mesh(points, split)) == 3


@pytest.mark.parametrize("seed", range(4))
def test_two_methods_find_the_same_winding_numbers(seed):
    rng = np.random.default_rng(seed)
    blob = meshes.bumpy_sphere(rng, level=2)
    pile = meshes.joined(
        blob, meshes.moved(blob, (0.3, 0.2, 0.1)), meshes.inside_out(meshes.cube(0.5))
    )
    points = rng.uniform(-1.5, 1.5, (400, 3))
    counted = winding(pile, points)
    assert np.abs(counted - solid_angle_winding(pile, points)).max() < 1e-9
    assert {-1, 0, 1, 2} & set(counted.tolist()) >= {0, 1, 2}


def test_a_ray_through_edges_and_corners_is_counted_once():
    stacked = meshes.box_soup([((0, 0, 0), (2, 2, 2)), ((1, 1, 1), (3, 3, 3))])
    grid = np.stack(np.meshgrid(*[[-0.5, 0.5, 1.5, 2.5]] * 3, indexing="ij"), axis=-1).reshape(
        -1, 3
    )
    expected = np.all((grid > 0) & (grid < 2), axis=1).astype(int)
    expected += np.all((grid > 1) & (grid < 3), axis=1)
    assert np.array_equal(winding(stacked, grid), expected)  # 0.5 0.5 lies on a diagonal


def test_inside_follows_the_definition_of_each_operation():
    a, b = meshes.box((0, 0, 0), (2, 2, 2)), meshes.box((1, 0, 0), (3, 2, 2))
    points = np.array([[0.5, 1, 1.1], [1.5, 1, 1.1], [2.5, 1, 1.1], [3.5, 1, 1.1]])
    table = {
        "Union": [True, True, True, False],
        "Intersection": [False, True, False, False],
        "Difference": [True, False, False, False],
        "SymmetricDifference": [True, False, True, False],
    }
    for operation, expected in table.items():
        assert expected_inside(operation, [a], [b], points).tolist() == expected
    assert expected_inside("Intersection", [a, b], [], points).tolist() == table["Intersection"]


def test_the_exact_convex_reference_agrees_with_analytic_answers():
    a = meshes.box((0, 0, 0), (1, 1, 1))
    assert convex_intersection_volume(a, meshes.box((0.25, 0.5, -1), (2, 2, 0.75))) == Fraction(
        9, 32
    )
    assert convex_intersection_volume(a, a) == 1
    assert convex_intersection_volume(a, meshes.box((1, 0, 0), (2, 1, 1))) == 0
    octahedron = meshes.sphere(1.0, around=4, along=3)
    quarter = convex_intersection_volume(meshes.box((0, 0, 0), (2, 2, 2)), octahedron)
    assert float(quarter) == pytest.approx(1 / 6, rel=1e-15)


@pytest.mark.parametrize("seed", range(5))
def test_the_exact_convex_reference_is_symmetric(seed):
    rng = np.random.default_rng(seed)
    a, b = meshes.random_convex_body(rng), meshes.random_convex_body(rng)
    assert is_exactly_convex(a) and is_exactly_convex(b)
    assert convex_intersection_volume(a, b) == convex_intersection_volume(b, a)
    assert convex_intersection_volume(a, a) == exact_volume(a)


def test_voxels_measure_a_soup_of_boxes():
    boxes = [
        (np.array(l), np.array(u)) for l, u in [((0, 0, 0), (2, 2, 2)), ((1, 1, 1), (3, 3, 3))]
    ]
    assert voxel_volume_and_area(meshes.voxels(boxes, 4) >= 1) == (15, 42)


def test_the_real_meshes_are_classified():
    closed = {name: is_closed(meshes.cgal_mesh(name)) for name in ("elephant", "cow", "diplodocus")}
    assert all(closed.values())
    assert not is_closed(meshes.cgal_mesh("nefertiti"))
    assert non_manifold_edges(meshes.cgal_mesh("diplodocus")) == 2
    assert volume(meshes.cgal_mesh("ellipe0.003")) < 0
