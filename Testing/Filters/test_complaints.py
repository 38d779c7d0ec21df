# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What users of other Boolean filters complain of, row by row, each with its known answer.

The issue that each row comes from stands in its text. VTK's own answer is noted beside ours.
"""

from dataclasses import dataclass

import numpy as np
import pytest

import measures
import meshes
from booleans import (
    DIFFERENCE,
    INTERSECTION,
    RESOLVE,
    SYMMETRIC_DIFFERENCE,
    UNION,
    answer_of_vtk,
    boolean,
    cells_of,
    points_of,
    polydata,
)
from meshes import EMPTY, box, cube, sphere


@dataclass
class Row:
    """Two operands, an operation, and the volume of the answer."""

    complaint: str
    first: meshes.Mesh
    second: meshes.Mesh
    operation: str
    volume: float
    relative: float = 1e-12
    ask_vtk: bool = True


def exact_intersection(*bodies):
    return float(measures.convex_intersection_volume(*bodies))


def rows():
    ball = sphere(0.5, around=30, along=30)
    v = measures.volume(ball)
    yield "1 same, intersection", Row(
        "pyvista#4796: identical shapes freeze", ball, ball, INTERSECTION, v
    )
    yield "1 same, union", Row("pyvista#4796", ball, ball, UNION, v, ask_vtk=False)
    yield "1 same, difference", Row("pyvista#4796", ball, ball, DIFFERENCE, 0.0, ask_vtk=False)
    yield "1 same, symmetric", Row("pyvista#4796", ball, ball, SYMMETRIC_DIFFERENCE, 0.0)

    slab, bar = box((-0.5, -9, -13.5), (0.5, 9, 13.5)), box((-0.55, -5, -5), (0.55, 5, 5))
    yield "2 bar through slab", Row("pyvista#4843: two cubes, wrong", slab, bar, DIFFERENCE, 386.0)

    wall, hole = box((0, 0, -0.1), (6, 3, 0.1)), box((1, 1, -0.2), (2, 2, 0.2))
    yield "3 hole in a wall", Row("pyvista#7548: the hole is dropped", wall, hole, DIFFERENCE, 3.4)

    one = sphere(22.443613622177708, (60.69442458, 148.23356447, -607.05434454), 50, 50)
    two = sphere(19.99923563231063, (60.83777191, 147.54242583, -610.92167808), 50, 50)
    both = 32595.080504988724  # measures.convex_intersection_volume, which takes two minutes here
    union = measures.volume(one) + measures.volume(two) - both
    yield "4 two spheres", Row("pyvista#6688: 45 open edges", one, two, UNION, union, 1e-11)

    quads = box((-0.4,) * 3, (0.4,) * 3)
    volume = measures.volume(quads) - exact_intersection(quads, ball)
    yield "6 cube minus sphere", Row("pyvista-support#138", quads, ball, DIFFERENCE, volume)

    case, void = cube(20.0), sphere(2.0)
    v = measures.volume(void)
    yield "7 void", Row(
        "pyvista-support#447, pyvista#3290: nested", case, void, DIFFERENCE, 8000 - v
    )
    yield "7 nested union", Row("pyvista#3290", case, void, UNION, 8000.0)
    yield "7 nested intersection", Row("vedo#623", case, void, INTERSECTION, v)
    yield "7 nothing left", Row("pyvista#3290", void, case, DIFFERENCE, 0.0)

    unit, far = box((0, 0, 0), (1, 1, 1)), box((5, 0, 0), (6, 1, 1))
    yield "8 apart, union", Row("pyvista-support#305: empty union", unit, far, UNION, 2.0)
    yield "8 apart, intersection", Row("pyvista-support#305", unit, far, INTERSECTION, 0.0)
    yield "8 apart, difference", Row("pyvista-support#305", unit, far, DIFFERENCE, 1.0)

    flush = box((0.5, 0, 0), (1.5, 1, 1))
    for operation, volume in zip((UNION, INTERSECTION, DIFFERENCE), (1.5, 0.5, 0.5)):
        text = "cgal#9497, PyMesh#136: four faces in common planes"
        yield f"9 coplanar, {operation}", Row(text, unit, flush, operation, volume)

    block, pocket = box((0, 0, 0), (2, 2, 2)), box((0.5, 0.5, 1), (1.5, 1.5, 2))
    yield "10 flush pocket", Row("tool flush with a face", block, pocket, DIFFERENCE, 7.0)

    tiny = meshes.scaled(cube(1.0), 1e-6)
    beside_it = meshes.moved(tiny, (5e-7, 5e-7, 5e-7))
    volume = (
        measures.volume(tiny) + measures.volume(beside_it) - exact_intersection(tiny, beside_it)
    )
    yield "11 micrometres", Row("absolute tolerances", tiny, beside_it, UNION, volume)

    west = sphere(500.0, (684263.75, 5613583.0, 600.0), 24, 24)
    east = meshes.moved(west, (300.0, 0.0, 0.0))
    volume = measures.volume(west) + measures.volume(east) - exact_intersection(west, east)
    yield "12 map coordinates", Row("pyvista#5449 family", west, east, UNION, volume, 1e-9)

    crate = box((-1.5, -1.5, -2.1), (1.5, 1.5, 2.1))
    dx, dy, dz, dk = -0.804, 1.6, 2.2, 2.0
    sheared = meshes.mesh(
        [[-dx, -dy, -dz], [dk, -dy, -dz], [-dx, dy, -dz], [dk, dy, -dz]]
        + [[dx, -dy, dz], [dk, -dy, dz], [dx, dy, dz], [dk, dy, dz]],
        box((0, 0, 0), (1, 1, 1)).triangles,
    )
    volume = exact_intersection(crate, sheared)
    yield "15 sheared box", Row(
        "pyvista#4059: not watertight", crate, sheared, INTERSECTION, volume
    )

    ring = meshes.on_lattice(meshes.torus(1.0, 0.4, 48, 24), 20)
    shifted = meshes.moved(ring, (0.5, 0.0, 0.0))
    yield "18 two tori", Row("vtkbool#34: 15 minutes", ring, shifted, UNION, None, ask_vtk=False)

    base = cube(2.0)
    tilted = meshes.turned(meshes.moved(base, (0, 0, 2)), meshes.rotation((1, 2, 0), 1e-9))
    volume = 16.0 - exact_intersection(base, tilted)
    yield "19 nearly parallel", Row("vtkbool#40, #67: contact ends", base, tilted, UNION, volume)

    start, end = (120.57039642, 57.58803177, 117.53710938), (180.38616943, 83.88054657, 87.29520416)
    pipe = meshes.on_lattice(meshes.cylinder_between(start, end, 20.0, 32), 30)
    for name, extra in (("", 0.0), (", a hundredth larger", 1e-2)):
        knob = meshes.on_lattice(sphere(20.0 + extra, end, 24, 13), 30)
        volume = measures.volume(pipe) + measures.volume(knob) - exact_intersection(pipe, knob)
        text = "vtkbool#80: a knob at a pipe's end, empty"
        yield f"20 knob{name}", Row(text, pipe, knob, UNION, volume, 1e-10)

    for name, operation, volume in (
        ("22 A or nothing", UNION, 8.0),
        ("22 A and nothing", INTERSECTION, 0.0),
        ("22 A minus nothing", DIFFERENCE, 8.0),
        ("22 A xor nothing", SYMMETRIC_DIFFERENCE, 8.0),
    ):
        yield name, Row("vtkbool#81: empty operands", base, EMPTY, operation, volume)
    yield "22 nothing or B", Row("vtkbool#81", EMPTY, base, UNION, 8.0)
    yield "22 nothing minus B", Row("vtkbool#81", EMPTY, base, DIFFERENCE, 0.0)
    yield "22 nothing or nothing", Row("vtkbool#81", EMPTY, EMPTY, UNION, 0.0)

    rod = meshes.on_lattice(meshes.cylinder(10.0, 50.0, around=100, axis=(1, 0, 0)), 30)
    slice_ = box((-1, -20, -20), (1, 20, 20))
    volume = exact_intersection(rod, slice_)
    text = "visit#19584, vtk-js#3243: a cylinder cut at x = -1 and x = 1"
    yield "29 caps", Row(text, rod, slice_, INTERSECTION, volume)


ROWS = dict(rows())


@pytest.mark.parametrize("name", ROWS)
def test_the_answer_is_closed_and_has_the_known_volume(name, beside):
    row = ROWS[name]
    result = boolean([row.first], [row.second], row.operation)
    expected = row.volume
    if expected is None:
        expected = volume_by_identity(row)
    size = abs(measures.volume(row.first)) + abs(measures.volume(row.second))
    error = abs(result.volume - expected) / (size or 1.0)
    beside(
        f"row {name}, {row.operation}: volume {expected:.12g} ({row.complaint})",
        f"off by {error:.1g} of the operands, {measures.open_edges(result.body)} open edges",
        (
            answer_of_vtk(row.first, row.second, row.operation)
            if row.ask_vtk
            else "not asked, it takes too long"
        ),
    )
    assert not result.errors
    assert measures.open_edges(result.body) == 0
    assert error <= row.relative
    if expected == 0.0:
        assert result.is_empty


def volume_by_identity(row):
    """The union of bodies that are not convex: by the other operations, which have other seams."""
    common = boolean([row.first], [row.second], INTERSECTION)
    assert common.volume > 0.01
    return measures.volume(row.first) + measures.volume(row.second) - common.volume


def test_row_5_a_chain_of_unions_stays_closed_and_can_be_clipped(beside):
    """pyvista#2788, #2720: sphere, cylinder and cone, whose union is then cut by a plane."""
    center = np.array([2.4623486548662186, 15.274176120758057, 2.042705088853836])
    ball = sphere(1.0, center, 30, 30)
    half = center * (1, 0.5, 1)
    stem = meshes.cylinder(0.5, center[1], half, 100, (0, 1, 0))
    direction = (-0.4634096920490265, 0.6903295516967773, -0.5556047558784485)
    horn = meshes.cone(1.0, 3.0, (1.7672341, 16.30967, 1.2092979), 8, direction)
    lower = boolean([ball], [stem], UNION)
    chain = boolean([lower.body], [horn], UNION)
    at_once = boolean([ball, stem, horn], [], UNION)
    beside(
        "row 5, sphere | cylinder | cone, the first step (pyvista#2788)",
        f"{measures.open_edges(lower.body)} open edges",
        answer_of_vtk(ball, stem, UNION),
    )
    for result in (lower, chain, at_once):
        assert not result.errors and measures.open_edges(result.body) == 0
    parts = (ball, stem, horn)
    expected = union_of_three(*parts)
    assert chain.volume == pytest.approx(expected, rel=1e-11)
    assert at_once.volume == pytest.approx(expected, rel=1e-11)
    below = box((-10, -10, -10), (10, center[1], 10))
    clipped = boolean([chain.body], [below], INTERSECTION)
    assert not clipped.errors and measures.open_edges(clipped.body) == 0
    assert clipped.volume == pytest.approx(union_of_three(*parts, within=[below]), rel=1e-11)


