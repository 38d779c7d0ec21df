# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Many operands in one call: right, and with no more contacts than there must be.

How the time grows is measured by Testing/Benchmarks; here the work is counted. Where faces coincide
or all cross each other, also the time of the cuts is compared, between sizes and in one process.
"""

import functools

import numpy as np
import pytest

import measures
import meshes
from booleans import DIFFERENCE, INTERSECTION, RESOLVE, UNION, boolean

BALL = meshes.lattice_sphere(0.4, around=16, along=9)
HALF_SUNK = measures.convex_intersection_volume(BALL, meshes.box((-1, -1, -1), (1, 1, 0)))


def plate_and_balls(count):
    """A plate with `count` balls half sunk into its top, on a grid with some disorder.

    The balls are moved by whole steps of their lattice, so that each is the same solid exactly.
    """
    columns = int(np.ceil(np.sqrt(count)))
    rng = np.random.default_rng(10)
    places = np.array([(i % columns, i // columns) for i in range(count)], dtype=float)
    places += np.round(rng.uniform(-0.08, 0.08, places.shape) * 2**20) / 2**20
    plate = meshes.box((-1, -1, -1), (columns, columns, 0))
    return plate, [meshes.moved(BALL, (x, y, 0.0)) for x, y in places]


@functools.lru_cache(maxsize=None)
def bored_plate(count):
    plate, balls = plate_and_balls(count)
    return boolean([plate], [meshes.joined(*balls)], DIFFERENCE)


@pytest.mark.parametrize("count", [10, 100, 1000])
def test_a_plate_minus_spheres_is_closed_and_has_the_exact_volume(count):
    plate, _ = plate_and_balls(count)
    result = bored_plate(count)
    assert result.status == 0 and not result.errors
    assert measures.open_edges(result.body) == 0
    expected = measures.exact_volume(plate) - count * HALF_SUNK
    assert result.volume == pytest.approx(float(expected), rel=1e-12)


def test_the_spheres_may_be_a_thousand_operands():
    plate, balls = plate_and_balls(1000)
    result = boolean([plate], balls, DIFFERENCE)
    assert result.status == 0 and measures.open_edges(result.body) == 0
    assert result.volume == pytest.approx(bored_plate(1000).volume, rel=1e-13)
    assert result.surface.GetNumberOfCells() == bored_plate(1000).surface.GetNumberOfCells()
    assert set(np.unique(result.cell_data["SourceId"])) == set(range(1001))


def test_contacts_and_cells_grow_as_the_spheres_do():
    """Ten times the spheres: ten times the contacts and the cells, but for the grid's diagonal."""
    small, large = bored_plate(100), bored_plate(1000)
    for count in (
        lambda result: int(result.field_data["ContactCount"][0]),
        lambda result: result.surface.GetNumberOfCells(),
        lambda result: result.curves.GetNumberOfPoints(),
    ):
        assert 9.5 < count(large) / count(small) < 10.5
    assert large.curves.GetNumberOfLines() >= 1000


def test_cutting_does_not_spoil_the_top_of_the_plate():
    """All 16,000 seam points lie in two triangles; their pieces fill the top less the holes."""
    result = bored_plate(1000)
    corners = result.body.points[result.body.triangles]
    top = np.all(corners[:, :, 2] == 0.0, axis=1) & (result.cell_data["SourceId"] == 0)
    plate, _ = plate_and_balls(1000)
    equator = 16 / 2 * np.sin(2 * np.pi / 16) * 0.4**2
    side = plate.points[:, 0].max() + 1
    area = measures.area(meshes.mesh(result.body.points, result.body.triangles[top]))
    assert area == pytest.approx(
        side**2 - 1000 * equator, rel=1e-6
    )  # the lattice moves the equator


def overlapping_balls(count):
    rng = np.random.default_rng(11)
    ball = meshes.sphere(0.4, around=24, along=13)
    return [
        meshes.moved(meshes.turned(ball, meshes.random_rotation(rng)), rng.uniform(-1, 1, 3))
        for _ in range(count)
    ]


def test_fifty_overlapping_spheres_are_united_in_one_call():
    balls = overlapping_balls(50)
    result = boolean(balls, [], UNION)
    assert result.status == 0 and not result.errors
    assert measures.open_edges(result.body) == 0
    rng = np.random.default_rng(12)
    points = measures.probes(rng, [*balls, result.body], 500, 1e-7)
    expected = measures.inside(meshes.joined(*balls), points)
    assert np.array_equal(measures.inside(result.body, points), expected)
    assert measures.winding(result.body, points).max() == 1


def test_fifty_spheres_in_one_mesh_resolve_to_the_same():
    balls = overlapping_balls(50)
    united, resolved = boolean(balls, [], UNION), boolean([meshes.joined(*balls)], [], RESOLVE)
    assert measures.open_edges(resolved.body) == 0
    assert resolved.volume == pytest.approx(united.volume, rel=1e-13)
    assert resolved.area == pytest.approx(united.area, rel=1e-12)


