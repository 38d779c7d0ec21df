# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkPolyDataSurfaceCheck: each defect made on purpose is found where it was made, and nothing else is."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkStripper
from vtkmodules.vtkFiltersSources import vtkCubeSource

import measures
import meshes
from booleans import boolean, cells_of, points_of, polydata
from checks import (
    BOUNDARY,
    DUPLICATE,
    INCONSISTENT,
    NO_AREA,
    NON_MANIFOLD,
    SELF,
    TOUCHING,
    WRONG_WAY,
    check,
)
from meshes import box, joined, mesh, moved

CUBE = box((0, 0, 0), (2, 2, 2))
BALL = meshes.icosphere(3)


def without(body, *triangles):
    return mesh(body.points, np.delete(body.triangles, triangles, axis=0))


def with_cells(body, *triangles):
    return mesh(body.points, np.concatenate([body.triangles, np.array(triangles, dtype=np.int32).reshape(-1, 3)]))


def turned_over(body, *triangles):
    changed = body.triangles.copy()
    changed[list(triangles)] = changed[list(triangles), ::-1]
    return mesh(body.points, changed)


# ---- clean bodies ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "body, genus",
    [
        (CUBE, 0),
        (BALL, 0),
        (meshes.cylinder(), 0),
        (meshes.torus(2.0, 0.5), 1),
        (joined(CUBE, moved(CUBE, (5, 0, 0))), 0),
        (joined(meshes.torus(2.0, 0.5), moved(meshes.torus(2.0, 0.5), (9, 0, 0))), 2),
    ],
)
def test_nothing_is_found_on_a_clean_body(body, genus):
    found = check(body)
    assert found.found == {} and found.Clean == found.Fit == found.Closed == 1
    assert not found.errors and not found.warnings and found.status == 0
    assert found.Genus == genus
    assert found.Volume == pytest.approx(measures.volume(body), rel=1e-12)
    assert found.Area == pytest.approx(measures.area(body), rel=1e-12)
    assert sum(found.shells("Volume")) == pytest.approx(found.Volume, rel=1e-12)
    assert found.VertexCount - found.EdgeCount + found.TriangleCount == found.EulerCharacteristic
    assert found.EulerCharacteristic == 2 * found.ShellCount - 2 * genus
    assert not found.cell_data["Defect"].any() and not found.point_data["PointDefect"].any()
    assert found.defects.GetNumberOfCells() == found.defects.GetNumberOfPoints() == 0
    assert "nothing is wrong" in found.Verdict


def test_handles_are_counted():
    """Two rings that overlap are united by a Boolean: a double torus."""
    ring = meshes.torus(2.0, 0.5, around=48, across=24)
    double = boolean([ring], [moved(ring, (4.0, 0.03, 0.02))], "Union").surface
    assert check(double).Genus == 2 and check(double).ShellCount == 1
    plate = box((0, 0, 0), (10, 10, 1))
    holes = [meshes.cylinder(0.5, 4.0, (x, y, 0.5)) for x in (2, 5, 8) for y in (2.1, 7.9)]
    assert check(boolean([plate], holes, "Difference").surface).Genus == 6


def test_points_of_creases_are_no_defect():
    source = vtkCubeSource()
    source.Update()
    found = check(source.GetOutput())
    assert found.Clean == 1 and found.DuplicatePointCount == 24 - 8 and found.VertexCount == 8
    assert found.point_data["DuplicatePoint"].sum() == 16 and found.TriangleCount == 12
    assert "16 points are at the place of an earlier one" in found.Verdict


# ---- open surfaces ------------------------------------------------------------------------------------


def test_a_missing_triangle_is_a_loop_of_three_edges():
    hole = BALL.triangles[17]
    found = check(without(BALL, 17))
    assert found.found == {"BoundaryEdge": 3, "BoundaryLoop": 1} and found.Fit == found.Closed == 0
    assert found.places(BOUNDARY) == sorted(
        sorted(BALL.points[[hole[k], hole[(k + 1) % 3]]].tolist()) for k in range(3)
    )
    assert len(found.cells(BOUNDARY)) == 3 and set(found.defect_data["LoopId"]) == {0}
    assert np.flatnonzero(found.point_data["LoopId"] == 0).tolist() == sorted(hole)
    assert "1 loop" in found.Verdict and found.Genus == 0


