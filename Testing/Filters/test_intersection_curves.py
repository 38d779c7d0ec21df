# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The curves of vtkPolyDataIntersection against what geometry says of their lengths, loops and branch points."""

import numpy as np
import pytest

import measures
import meshes
from intersections import assert_sound, intersection
from meshes import box, mesh


def plane(*corners):
    """A quadrilateral of two triangles."""
    return mesh(np.array(corners, dtype=float), [[0, 1, 2], [0, 2, 3]])


def level(height, reach=4.0):
    return plane((-reach, -reach, height), (reach, -reach, height), (reach, reach, height), (-reach, reach, height))


# ---- analytic cases -----------------------------------------------------------------------------


@pytest.mark.parametrize("height", (0.0, 0.3125, -0.4375))
def test_a_plane_cuts_a_sphere_in_a_circle(height):
    errors = []
    for fine in (40, 80):
        ball = meshes.sphere(1.0, around=2 * fine, along=fine)
        cut = intersection(ball, level(height))
        assert_sound(cut, ball, level(height))
        assert (len(cut.polylines), cut.loops) == (1, 1)
        circle = 2 * np.pi * np.sqrt(1 - height**2)
        errors.append(abs(cut.length - circle) / circle)
        assert np.all(cut.points[:, 2] == height)
    assert errors[0] < 3e-3 and errors[1] < 0.3 * errors[0], "quadratic in the size of the facets"


@pytest.mark.parametrize("around", (3, 16, 97))
def test_a_plane_cuts_a_prism_in_a_polygon(around):
    body = meshes.cylinder(0.5, 1.0, around=around)
    cut = intersection(body, level(0.125))
    assert_sound(cut, body, level(0.125))
    assert cut.length == pytest.approx(around * np.sin(np.pi / around), rel=1e-14)
    assert (len(cut.polylines), cut.loops) == (1, 1)


def test_a_thin_cylinder_through_a_thick_one_leaves_two_loops():
    thick, thin = 1.0, 0.5
    errors = []
    for around in (64, 128):
        first = meshes.cylinder(thick, 4.0, around=around)
        second = meshes.cylinder(thin, 4.0, around=around, axis=(1.0, 0.0, 0.0))
        cut = intersection(first, second)
        assert_sound(cut, first, second)
        assert (len(cut.polylines), cut.loops) == (2, 2)
        # One loop: (sqrt(R^2 - r^2 sin^2 t), r sin t, r cos t).
        t = np.linspace(0, 2 * np.pi, 200001)
        loop = np.stack([np.sqrt(thick**2 - (thin * np.sin(t)) ** 2), thin * np.sin(t), thin * np.cos(t)])
        length = 2 * np.linalg.norm(np.diff(loop), axis=0).sum()
        errors.append(abs(cut.length - length) / length)
    assert errors[0] < 2e-3 and errors[1] < 0.3 * errors[0]


def test_two_equal_cylinders_meet_in_two_ellipses_that_cross_twice():
    around = 64
    first = meshes.cylinder(1.0, 4.0, around=around)
    second = mesh(first.points[:, [2, 0, 1]], first.triangles)  # the very same facets about the x axis
    cut = intersection(first, second)
    assert_sound(cut, first, second)
    assert np.bincount(cut.degrees()).tolist()[2:] == [len(cut.points) - 2, 0, 2], "two points where four curves meet"
    assert (len(cut.polylines), cut.loops) == (4, 0)
    assert np.allclose(np.abs(cut.points[cut.degrees() == 4]), (0, 1, 0), atol=1e-15)
    # Ellipses with half axes 1 and sqrt 2.
    t = np.linspace(0, 2 * np.pi, 200001)
    length = 2 * np.linalg.norm(np.diff([np.cos(t), np.sin(t) * np.sqrt(2)]), axis=0).sum()
    assert cut.length == pytest.approx(length, rel=2e-3)