def union_of_three(a, b, c, within=()):
    """Inclusion and exclusion over convex bodies, of the parts `within` other convex bodies."""

    def common(*bodies):
        return measures.convex_intersection_volume(*within, *bodies)

    singles = common(a) + common(b) + common(c)
    pairs = common(a, b) + common(b, c) + common(a, c)
    return float(singles - pairs + common(a, b, c))


def test_row_6_quads_are_taken_as_they_are():
    """pyvista-support#138: an empty result for quads, "is this by design?" """
    quads = polydata(meshes.mesh(meshes.box_corners((-0.4,) * 3, (0.4,) * 3), []), meshes.BOX_QUADS)
    row = ROWS["6 cube minus sphere"]
    result = boolean([quads], [row.second], DIFFERENCE)
    assert not result.errors and measures.open_edges(result.body) == 0
    assert result.volume == pytest.approx(row.volume, rel=1e-12)


def test_row_6_untouched_quads_stay_quads():
    quads = polydata(meshes.mesh(meshes.box_corners((0, 0, 0), (2, 2, 2)), []), meshes.BOX_QUADS)
    result = boolean([quads], [box((0.5, 0.5, 1.5), (1.5, 1.5, 3))], DIFFERENCE)
    offsets, _ = cells_of(result.surface.GetPolys())
    from_box = result.cell_data["SourceId"] == 0
    sizes = np.diff(offsets)[from_box]
    cells = result.cell_data["OriginalCellId"][from_box]
    assert [sizes[cells == k].tolist() for k in range(5)] == [[4]] * 5  # cell 5 is the top
    assert measures.open_edges(result.body) == 0
    assert result.volume == 7.5


