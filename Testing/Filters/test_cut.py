# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Cross-sections are whole polygons with the right area, perimeter and nesting; contours are filled
without holes or overlaps."""

import time

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import measures
import meshes
from booleans import cells_of, points_of
from clips import bad_edges, clip, cut, triangulate

UP = (0, 0, 1)


def nested():
    """Shells within shells: solid, hole, solid, hole."""
    return meshes.joined(
        meshes.cube(8.0),
        meshes.inside_out(meshes.cube(6.0)),
        meshes.cube(4.0),
        meshes.inside_out(meshes.cube(2.0)),
    )


def polygons_of(result):
    """(plane, nesting, area, perimeter) by polygon id."""
    names = ("SourceId", "Nesting", "Area", "Perimeter")
    rows = zip(*(result.cell_data[name].tolist() for name in names))
    return dict(zip(result.cell_data["PolygonId"].tolist(), rows))


def areas_of(body):
    corners = body.points[body.triangles]
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2


def test_each_polygon_has_its_area_perimeter_and_nesting():
    result = cut(nested(), (0, 0, 0.5), UP, (0.0, 2.9, 1.0))
    assert result.status == 0
    assert set(polygons_of(result).values()) == {
        (0, 0, 28.0, 56.0),
        (0, 1, 12.0, 24.0),
        (1, 0, 64.0, 32.0),
        (2, 0, 28.0, 56.0),
        (2, 1, 16.0, 16.0),
    }
    assert result.field_data["SliceArea"].tolist() == [40.0, 64.0, 44.0]
    assert result.field_data["PolygonCount"][0] == 5


def test_triangles_face_along_the_normal_and_lie_in_their_plane():
    offsets = np.linspace(-0.9, 0.9, 7)
    normal = np.array([1.0, 2.0, 2.0]) / 3
    result = cut(meshes.torus(2.0, 1.0), (0.1, 0, 0), tuple(3 * normal), offsets)
    areas = areas_of(result.body) @ normal
    assert np.all(areas > 0)
    sums = np.bincount(result.cell_data["SourceId"], areas)
    assert np.allclose(sums, result.field_data["SliceArea"], rtol=1e-13)
    heights = (result.body.points[result.body.triangles] - [0.1, 0, 0]) @ normal
    assert np.allclose(heights, result.cell_data["Offset"][:, None], rtol=0, atol=1e-14)
    assert np.array_equal(result.cell_data["Offset"], offsets[result.cell_data["SourceId"]])


def test_a_cross_section_is_the_cap_of_a_clip():
    body = meshes.torus(2.0, 1.0, 40, 20)
    for origin, normal in (((0.3, 0.2, 0.1), (1, 2, 3)), ((0, 0, 0), (0, 0, 1))):
        caps = clip(body, [(origin, normal)])
        section = cut(body, origin, normal)
        assert section.field_data["SliceArea"][0] == pytest.approx(
            caps.field_data["CapArea"][0], rel=1e-13
        )
        assert caps.cap_points == {p.tobytes() for p in section.body.points + 0.0}


def test_outlines_are_closed_lines_holes_the_other_way_round():
    result = cut(nested(), (0, 0, 0.5), UP, Triangulate=False)
    assert result.surface.GetNumberOfPolys() == 0
    offsets, ids = cells_of(result.surface.GetLines())
    points = points_of(result.surface)
    signed = []
    for a, b in zip(offsets[:-1], offsets[1:]):
        line = points[ids[a:b]]
        assert np.array_equal(line[0], line[-1])
        signed.append(0.5 * np.sum(line[:-1, 0] * line[1:, 1] - line[:-1, 1] * line[1:, 0]))
    assert signed == [64.0, -36.0, 16.0, -4.0]
    assert result.cell_data["Hole"].tolist() == [0, 1, 0, 1]
    assert result.cell_data["Nesting"].tolist() == [0, 0, 1, 1]


def test_solids_that_overlap_are_united_in_the_cross_section():
    pair = meshes.joined(meshes.cube(2.0), meshes.cube(2.0, (1, 1, 0)))
    result = cut(pair, (0, 0, 0.5), UP)
    assert polygons_of(result) == {0: (0, 0, 7.0, 12.0)}


def test_faces_in_the_plane_belong_to_what_is_in_front():
    cube = meshes.cube(2.0)
    assert cut(cube, (0, 0, -1), UP).field_data["SliceArea"][0] == 4.0
    assert cut(cube, (0, 0, 1), UP).field_data["SliceArea"][0] == 0.0
    assert cut(cube, (0, 0, 0), UP).field_data["SliceArea"][0] == 4.0


def grid_of_balls(count):
    ball = meshes.icosphere(1, 0.4)
    places = np.stack(np.meshgrid(np.arange(count), np.arange(count)), -1).reshape(-1, 2)
    points = ball.points + np.column_stack([places, np.zeros(len(places))])[:, None, :]
    first = len(ball.points) * np.arange(len(places))
    return meshes.mesh(points.reshape(-1, 3), ball.triangles + first[:, None, None])


def test_ten_thousand_contours_in_one_cut():
    """And the time grows little faster than their number."""
    plane = ((0, 0, 0.05), (0.001, 0.002, 1.0))
    seconds = []
    for count in (50, 100):
        balls = grid_of_balls(count)
        start = time.perf_counter()
        result = cut(balls, *plane)
        seconds.append(time.perf_counter() - start)
        assert result.field_data["PolygonCount"][0] == count * count
    assert seconds[1] < 4 * 3 * seconds[0]
    half = clip(balls, [plane])
    assert bad_edges(half.body) == 0
    plate = meshes.joined(meshes.box((-1, -1, -1), (100, 100, 1)), meshes.inside_out(balls))
    holed = cut(plate, *plane)
    assert holed.field_data["PolygonCount"][0] == 1
    tilt = np.sqrt(1 + 0.001**2 + 0.002**2)
    assert holed.field_data["SliceArea"][0] + result.field_data["SliceArea"][0] == pytest.approx(
        101 * 101 * tilt, rel=1e-12
    )


# ---- the contour triangulator ------------------------------------------------------------------


def lines(*polylines):
    """Line cells, each with points of its own."""
    points, cells = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for polyline in polylines:
        cells.InsertNextCell(len(polyline))
        for point in polyline:
            cells.InsertCellPoint(points.InsertNextPoint(point))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(cells)
    return data


def square(size, height=0.0, direction=1):
    corners = [(0, 0), (size, 0), (size, size), (0, size), (0, 0)][::direction]
    return [(x - size / 2, y - size / 2, height) for x, y in corners]


@pytest.mark.parametrize("direction", (1, -1))
def test_contours_within_contours_are_holes_whatever_their_direction(direction):
    data = lines(square(8.0), square(6.0, direction=direction), square(2.0))
    result = triangulate(data)
    assert result.status == 0
    assert measures.area(result.body) == 64 - 36 + 4
    assert set(result.cell_data["Nesting"].tolist()) == {0, 1}
    assert len(result.body.triangles) == 8 + 2  # n - 2 + 2 holes


def test_triangles_are_as_few_as_can_be_and_no_worse_than_delaunay():
    rng = np.random.default_rng(8)
    angles = np.sort(rng.uniform(0, 2 * np.pi, 200))
    radii = rng.uniform(0.5, 1.0, 200)
    star = np.column_stack([radii * np.cos(angles), radii * np.sin(angles), np.full(200, 0.3)])
    tilted = star @ meshes.random_rotation(rng).T
    result = triangulate(lines(np.vstack([tilted, tilted[:1]])))
    assert len(result.body.triangles) == 198
    expected = 0.5 * np.sum(star[:, 0] * np.roll(star[:, 1], -1) - star[:, 1] * np.roll(star[:, 0], -1))
    assert measures.area(result.body) == pytest.approx(expected, rel=1e-12)


def test_contours_that_cross_and_touch_are_filled_where_odd():
    bow = [(0, 0, 0), (2, 2, 0), (2, 0, 0), (0, 2, 0), (0, 0, 0)]
    result = triangulate(lines(bow))
    assert measures.area(result.body) == pytest.approx(2.0, rel=1e-15)
    assert result.surface.GetNumberOfPoints() == 6  # one of them new
    assert measures.area(triangulate(lines(square(2.0), square(2.0))).body) == 0.0


def test_loose_ends_are_left_out_and_counted():
    result = triangulate(lines(square(2.0), [(5, 0, 0), (6, 1, 0), (7, 0, 0)]))
    assert result.status == 24 and "2 line segments" in result.message
    assert measures.area(result.body) == 4.0
    assert triangulate(vtkPolyData()).status == 0


def test_points_off_the_plane_are_remarked():
    crooked = square(2.0)
    crooked[2] = (1.0, 1.0, 0.5)
    result = triangulate(lines(crooked))
    assert result.status == 25 and len(result.body.triangles) == 2


def test_the_outlines_of_a_cut_fill_to_its_caps():
    body = meshes.torus(2.0, 1.0, 48, 24)
    outlines = cut(body, (0.1, 0.2, 0.3), (1, 1, 4), Triangulate=False)
    caps = cut(body, (0.1, 0.2, 0.3), (1, 1, 4))
    filled = triangulate(outlines.surface)
    assert measures.area(filled.body) == pytest.approx(caps.field_data["SliceArea"][0], rel=1e-12)
    assert len(filled.body.triangles) == len(caps.body.triangles)