def villarceau_torus(around, across):
    """A torus of radii 25 and 15 with points where the plane 3x = 4z touches it: (16, 0, 12) and (-16, 0, -12)."""
    tilt = np.arctan2(4, -3)
    tube = np.concatenate([np.linspace(-tilt, tilt, across, endpoint=False)])
    tube = np.concatenate([tube, np.linspace(tilt, 2 * np.pi - tilt, across, endpoint=False)])
    ring = 2 * np.pi * np.arange(around) / around
    a, b = np.meshgrid(ring, tube, indexing="ij")
    reach = 25 + 15 * np.cos(b)
    points = np.stack([reach * np.cos(a), reach * np.sin(a), 15 * np.sin(b)], axis=-1)
    points[0, across] = (16, 0, 12)
    points[around // 2, 0] = (-16, 0, -12)
    body = meshes.torus(25, 15, around, 2 * across)
    return mesh(points.reshape(-1, 3), body.triangles)


def test_the_bitangent_plane_of_a_torus_cuts_out_the_circles_of_villarceau():
    torus = villarceau_torus(160, 80)
    bitangent = plane((-64, -100, -48), (64, -100, 48), (64, 100, 48), (-64, 100, -48))
    cut = intersection(torus, bitangent)
    assert_sound(cut, torus, bitangent)
    touching = cut.points[cut.degrees() == 4]
    assert sorted(map(tuple, touching)) == [(-16, 0, -12), (16, 0, 12)]
    assert (len(cut.polylines), cut.loops) == (4, 0)
    # Two circles of radius 25, cut where their common chord of length 40 ends.
    short = 2 * 25 * np.arcsin(20 / 25)
    wanted = [short, short, 2 * np.pi * 25 - short, 2 * np.pi * 25 - short]
    assert sorted(cut.cell_data["Length"]) == pytest.approx(wanted, rel=2e-3)
    assert cut.length == pytest.approx(4 * np.pi * 25, rel=1e-3)
    # Off by a little, the curves part at the two points: to two loops about one point each, or to one long one.
    for other, loops in ((plane((-64, -100, -47), (64, -100, 47), (64, 100, 47), (-64, 100, -47)), 2),
                         (meshes.moved(bitangent, (0, 0, 0.5)), 1)):
        off = intersection(torus, other)
        assert np.all(off.degrees() == 2) and off.loops == len(off.polylines) == loops


# ---- areas in common ----------------------------------------------------------------------------

CUBE = box((0, 0, 0), (4, 4, 4))


@pytest.mark.parametrize(
    "other, curves, length",
    (
        (box((1, 1, 4), (3, 3, 6)), 1, 8.0),  # stands on it
        (box((2, 2, 4), (6, 6, 6)), 1, 8.0),  # stands on a corner of it
        (box((0, 0, 4), (4, 4, 6)), 1, 16.0),  # a whole face
        (box((1, 1, 2), (3, 3, 4)), 1, 8.0),  # inside, flush
        (box((0, 0, 0), (2, 2, 2)), 1, 12.0),  # three faces in common: the outline is one hexagon
        (box((2, 2, 2), (6, 6, 6)), 1, 12.0),  # no area in common
        (CUBE, 0, 0.0),  # all of it
        (box((4, 4, 0), (6, 6, 4)), 1, 4.0),  # an edge
        (box((4, 4, 4), (6, 6, 6)), 0, 0.0),  # a corner is no curve
        (box((5, 5, 5), (6, 6, 6)), 0, 0.0),
    ),
)
def test_boxes_meet_in_the_outline_of_what_they_have_in_common(other, curves, length):
    cut = intersection(CUBE, other)
    assert (len(cut.polylines), cut.length) == (curves, length)
    assert cut.status == (0 if curves else 40) and not cut.errors and not cut.warnings
    if curves:
        assert_sound(cut, CUBE, other)
    assert cut.degrees().tolist().count(1) == (2 if length == 4.0 else 0), "all but the edge are loops"


# ---- from either side, and whatever the threads -------------------------------------------------


def bumpy(seed, level=4):
    return meshes.bumpy_sphere(np.random.default_rng(seed), level, bumps=8)


PAIRS = {
    "bumpy": lambda: (bumpy(1), meshes.turned(bumpy(2), meshes.rotation((1, 2, 3), 0.4))),
    "boxes": lambda: (CUBE, box((1, 1, 2), (3, 5, 4))),
    "elephant and cow": lambda: (
        meshes.cgal_mesh("elephant"),
        meshes.moved(meshes.cgal_mesh("cow"), (0.1, 0.05, 0.02)),
    ),
    "bones and knot": lambda: (meshes.cgal_mesh("bones"), meshes.moved(meshes.cgal_mesh("knot1"), (0.02, 0.01, 0.03))),
}


@pytest.mark.parametrize("pair", PAIRS)
def test_the_curve_is_the_same_from_either_side(pair):
    first, second = PAIRS[pair]()
    there, back = intersection(first, second), intersection(second, first)
    assert len(there.segments) > 5
    assert there.segment_names() == back.segment_names(), "equal to the last bit"
    assert (len(there.polylines), there.loops) == (len(back.polylines), back.loops)
    assert there.length == pytest.approx(back.length, rel=1e-12)
    assert_sound(there, first, second)
    assert_sound(back, second, first)
    assert set(there.cell_data["SourceIds"].ravel()) == {0, 1}


@pytest.mark.parametrize("pair", ("bumpy", "boxes"))
def test_the_number_of_threads_changes_no_byte(pair):
    first, second = PAIRS[pair]()
    wanted = intersection(first, second, number_of_threads=1).bytes()
    for threads in (2, 3, 7):
        assert intersection(first, second, number_of_threads=threads).bytes() == wanted


def test_curves_alone_are_the_same_curves():
    for pair in ("bumpy", "boxes", "bones and knot"):
        first, second = PAIRS[pair]()
        alone = intersection(first, second, SplitFirstOutput=0, SplitSecondOutput=0)
        assert alone.segment_names() == intersection(first, second).segment_names()
        assert all(split.is_empty for split in alone.splits)
        assert len(alone.field_data["SegmentCellIds"]) == len(alone.segments)


@pytest.mark.parametrize("pair", ("bumpy", "elephant and cow"))
def test_every_segment_lies_in_the_two_cells_that_it_names(pair):
    surfaces = PAIRS[pair]()
    cut = intersection(*surfaces)
    ends = cut.points[cut.segments]  # segment, end, axis
    for side, body in enumerate(surfaces):
        corners = body.points[body.triangles[cut.field_data["SegmentCellIds"][:, side]]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        size = np.linalg.norm(normals, axis=1)[:, None]
        for k in range(3):  # inside of each edge, up to rounding
            inwards = np.cross(normals, corners[:, (k + 1) % 3] - corners[:, k])
            length = np.linalg.norm(inwards, axis=1)[:, None]
            inside = np.einsum("sea,sa->se", ends - corners[:, None, k], inwards) / length
            assert inside.min() > -1e-12
        assert np.abs(np.einsum("sea,sa->se", ends - corners[:, None, 0], normals) / size).max() < 1e-12


# ---- open and self-intersecting surfaces ----------------------------------------------------------


def test_a_sheet_that_ends_inside_gives_an_open_curve():
    half = plane((0, -4, 0.1), (4, -4, 0.1), (4, 4, 0.1), (0, 4, 0.1))
    ball = meshes.cylinder(1.0, 2.0, around=64)
    cut = intersection(ball, half)
    assert (len(cut.polylines), cut.loops) == (1, 0)
    assert cut.length == pytest.approx(64 * np.sin(np.pi / 64), rel=1e-12)  # half of the prism's outline
    assert_sound(cut, ball, half)
    assert [split.number_of_patches for split in cut.splits] == [1, 2]
    assert not cut.warnings and cut.status == 0


def test_two_open_sheets_cross_in_a_line():
    first, second = level(0.0, 1.0), plane((-1, 0.25, -1), (1, 0.25, -1), (1, 0.25, 1), (-1, 0.25, 1))
    cut = intersection(first, second)
    assert (len(cut.polylines), cut.loops, cut.length) == (1, 0, 2.0)
    assert [split.number_of_patches for split in cut.splits] == [2, 2]
    assert_sound(cut, first, second)


def test_polygons_oriented_against_each_other_are_no_obstacle():
    ball = meshes.icosphere(3)
    torn = mesh(ball.points, ball.triangles.copy())
    torn.triangles[::3] = torn.triangles[::3, ::-1]
    cut = intersection(torn, level(0.1))
    assert cut.status == 0 and not cut.errors and not cut.warnings
    assert cut.segment_names() == intersection(ball, level(0.1)).segment_names()
    assert_sound(cut, torn, level(0.1))


def test_without_tool_a_surface_meets_itself():
    both = meshes.joined(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3)))
    cut = intersection(both)
    assert (len(cut.polylines), cut.loops, cut.length) == (1, 1, 6.0)
    assert cut.cell_data["SourceIds"].tolist() == [[0, 0]]
    assert cut.splits[0].number_of_patches == 4 and cut.splits[1].is_empty
    assert_sound(cut, both)
    cells = cut.field_data["SegmentCellIds"]
    assert np.all(cells.min(axis=1) < 12) and np.all(cells.max(axis=1) >= 12)