def test_loops_are_told_apart():
    flat = meshes.sheet(lambda x, y: 0 * x, np.arange(9.0), np.arange(7.0))
    middle = [t for t, corners in enumerate(flat.triangles) if np.all(np.abs(flat.points[corners] - [4, 3, 0]) <= 1)]
    found = check(without(flat, *middle))
    assert found.found == {"BoundaryEdge": 28 + 8, "BoundaryLoop": 2} and found.Genus == 0
    inner = np.all(np.abs(points_of_lines(found) - [4, 3, 0]) <= 1, axis=(1, 2))
    loop = found.defect_data["LoopId"]
    assert np.count_nonzero(inner) == 8 and len(set(loop[inner])) == len(set(loop[~inner])) == 1
    assert set(loop) == {0, 1}


def points_of_lines(found):
    _, ids = cells_of(found.defects.GetLines())
    return points_of(found.defects)[ids.reshape(-1, 2)]


def test_holes_that_touch_in_a_point_are_two_loops_along_the_fans():
    """Opposite corners of the point's fan are taken away: the surface narrows to the point, twice."""
    flat = meshes.sheet(lambda x, y: 0 * x, np.arange(5.0), np.arange(5.0))
    squares = [
        t
        for t, corners in enumerate(flat.triangles)
        if np.all(flat.points[corners, :2] <= 2) and np.all(flat.points[corners, :2] >= 1)
        or np.all(flat.points[corners, :2] >= 2) and np.all(flat.points[corners, :2] <= 3)
    ]
    found = check(without(flat, *squares))
    assert found.found == {"BoundaryEdge": 16 + 8, "BoundaryLoop": 2, "NonManifoldPoint": 1}
    assert found.places(TOUCHING) == [[[2.0, 2.0, 0.0]]]
    assert found.point_data["PointDefect"][np.all(flat.points == [2, 2, 0], axis=1)].tolist() == [TOUCHING]


# ---- too many triangles -----------------------------------------------------------------------------------


def test_cubes_that_share_an_edge():
    found = check(joined(CUBE, moved(CUBE, (2, 2, 0))))
    assert found.found == {"NonManifoldEdge": 1} and found.Fit == 1 and found.Clean == 0
    assert found.places(NON_MANIFOLD) == [[[2.0, 2.0, 0.0], [2.0, 2.0, 2.0]]]
    assert found.defect_data["TriangleCount"].tolist() == [4] and found.ShellCount == 1
    assert len(found.cells(NON_MANIFOLD)) == 4 and found.Genus == -1


def test_cubes_that_share_a_point():
    found = check(joined(CUBE, moved(CUBE, (2, 2, 2))))
    assert found.found == {"NonManifoldPoint": 1} and found.Fit == 1 and found.Clean == 0
    assert found.places(TOUCHING) == [[[2.0, 2.0, 2.0]]] and found.ShellCount == 2
    assert np.flatnonzero(found.point_data["PointDefect"] == TOUCHING).tolist() == [7, 8]


def test_a_fin_on_a_ball():
    corners = BALL.points[BALL.triangles[5]]
    fin = mesh([corners[0], corners[1], 2 * corners[2]], [[0, 1, 2]])
    found = check(joined(BALL, fin))
    assert found.found == {"NonManifoldEdge": 1, "BoundaryEdge": 2, "BoundaryLoop": 1}
    assert found.Fit == 0 and found.places(NON_MANIFOLD) == [sorted(corners[:2].tolist())]


def test_a_triangle_that_is_there_twice():
    for copy in (BALL.triangles[40], np.roll(BALL.triangles[40], 1)):
        found = check(with_cells(BALL, copy))
        assert found.found == {"DuplicateCell": 1, "NonManifoldEdge": 3} and found.Fit == 0
        assert found.cells(DUPLICATE) == [len(BALL.triangles)]
        assert np.flatnonzero(found.cell_data["Duplicate"]).tolist() == [len(BALL.triangles)]
    # Once more the other way round: closed, since the two enclose nothing.
    found = check(with_cells(BALL, BALL.triangles[40], BALL.triangles[40][::-1]))
    assert found.found == {"DuplicateCell": 2, "NonManifoldEdge": 3} and found.Fit == 1