@pytest.mark.parametrize("sides", [49, 50])
def test_row_16_a_tube_against_a_triangle_does_not_depend_on_its_sides(sides):
    """vedo#734: the intersection crashes for 50 sides and works for 49."""
    tube = meshes.cylinder(4.0, 10.0, (5, 0, 0), sides, (1, 0, 0))
    triangle = meshes.mesh([[0, 0, 0], [10, 0, 0], [10, 10, 0]], [[0, 1, 2]])
    result = boolean([tube], [triangle], INTERSECTION)
    assert not result.errors
    points = points_of(result.curves)
    assert len(points) > 1
    assert np.abs(points[:, 2]).max() < 1e-14
    # On the triangle's line y = x the wall is hit where the tube's polygon crosses z = 0.
    wall = points[(points[:, 0] > 1e-9) & (points[:, 0] < 10 - 1e-9)]
    radius = np.abs(wall[:, 1]).max()
    assert 4.0 * np.cos(np.pi / sides) - 1e-12 <= radius <= 4.0 + 1e-12


def test_row_16_two_rectangles_at_large_coordinates_cross_in_a_line():
    """vedo#696, #740: a crash at coordinates of 1.7e4."""
    one = [
        [17903.93947473, 11418.12995419, 2572.68075251],
        [17889.4353166, 11423.09300945, 2546.89320749],
    ]
    one += [
        [17913.6520434, 11446.51421055, 2572.68075251],
        [17899.14788527, 11451.47726581, 2546.89320749],
    ]
    two = [
        [17897.68174692, 11454.30365475, 2573.22453367],
        [17917.8546173, 11442.45883457, 2554.44274633],
    ]
    two += [
        [17882.4917027, 11428.43354543, 2573.22453367],
        [17902.66457308, 11416.58872525, 2554.44274633],
    ]
    faces = [[0, 1, 2], [3, 2, 1]]
    result = boolean([meshes.mesh(one, faces)], [meshes.mesh(two, faces)], INTERSECTION)
    points = points_of(result.curves)
    assert len(points) >= 2 and result.curves.GetNumberOfLines() >= 1
    for corners in (np.array(one), np.array(two)):
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        heights = (points - corners[0]) @ normal / np.linalg.norm(normal)
        assert np.abs(heights).max() < 1e-8  # the rectangles' four points are flat to 1e-9