def test_a_surface_that_does_not_meet_itself_has_no_curve():
    for body in (meshes.icosphere(3), meshes.torus(1.0, 0.3), level(0.0), meshes.cgal_mesh("knot1")):
        cut = intersection(body)
        assert (len(cut.polylines), cut.status) == (0, 40) and not cut.errors and not cut.warnings
        assert len(cut.splits[0].body.triangles) == len(body.triangles)


def test_a_real_mesh_that_runs_through_itself_says_where():
    """The feet of the bones: every pair of cells named does cross, by exact signs."""
    bones = meshes.cgal_mesh("bones")
    cut = intersection(bones)
    assert (len(cut.polylines), cut.loops) == (20, 20)
    assert_sound(cut, bones)
    points, _ = measures.whole(bones.points)
    for a, b in bones.triangles[cut.field_data["SegmentCellIds"]]:
        for plane_of, other in ((a, b), (b, a)):
            heights = [meshes.orientation([points[i] for i in (*plane_of, j)]) for j in other]
            assert min(heights) <= 0 <= max(heights)


def test_triangles_that_meet_end_to_end_are_no_self_intersection():
    """A long edge beside two short ones: the surface goes on there, although no edges are shared."""
    points = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, -1, 0], [1, 0, 0], [2, -1, 0]], dtype=float)
    assert intersection(mesh(points, [[0, 1, 2], [0, 3, 4], [4, 5, 1]])).status == 40