# ---- orientation ------------------------------------------------------------------------------------------


def test_triangles_that_are_turned_over():
    turned = [3, 100, 555]
    found = check(turned_over(BALL, *turned))
    assert found.found == {"InconsistentEdge": 9, "WrongWayTriangle": 3} and found.Fit == 0
    assert found.cells(WRONG_WAY) == turned and len(found.cells(INCONSISTENT)) == 9
    edges = {tuple(sorted(BALL.triangles[t][[k, (k + 1) % 3]])) for t in turned for k in range(3)}
    assert found.places(INCONSISTENT) == sorted(sorted(BALL.points[list(edge)].tolist()) for edge in edges)
    assert "Generate Surface Normals" in found.Verdict and "Consistency" in found.Verdict


def test_a_body_that_is_inside_out():
    found = check(meshes.inside_out(BALL))
    assert found.found == {"WrongWayTriangle": len(BALL.triangles), "InvertedShell": 1}
    assert found.Fit == 0 and found.Closed == 1 and found.Volume < 0 and "Reverse Sense" in found.Verdict


@pytest.mark.parametrize("inner_inverted", (False, True))
@pytest.mark.parametrize("outer_inverted", (False, True))
def test_a_ball_in_a_ball(outer_inverted, inner_inverted):
    """Only the outer outwards with the inner inwards is a hollow ball."""
    parts = [BALL, meshes.scaled(meshes.icosphere(2), 0.5)]
    parts = [meshes.inside_out(p) if i else p for p, i in zip(parts, (outer_inverted, inner_inverted))]
    found = check(joined(*parts))
    assert found.shells("Depth") == [0, 1] and found.shells("Parent") == [-1, 0]
    state = {(False, False): [0, 2], (False, True): [0, 0], (True, False): [1, 1], (True, True): [1, 1]}
    assert found.shells("WrongWay") == state[outer_inverted, inner_inverted]
    assert found.Clean == (state[outer_inverted, inner_inverted] == [0, 0])
    assert found.Fit == (not outer_inverted)
    if (outer_inverted, inner_inverted) == (False, False):
        assert "nothing new" in found.Verdict and found.found == {"CoveredShell": 1}


def test_one_of_two_balls_is_inside_out():
    """The volume of both together is positive, so that a Boolean does not notice."""
    found = check(joined(BALL, moved(meshes.inside_out(meshes.scaled(BALL, 0.5)), (3, 0, 0))))
    assert found.Volume > 0 and found.found["InvertedShell"] == 1 and found.Fit == 0
    assert found.shells("WrongWay") == [0, 1] and "1 shell is inside out" in found.Verdict
    assert set(found.cells(WRONG_WAY)) == set(range(len(BALL.triangles), 2 * len(BALL.triangles)))


def test_many_bodies_in_a_hollow_one():
    rng = np.random.default_rng(1)
    cells = [moved(box((0, 0, 0), (0.5, 0.5, 0.5)), p) for p in np.argwhere(np.ones((5, 5, 5))) + 0.2]
    order = rng.permutation(len(cells) + 2)
    parts = cells + [box((-1, -1, -1), (7, 7, 7)), meshes.inside_out(box((-0.5, -0.5, -0.5), (6, 6, 6)))]
    found = check(joined(*[parts[k] for k in order]))
    depth = {len(cells): 0, len(cells) + 1: 1}
    assert found.shells("Depth") == [depth.get(k, 2) for k in order]
    hollow = int(np.flatnonzero(order == len(cells) + 1)[0])
    assert all(found.shells("Parent")[i] == hollow for i, k in enumerate(order) if k < len(cells))
    assert found.Clean == 1


# ---- self-intersections -------------------------------------------------------------------------------------