def test_row_19_an_assembly_appended_into_one_operand_is_taken_by_its_winding_number():
    """vtkbool#65: "Strips are invalid" for overlapping parts in one mesh."""
    parts = [cube(1.0, (0.0, 0, 0)), cube(1.0, (0.5, 0.25, 0)), cube(1.0, (0.25, 0.5, 0.5))]
    boxes = [(np.round((p.points.min(0) + 0.5) * 4).astype(int),) * 2 for p in parts]
    boxes = [(low, low + 4) for low, _ in boxes]
    covered, walls = measures.voxel_volume_and_area(meshes.voxels(boxes, 12) >= 1)
    result = boolean([meshes.joined(*parts)], [], RESOLVE)
    assert not result.errors and measures.open_edges(result.body) == 0
    assert result.volume == pytest.approx(covered / 64, rel=1e-12)
    assert result.area == pytest.approx(walls / 16, rel=1e-12)


def test_row_21_no_jitter_is_needed_and_none_does_harm():
    """SlicerSandbox#16: fifteen tries of 1e-4 mm jitter as a work-around."""
    bone = meshes.on_lattice(meshes.cylinder(10.0, 60.0, around=40), 30)
    guide = box((-20, -20, 30), (20, 20, 40))  # flush with the bone's end
    rng = np.random.default_rng(21)
    for shift in [np.zeros(3)] + list(rng.uniform(-1e-4, 1e-4, (15, 3))):
        tool = meshes.moved(guide, shift)
        result = boolean([bone], [tool], DIFFERENCE)
        expected = measures.volume(bone) - exact_intersection(bone, tool)
        assert not result.errors and measures.open_edges(result.body) == 0
        assert result.volume == pytest.approx(expected, rel=1e-12)