def test_a_self_intersecting_surface_meets_another_one_in_branched_curves():
    """Two cubes in one surface, cut by a plane: two squares that cross at two branch points."""
    both = meshes.joined(box((0, 0, 0), (2, 2, 2)), box((1, 1, -1), (3, 3, 1)))
    cut = intersection(both, level(0.5, 8.0))
    assert cut.length == 16.0
    assert np.count_nonzero(cut.degrees() == 4) == 2 and cut.loops == 0 and len(cut.polylines) == 4
    assert np.unique(cut.cell_data["SourceIds"], axis=0).tolist() == [[0, 1]], "no curve of the surface with itself"
    assert_sound(cut, both, level(0.5, 8.0))
    assert cut.splits[1].number_of_patches == 4
    alone = intersection(both, level(0.5, 8.0), SplitFirstOutput=0, SplitSecondOutput=0)
    assert alone.segment_names() == cut.segment_names()


def test_curves_of_several_bodies_in_one_surface_have_each_their_loop():
    bodies = meshes.joined(*[meshes.moved(meshes.icosphere(2, 0.4), (k, 0, 0)) for k in range(5)])
    cut = intersection(bodies, level(0.1, 9.0))
    assert (len(cut.polylines), cut.loops) == (5, 5)
    assert np.ptp(cut.cell_data["Length"]) < 1e-12
    assert [split.number_of_patches for split in cut.splits] == [10, 6]