def test_two_balls_that_overlap():
    """The same pairs of triangles as the intersection of the two finds."""
    from intersections import intersection

    other = moved(BALL, (0.9, 0.123, 0.07))
    found, curves = check(joined(BALL, other)), intersection(BALL, other)
    assert found.found == {"SelfIntersection": int(curves.field_data["ContactCount"][0])} and found.Fit == 1
    lines = points_of_lines(found)
    assert np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1).sum() == pytest.approx(curves.length, rel=1e-12)
    cells = found.defect_data["CellIds"]
    assert np.all(cells[:, 0] < len(BALL.triangles)) and np.all(cells[:, 1] >= len(BALL.triangles))
    counts = np.bincount(cells.ravel(), minlength=2 * len(BALL.triangles))
    assert np.array_equal(found.cell_data["SelfIntersections"], counts)
    assert "Resolve" in found.Verdict
    resolved = boolean([joined(BALL, other)], [], "Resolve").surface
    assert check(resolved).Fit == 1 and check(resolved).SelfIntersectionCount < found.SelfIntersectionCount / 10


def test_the_search_can_be_switched_off():
    found = check(joined(BALL, moved(BALL, (0.9, 0.123, 0.07))), SelfIntersections=0)
    assert found.SelfIntersectionCount == -1 and "not looked for" in found.Verdict
    assert "Self-intersections" not in found.field_data["StageNames"] and found.places(SELF) == []


def test_a_corner_that_touches_a_face():
    spike = mesh([[1, 0.5, 2], [0, 0, 4], [2, 0, 4], [1, 2, 4]], [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]])
    found = check(joined(CUBE, spike))
    assert found.found == {"SelfIntersection": 3}, "three triangles of the spike, one of the cube"
    assert found.places(SELF) == [[[1.0, 0.5, 2.0]]] * 3


# ---- cells without area, bad input ----------------------------------------------------------------------------


def test_cells_without_area():
    points = np.vstack([CUBE.points, [[1, 0, 0]]])
    edge_split = mesh(points, np.vstack([CUBE.triangles, [[0, 1, 8], [0, 0, 3], [5, 5, 5]]]))
    found = check(edge_split)
    assert found.DegenerateCellCount == 3 and found.cells(NO_AREA) == [12, 13, 14]
    assert found.places(NO_AREA) == sorted([[[0, 0, 0], [2, 0, 0]], [[0, 0, 0], [2, 2, 0]], [[2, 0, 2]]])


def test_a_seam_stitched_by_a_triangle_without_area_is_clean_but_for_that():
    """The front face uses an edge whole, the bottom face in two parts."""
    points = np.vstack([CUBE.points, [[1, 0, 0]]])
    cells = [t for t in CUBE.triangles.tolist() if not {0, 1} <= set(t)]
    for t in CUBE.triangles.tolist():
        if {0, 1} <= set(t):
            if 5 in t or 4 in t:
                cells.append(t)
            else:
                k = next(k for k in range(3) if {t[k], t[(k + 1) % 3]} == {0, 1})
                a, b, c = t[k], t[(k + 1) % 3], t[(k + 2) % 3]
                cells += [[a, 8, c], [8, b, c], [a, b, 8]]
    found = check(mesh(points, cells))
    assert found.found == {"DegenerateCell": 1} and found.Fit == 1 and found.Closed == 1


def test_cells_that_cannot_be_used():
    bad = mesh(np.vstack([CUBE.points, [[np.nan, 0, 0]]]), np.vstack([[[0, 1, 77]], CUBE.triangles, [[0, 1, 8]]]))
    found = check(bad)
    assert found.BadIndexCellCount == 1 and found.NonFiniteCellCount == 1 and found.NonFinitePointCount == 1
    assert found.Fit == 0 and found.Closed == 1 and found.Volume == 8.0 and not found.errors
    assert found.field_data["BadCellIds"].tolist() == [0, 13]
    assert found.field_data["BadPointIds"].tolist() == [8]
    assert found.surface.GetNumberOfCells() == 12 and found.surface.GetNumberOfPoints() == 8, "Surface can be drawn"
    assert np.array_equal(points_of(found.surface), CUBE.points) and check(found.surface).Clean == 1
    assert "do" in found.Verdict and "left out" in found.Verdict
    assert boolean([bad], [moved(CUBE, (1, 1, 1))], "Union").errors