def test_row_23_a_script_can_tell_no_contact_from_failure():
    """vtkbool#54: no contact and failure look alike."""
    apart = boolean([cube(1.0)], [cube(1.0, (5, 0, 0))], INTERSECTION)
    assert (apart.status, apart.errors) == (0, [])
    assert apart.is_empty
    bad = cube(1.0)
    bad.points[0, 0] = np.nan
    failed = boolean([bad], [cube(1.0)], INTERSECTION)
    assert failed.status != 0 and failed.message
    assert failed.is_empty


def test_row_24_a_small_cut_leaves_the_rest_of_a_large_mesh_alone():
    """vtkbool#89: the cost must follow the overlap, so what is not touched is passed on."""
    body = meshes.icosphere(5)
    tool = cube(0.1, (0.0, 0.0, 1.0))
    result = boolean([body], [tool], DIFFERENCE)
    assert measures.open_edges(result.body) == 0
    kept = result.cell_data["SourceId"] == 0
    cells, uses = np.unique(result.cell_data["OriginalCellId"][kept], return_counts=True)
    corners = body.points[body.triangles]
    near = np.all(
        (corners.min(1) <= tool.points.max(0)) & (corners.max(1) >= tool.points.min(0)), axis=1
    )
    whole = np.flatnonzero(~near)
    assert np.isin(whole, cells).all() and (uses[np.isin(cells, whole)] == 1).all()


def tensile_bar():
    """A bar with a waist: a box minus two cylinders, so that it is not convex."""
    bar = box((-60, -12, -8), (60, 12, 8))
    bites = [meshes.cylinder(30.0, 40.0, (0, y, 0), 48) for y in (-36, 36)]
    return boolean([bar], bites, DIFFERENCE).body


def test_row_25_the_part_of_an_open_surface_inside_a_closed_one():
    """pyvista-support#381: a wavy sheet across a tensile bar."""
    grid = np.linspace(-100, 100, 61)
    waves = meshes.sheet(lambda x, y: np.sin(0.2 * x) * np.sin(0.25 * y), grid, grid)
    bar = tensile_bar()
    above = boolean([bar], [waves], DIFFERENCE)
    below = boolean([bar], [waves], INTERSECTION)
    for part in (above, below):
        assert not part.errors and measures.open_edges(part.body) == 0
    assert above.volume + below.volume == pytest.approx(measures.volume(bar), rel=1e-12)
    assert above.volume == pytest.approx(measures.volume(bar) / 2, rel=0.05)
    cut = boolean([waves], [bar], INTERSECTION)
    lids = [sheet_area(part, 1) for part in (above, below)] + [sheet_area(cut, 0)]
    assert lids[0] == pytest.approx(lids[1], rel=1e-12)
    assert lids[0] == pytest.approx(lids[2], rel=1e-12)
    # the bar's cross-section at z = 0, which the waves all but follow
    assert lids[0] == pytest.approx(measures.volume(bar) / 16, rel=0.15)


def sheet_area(result, source):
    mine = result.cell_data["SourceId"] == source
    return measures.area(meshes.mesh(result.body.points, result.body.triangles[mine]))


@pytest.mark.parametrize("operation, keep_above", [(DIFFERENCE, True), (INTERSECTION, False)])
def test_a_plane_sheet_cuts_a_sphere_and_closes_it(operation, keep_above):
    ball = meshes.on_lattice(sphere(1.0, around=24, along=24), 30)
    plane = meshes.sheet(lambda x, y: 0.1 + 0 * x, np.linspace(-2, 2, 5), np.linspace(-2, 2, 5))
    result = boolean([ball], [plane], operation)
    lower, upper = ((-2, -2, 0.1), (2, 2, 2)) if keep_above else ((-2, -2, -2), (2, 2, 0.1))
    assert not result.errors and measures.open_edges(result.body) == 0
    assert result.volume == pytest.approx(exact_intersection(ball, box(lower, upper)), rel=1e-12)


