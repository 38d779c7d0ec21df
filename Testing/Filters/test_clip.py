# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Clipped closed surfaces are closed, in the strict sense of vtkFeatureEdges, wherever the planes lie.

Both halves of a cut add up, share the points of the cap byte for byte, and are what the exact
arrangement with a large block makes of them.
"""

import itertools

import numpy as np
import pytest

import measures
import meshes
from booleans import INTERSECTION, boolean, polydata
from clips import bad_edges, clip, feature_edges, turned_planes


def ring():
    """A square ring of unit cells with a dent, as a voxel surface: every corner is an integer."""
    cells = np.ones((6, 6, 4), dtype=bool)
    cells[2:4, 2:4, :] = False
    cells[2:4, :, 2] = False
    corners, faces = {}, []
    padded = np.pad(cells, 1)
    for cell in np.argwhere(cells):
        for axis, side in itertools.product(range(3), (-1, 1)):
            step = np.eye(3, dtype=int)[axis] * side
            if padded[tuple(cell + 1 + step)]:
                continue
            u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
            start = cell + np.maximum(step, 0)
            square = [start, start + u, start + u + v, start + v][::side]
            ids = [corners.setdefault(tuple(corner), len(corners)) for corner in square]
            faces += [[ids[0], ids[1], ids[2]], [ids[0], ids[2], ids[3]]]
    return meshes.mesh(list(corners), faces)


def bodies():
    torus = meshes.torus(2.0, 1.0, 24, 12)
    nested = meshes.joined(meshes.cube(6.0), meshes.inside_out(meshes.cube(2.0)))
    result = {
        "cube": meshes.cube(4.0),
        "ring": ring(),
        "torus": meshes.mesh(np.round(torus.points * 8) / 8, torus.triangles),
        "nested": nested,
    }
    if meshes.CGAL_DATA.exists():
        for name in ("elephant", "cow", "knot1", "fandisk"):
            result[name] = meshes.cgal_mesh(name)
    return result


BODIES = bodies()


def planes_through(body, rng, count):
    """Planes through vertices, along edges, in faces, along the axes, and anywhere."""
    lower, upper = body.points.min(axis=0), body.points.max(axis=0)
    for number in range(count):
        corners = body.points[body.triangles[rng.integers(len(body.triangles))]]
        origin, normal = corners[0], rng.normal(size=3)
        kind = number % 5
        if kind == 0:
            normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        elif kind == 1:
            normal = np.cross(corners[1] - corners[0], normal)
        elif kind == 2:
            normal = np.eye(3)[rng.integers(3)] * rng.choice([-1, 1])
        elif kind == 3:
            origin, normal = np.round(rng.uniform(lower, upper)), rng.integers(-2, 3, 3)
        else:
            origin = rng.uniform(lower, upper)
        if np.any(normal):
            yield tuple(origin.tolist()), tuple(np.asarray(normal, dtype=float).tolist())


def assert_halves(body, plane):
    front, back = clip(body, [plane]), clip(body, turned_planes([plane]))
    for half in (front, back):
        assert half.status == 0 and not half.errors and not half.warnings
        assert bad_edges(half.body) == 0, plane
    whole = measures.volume(body)
    assert abs(front.volume + back.volume - whole) <= 1e-12 * abs(whole), plane
    return front, back


@pytest.mark.parametrize("name", BODIES)
def test_a_thousand_planes_leave_closed_manifolds_that_add_up(name):
    """Over all bodies; a fifth of the planes each through vertices, edges, faces, grids, anywhere."""
    rng = np.random.default_rng([21, list(BODIES).index(name)])
    count = 1000 // len(BODIES) + 1
    for number, plane in enumerate(planes_through(BODIES[name], rng, count)):
        front, _ = assert_halves(BODIES[name], plane)
        if number % 25 == 0:
            assert feature_edges(front.surface) == 0


@pytest.mark.parametrize("name", BODIES)
def test_both_halves_share_the_points_of_the_cap_byte_for_byte(name):
    body = BODIES[name]
    rng = np.random.default_rng(3)
    plane = (tuple(body.points.mean(axis=0).tolist()), tuple(rng.normal(size=3).tolist()))
    front, back = assert_halves(body, plane)
    assert front.cap_points == back.cap_points != set()
    assert front.cap_points <= {p.tobytes() for p in front.body.points + 0.0}
    both = clip(body, [plane], InsideOut=True)
    assert both.bytes() == back.bytes()


def block(plane, size):
    """A large box on the front side of a plane."""
    origin, normal = np.asarray(plane[0]), np.asarray(plane[1]) / np.linalg.norm(plane[1])
    box = meshes.box((-size, -size, 0.0), (size, size, size))
    return meshes.moved(meshes.turned(box, meshes.rotation_from_z(normal)), origin)


@pytest.mark.parametrize("name", BODIES)
def test_volumes_are_those_of_the_exact_arrangement(name):
    body = BODIES[name]
    extent = float(np.abs(body.points).max())
    # Along the axes the block's sides are exactly in the planes.
    at = tuple((0.37 * body.points.min(axis=0) + 0.63 * body.points.max(axis=0)).tolist())
    planes = [(at, (1.0, 0.0, 0.0)), (at, (0.0, -1.0, 0.0)), (at, (0.0, 0.0, 1.0))]
    lower = [at[0], -9 * extent, at[2]]
    upper = [9 * extent, at[1], 9 * extent]
    judge = boolean([body], [meshes.box(lower, upper)], INTERSECTION)
    mine = clip(body, planes)
    assert bad_edges(mine.body) == 0
    assert abs(mine.volume - judge.volume) <= 1e-12 * abs(measures.volume(body))
    # At an angle, the block is rounded.
    tilted = (at, (0.3, -0.5, 0.8))
    judge = boolean([body], [block(tilted, 9 * extent)], INTERSECTION)
    allowed = 1e-12 * abs(measures.volume(body)) + measures.rounding(body)
    assert abs(clip(body, [tilted]).volume - judge.volume) <= 20 * allowed


def test_many_planes_at_once_are_as_good_as_one_after_the_other():
    rng = np.random.default_rng(5)
    for name, body in BODIES.items():
        for _ in range(6):
            planes = list(planes_through(body, rng, 3))
            at_once = clip(body, planes)
            assert bad_edges(at_once.body) == 0, (name, planes)
            step = body
            for plane in planes:
                step = clip(step, [plane]).body
            assert abs(measures.volume(step) - at_once.volume) <= (
                1e-12 * abs(measures.volume(body))
            ), (name, planes)


def test_a_box_at_once_is_its_six_planes():
    body = BODIES["torus"]
    box = (-2.5, 2.25, -1.0, 3.0, -0.5, 0.5)
    boxed = clip(body, UseBox=True, Box=box)
    judge = boolean([body], [meshes.box(box[::2], box[1::2])], INTERSECTION)
    assert bad_edges(boxed.body) == 0
    assert boxed.volume == pytest.approx(judge.volume, rel=1e-12)
    assert set(boxed.cell_data["SourceId"].tolist()) == {0, 1, 2, 3, 5, 6}  # ymax is outside


def test_planes_may_remove_everything_or_nothing():
    body = BODIES["cube"]
    for distance in (2.0, 2.5, 1e9):
        nothing = clip(body, [((distance, 0, 0), (1, 0, 0))])
        assert nothing.surface.GetNumberOfCells() == nothing.surface.GetNumberOfPoints() == 0
        everything = clip(body, [((-distance, 0, 0), (1, 0, 0))])
        assert np.array_equal(everything.body.points, body.points) or distance == 2.0
        assert everything.volume == 64.0 and bad_edges(everything.body) == 0
        assert set(everything.cell_data["SourceId"].tolist()) == {0}
    assert clip(body).volume == 64.0


def test_a_face_in_the_plane_is_kept_with_its_own_cells():
    kept = clip(BODIES["cube"], [((0, 0, -2), (0, 0, 1))])
    assert sorted(kept.cell_data["OriginalCellId"].tolist()) == list(range(12))


def test_inside_out_shells_are_holes_and_alone_they_cap_inside_out():
    nested = BODIES["nested"]
    half = clip(nested, [((0, 0, 0), (0, 0, 1))])
    assert half.volume == 108.0 - 4.0
    assert half.field_data["CapArea"][0] == 36.0 - 4.0
    alone = clip(meshes.inside_out(meshes.cube(2.0)), [((0, 0, 0.5), (0, 0, 1))])
    assert alone.volume == -2.0 and bad_edges(alone.body) == 0


def test_several_surfaces_are_several_solids():
    pair = meshes.joined(meshes.cube(2.0), meshes.cube(2.0, (4, 0, 0)), meshes.cube(2.0, (1, 1, 0)))
    half = clip(pair, [((0, 0, 0.5), (0, 0, -1))])
    assert half.volume == pytest.approx(3 * 6.0, rel=1e-15)
    assert bad_edges(half.body) == 0  # although the first and the third overlap


def test_untouched_points_keep_their_bytes_and_untouched_polygons_their_corners():
    quads = polydata(meshes.cube(2.0), meshes.BOX_QUADS.tolist())
    half = clip(quads, [((0, 0, 0.25), (0, 0, 1))])
    sizes = [half.surface.GetCell(i).GetNumberOfPoints() for i in range(half.surface.GetNumberOfCells())]
    assert sizes.count(4) == 1  # the top
    above = {p.tobytes() for p in meshes.cube(2.0).points if p[2] > 0.25}
    assert above <= {p.tobytes() for p in half.body.points}


def test_the_result_does_not_depend_on_the_number_of_threads():
    body = meshes.bumpy_sphere(np.random.default_rng(1), 6)
    planes = [((0.1, 0.2, 0.3), (1, 2, 3)), ((0, 0, 0.1), (-1, 0.5, 0.25))]
    settings = {"GenerateOutline": True, "ScalarMode": 2}
    results = {clip(body, planes, NumberOfThreads=n, **settings).bytes() for n in (1, 2, 3, 0)}
    assert len(results) == 1


def test_a_plane_far_from_its_origin_is_the_same_plane():
    body = BODIES["torus"]
    near = clip(body, [((0, 0, 0.25), (0, 0, 1))])
    far = clip(body, [((1e12, -3e11, 0.25), (0, 0, 5e-9))])
    assert near.bytes() == far.bytes()


def test_more_planes_than_a_vertex_has_bits_for():
    angles = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    planes = [((np.cos(a), np.sin(a), 0), (-np.cos(a), -np.sin(a), 0)) for a in angles]
    prism = clip(meshes.cube(4.0), planes)
    assert bad_edges(prism.body) == 0
    assert prism.volume == pytest.approx(4.0 * 24 * np.tan(np.pi / 24), rel=1e-12)
    assert set(prism.cell_data["SourceId"].tolist()) == set(range(25))