def test_many_inputs_against_many_tools():
    """Volumes add up over unions of operands too."""
    balls = overlapping_balls(24)
    inputs, tools = balls[:12], balls[12:]
    a, b = boolean(inputs, [], UNION).volume, boolean(tools, [], UNION).volume
    found = {op: boolean(inputs, tools, op).volume for op in (UNION, INTERSECTION, DIFFERENCE)}
    assert found[UNION] + found[INTERSECTION] == pytest.approx(a + b, rel=1e-12)
    assert found[DIFFERENCE] == pytest.approx(a - found[INTERSECTION], rel=1e-12)


def test_more_than_sixty_four_operands_common_to_all():
    """No bit mask of operands: sixty-eight nested boxes, and two across them all."""
    boxes = [meshes.box((-1 - k / 256,) * 3, (1 + k / 256,) * 3) for k in range(68)]
    boxes += [meshes.box((-0.5, -3, -3), (3, 3, 3)), meshes.box((-3, -3, -3), (0.25, 3, 0.5))]
    result = boolean(boxes, [], INTERSECTION)
    assert result.status == 0 and measures.open_edges(result.body) == 0
    assert result.volume == pytest.approx(0.75 * 2 * 1.5, rel=1e-14)
    assert result.area == pytest.approx(2 * (0.75 * 2 + 2 * 1.5 + 0.75 * 1.5), rel=1e-14)


def seconds_of_cuts(result):
    stages = result.field_data
    return float(dict(zip(stages["StageNames"], stages["StageSeconds"]))["Cuts"])


def boxes_along_a_diagonal(count):
    return [meshes.box((k / 256,) * 3, (1 + k / 256,) * 3) for k in range(count)]


def test_a_hundred_boxes_that_all_overlap_each_other():
    """Sixteen times the contacts of 25 boxes, and about as many times the time."""
    few = min(seconds_of_cuts(boolean(boxes_along_a_diagonal(25), [], UNION)) for _ in range(3))
    boxes = boxes_along_a_diagonal(100)
    common, united = boolean(boxes, [], INTERSECTION), boolean(boxes, [], UNION)
    for result in (common, united):
        assert result.status == 0 and measures.open_edges(result.body) == 0
    assert common.volume == pytest.approx((1 - 99 / 256) ** 3, rel=1e-14)
    assert united.volume == pytest.approx(1 + 99 * (1 - (255 / 256) ** 3), rel=1e-13)
    assert seconds_of_cuts(united) < 80 * few + 0.05


def test_boxes_in_a_row_have_four_planes_in_common():
    boxes = [meshes.box((k / 128, -1, -1), (1 + k / 128, 1, 1)) for k in range(20)]
    result = boolean(boxes, [], UNION)
    assert result.status == 0 and measures.open_edges(result.body) == 0
    assert result.volume == pytest.approx(4 * (1 + 19 / 128), rel=1e-14)
    assert result.area == pytest.approx(8 + 8 * (1 + 19 / 128), rel=1e-14)


def unit_cubes(size):
    corners = np.stack(np.meshgrid(*[np.arange(size, dtype=float)] * 3), axis=-1).reshape(-1, 3)
    return [meshes.box(low, low + 1) for low in corners]


@pytest.mark.parametrize("as_one", [False, True])
def test_a_thousand_voxels_become_one_block(as_one):
    cubes = unit_cubes(10)
    result = (
        boolean([meshes.joined(*cubes)], [], RESOLVE) if as_one else boolean(cubes, [], UNION)
    )
    assert result.status == 0 and measures.open_edges(result.body) == 0
    assert result.volume == 1000 and result.area == 600
    assert result.surface.GetNumberOfCells() == 1200  # nothing is cut: each square has its two


def plate_and_flush_cylinder(sides):
    """A cylinder on a plate: its lower cap, a fan around one corner, is in the plane of the top."""
    plate = meshes.box((-2, -2, -1), (2, 2, 0))
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    points = np.concatenate([np.column_stack([ring, np.full(sides, z)]) for z in (0.0, 1.0)])
    here, there = np.arange(sides), np.roll(np.arange(sides), -1)
    fan = np.column_stack([np.zeros(sides - 2, dtype=int), here[1:-1], there[1:-1]])
    faces = [
        np.column_stack([here, there, there + sides]),
        np.column_stack([here, there + sides, here + sides]),
        fan[:, ::-1],
        fan + sides,
    ]
    area = sides / 2 * np.sin(2 * np.pi / sides)
    return plate, meshes.mesh(points, np.concatenate(faces)), 16 + area


def test_a_cylinder_of_many_sides_stands_on_a_plate():
    """Eight times the sides, and not much more than eight times the time."""
    few = min(
        seconds_of_cuts(boolean(*[[m] for m in plate_and_flush_cylinder(500)[:2]], UNION))
        for _ in range(3)
    )
    plate, cylinder, volume = plate_and_flush_cylinder(4000)
    result = boolean([plate], [cylinder], UNION)
    assert result.status == 0 and measures.open_edges(result.body) == 0
    assert result.volume == pytest.approx(volume, rel=1e-12)
    assert seconds_of_cuts(result) < 30 * few + 0.05