def test_row_26_a_surface_is_cut_where_the_other_crosses_it_not_near_by():
    """pyvista#5449: a jagged clip at map coordinates."""
    track = np.array([[684263.75, 5613583.0], [684543.38, 5613355.0], [685263.19, 5612925.0]])
    track = np.vstack([track, [[686216.06, 5612578.5], [687086.0, 5612397.0]]])
    points = [(x, y, z) for z in (0.0, 1200.0) for x, y in track]
    wall = meshes.mesh(
        points, [t for k in range(4) for t in ((k, k + 1, k + 6), (k, k + 6, k + 5))]
    )
    dip = meshes.mesh(
        [(684000.0, 5611000.0, 1100.0), (688000.0, 5611000.0, 900.0), (688000.0, 5615000.0, 100.0)]
        + [(684000.0, 5615000.0, 300.0)],
        [(0, 1, 2), (0, 2, 3)],
    )
    result = boolean([dip], [wall], INTERSECTION)
    seam = points_of(result.curves)
    assert not result.errors and len(seam) > 5
    for surface in (wall, dip):
        corners = surface.points[surface.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        heights = np.einsum("ijk,jk->ij", seam[:, None] - corners[None, :, 0], normals)
        assert np.abs(heights).min(axis=1).max() < 5e-9  # a rounding step at 5.6e6 is 1e-9


def test_row_27_three_meshes_are_united_in_one_call():
    """vedo#454: a union of three."""
    balls = [
        meshes.lattice_sphere(0.5, (x, y, 0.0), 16, 9) for x, y in ((0, 0), (0.5, 0), (0.25, 0.5))
    ]
    a, b, c = balls
    expected = union_of_three(a, b, c)
    for inputs, tools in ((balls, []), ([a], [b, c]), ([c, a], [b])):
        result = boolean(inputs, tools, UNION)
        assert not result.errors and measures.open_edges(result.body) == 0
        assert result.volume == pytest.approx(expected, rel=1e-12)
    common = boolean(balls, [], INTERSECTION)
    assert common.volume == pytest.approx(exact_intersection(a, b, c), rel=1e-12)


def halves_of_a_body(rng):
    """Two solids that share one face of four points that lie in no plane, triangle by triangle."""
    lower, upper = box((-1, -1, -1), (1, 1, 0)), box((-1, -1, 0), (1, 1, 1))
    for x, y in ((-1, -1), (1, -1), (-1, 1), (1, 1)):
        height = rng.uniform(-0.3, 0.3)
        for half in (lower, upper):
            here = (half.points[:, 0] == x) & (half.points[:, 1] == y) & (half.points[:, 2] == 0)
            half.points[here, 2] = height
    lid = np.flatnonzero((np.abs(upper.points[:, 2]) < 0.5)[upper.triangles].all(axis=1))
    below = np.flatnonzero((np.abs(lower.points[:, 2]) < 0.5)[lower.triangles].all(axis=1))
    place = {tuple(p): i for i, p in enumerate(lower.points.tolist())}
    same = [[place[tuple(upper.points[i])] for i in t[::-1]] for t in upper.triangles[lid]]
    lower.triangles[below] = same
    return lower, upper


@pytest.mark.parametrize("seed", range(10))
def test_row_30_solids_with_a_common_face_subtract_without_left_over_triangles(seed):
    """manifold#285, #1706: two extra triangles where two solids share four points exactly."""
    lower, upper = halves_of_a_body(np.random.default_rng(seed))
    assert measures.is_closed(lower) and measures.is_closed(upper)
    difference = boolean([lower], [upper], DIFFERENCE)
    assert difference.surface.GetNumberOfCells() == len(lower.triangles)
    assert difference.volume == pytest.approx(measures.volume(lower), rel=1e-15)
    assert boolean([lower], [upper], INTERSECTION).is_empty
    union = boolean([lower], [upper], UNION)
    assert measures.open_edges(union.body) == 0
    assert union.volume == pytest.approx(8.0, rel=1e-15)
    assert union.surface.GetNumberOfCells() == len(lower.triangles) + len(upper.triangles) - 4


def test_row_31_twelve_unions_one_after_the_other_agree_with_one_call():
    """InteractiveAndRobustMeshBooleans#26: rounding breaks the next Boolean."""
    rng = np.random.default_rng(31)
    bodies = [
        meshes.moved(meshes.random_convex_body(rng), rng.uniform(-0.7, 0.7, 3)) for _ in range(12)
    ]
    chain = bodies[0]
    for body in bodies[1:]:
        result = boolean([chain], [body], UNION)
        assert not result.errors and measures.open_edges(result.body) == 0
        chain = result.body
    at_once = boolean(bodies, [], UNION)
    assert measures.open_edges(at_once.body) == 0
    assert measures.volume(chain) == pytest.approx(at_once.volume, rel=1e-11)