def test_arrays_stay_with_their_points_and_cells_when_some_are_left_out():
    data = polydata(mesh(np.vstack([[[np.inf, 0, 0]], CUBE.points]), np.vstack([[[0, 1, 77]], CUBE.triangles + 1])))
    for attributes, count in ((data.GetCellData(), 13), (data.GetPointData(), 9)):
        numbers = numpy_to_vtk(np.arange(count), deep=True)
        numbers.SetName("Number")
        attributes.AddArray(numbers)
    lines = vtkCellArray()
    lines.InsertNextCell(2, [0, 3])
    lines.InsertNextCell(2, [1, 3])
    data.SetLines(lines)
    numbers = numpy_to_vtk(np.arange(15), deep=True)
    numbers.SetName("Number")
    data.GetCellData().AddArray(numbers)
    found = check(data)
    assert found.cell_data["Number"].tolist() == [1] + list(range(3, 15)), "one line and one triangle are left out"
    assert found.point_data["Number"].tolist() == list(range(1, 9)) and np.isfinite(found.surface.GetBounds()).all()


# ---- kinds of input -------------------------------------------------------------------------------------------


def test_polygons_strips_and_other_cells_beside_them():
    quads = polydata(CUBE, meshes.BOX_QUADS.tolist())
    vertices, lines = vtkCellArray(), vtkCellArray()
    vertices.InsertNextCell(1, [0])
    lines.InsertNextCell(2, [0, 7])
    quads.SetVerts(vertices)
    quads.SetLines(lines)
    found = check(quads)
    assert found.Clean == 1 and found.Volume == 8.0 and found.surface.GetNumberOfCells() == 8
    assert found.cell_data["ShellId"].tolist() == [-1, -1] + 6 * [0]
    stripper = vtkStripper()
    stripper.SetInputData(polydata(BALL))
    stripper.Update()
    found = check(stripper.GetOutput())
    assert found.Clean == 1 and found.TriangleCount == len(BALL.triangles)
    hole = polydata(CUBE, meshes.BOX_QUADS.tolist()[:5])
    assert check(hole).found == {"BoundaryEdge": 4, "BoundaryLoop": 1}


def test_duplicate_polygons_wherever_they_start():
    quads = meshes.BOX_QUADS.tolist()
    found = check(polydata(CUBE, quads + [quads[2][1:] + quads[2][:1]]))
    assert found.DuplicateCellCount == 1 and found.cells(DUPLICATE) == [6] and found.SelfIntersectionCount == 0


def test_a_composite_data_set_is_one_surface():
    """The two halves of a ball, in two blocks."""
    half = np.arange(len(BALL.triangles)) < 500
    blocks = vtkMultiBlockDataSet()
    for number, part in enumerate((half, ~half)):
        blocks.SetBlock(number, polydata(mesh(BALL.points, BALL.triangles[part])))
    found = check(blocks)
    assert found.Clean == 1 and found.ShellCount == 1


def test_float_points_stay_floats():
    source = vtkCubeSource()
    source.SetOutputPointsPrecision(0)
    source.Update()
    found = check(source.GetOutput())
    assert found.surface.GetPoints().GetDataType() == found.defects.GetPoints().GetDataType() == 10


def test_empty_input_and_what_is_no_surface():
    found = check(vtkPolyData())
    assert found.Fit == 0 and not found.errors and "no polygon" in found.Verdict
    from vtkmodules.vtkCommonDataModel import vtkImageData

    for wrong, status in ((vtkImageData(), 20), (None, 10)):
        found = check(wrong)
        assert found.status == status and len(found.errors) == 1 and "Input" in found.message
        assert found.surface.GetNumberOfPoints() == found.defects.GetNumberOfPoints() == 0


@pytest.mark.parametrize("body", [joined(BALL, moved(BALL, (0.9, 0.1, 0))), without(BALL, 3, 90), turned_over(BALL, 7)])
def test_the_same_bytes_for_any_number_of_threads(body):
    one, two, four = (check(body, NumberOfThreads=n) for n in (1, 2, 4))
    assert one.bytes() == two.bytes() == four.bytes() and one.Verdict == four.Verdict
