# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The options of the clip are those of vtkClipClosedSurface; data is carried; bad input is refused."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkClipClosedSurface

import measures
import meshes
from booleans import arrays_of, cells_of, points_of, polydata
from clips import bad_edges, clip, feature_edges

ABOVE = [((0, 0, 0.25), (0, 0, 1))]
CORNER = ABOVE + [((0.5, 0, 0), (-1, 0, 0))]


def labelled(body, with_colors=False):
    """A mesh with a cell array and a point array that is linear in the coordinates."""
    data = polydata(body)
    cells = numpy_to_vtk(np.arange(len(body.triangles)) * 10.0, deep=True)
    cells.SetName("Tens")
    data.GetCellData().AddArray(cells)
    linear = numpy_to_vtk(body.points @ [1.0, 2.0, 3.0] + 4.0, deep=True)
    linear.SetName("Linear")
    data.GetPointData().AddArray(linear)
    if with_colors:
        colors = np.tile(np.array([[10, 20, 30]], dtype=np.uint8), (len(body.triangles), 1))
        array = numpy_to_vtk(colors, deep=True)
        array.SetName("Paint")
        data.GetCellData().SetScalars(array)
    return data


def test_defaults_are_those_of_the_page_but_the_tolerance():
    from surfacebooleans.vtk import vtkPolyDataClipClosedSurface

    ours, theirs = vtkPolyDataClipClosedSurface(), vtkClipClosedSurface()
    for name in (
        "GenerateFaces GenerateOutline ScalarMode PassPointData BaseColor ClipColor "
        "ActivePlaneColor ActivePlaneId ClippingPlanes ScalarModeAsString"
    ).split():
        assert getattr(ours, "Get" + name)() == getattr(theirs, "Get" + name)(), name
    assert ours.GetTolerance() == 0.0  # exact: none is needed


def test_labels_and_colors_tell_the_caps_and_the_active_plane():
    body = meshes.cube(2.0)
    labels = clip(body, CORNER, ScalarMode=2, ActivePlaneId=1)
    source = labels.cell_data["SourceId"]
    assert np.array_equal(labels.cell_data["Labels"], np.array([0, 1, 2])[source])
    colors = clip(body, CORNER, ScalarMode=1, ActivePlaneId=1).cell_data["Colors"]
    assert np.array_equal(colors, np.array([[255, 0, 0], [255, 128, 0], [255, 255, 0]])[source])
    assert "Colors" not in clip(body, CORNER).cell_data
    data = clip(body, CORNER, ScalarMode=1).surface.GetCellData()
    assert data.GetScalars().GetName() == "Colors"


def test_chained_filters_keep_the_colors_of_the_first():
    first = clip(meshes.cube(2.0), ABOVE, ScalarMode=1, ClipColor=(0, 0, 1))
    second = clip(first.surface, CORNER[1:], ScalarMode=1, ClipColor=(0, 1, 0))
    found = {tuple(c) for c in second.cell_data["Colors"].tolist()}
    assert found == {(255, 0, 0), (0, 0, 255), (0, 255, 0)}
    painted = clip(labelled(meshes.cube(2.0), with_colors=True), ABOVE, ScalarMode=1)
    assert {tuple(c) for c in painted.cell_data["Colors"].tolist()} == {(10, 20, 30), (255, 128, 0)}
    assert {tuple(c) for c in painted.cell_data["Paint"].tolist()} == {(10, 20, 30), (0, 0, 0)}  # still there


def test_cell_data_goes_with_the_cells_and_caps_have_none():
    result = clip(labelled(meshes.cube(2.0)), CORNER)
    tens, original = result.cell_data["Tens"], result.cell_data["OriginalCellId"]
    caps = result.cell_data["SourceId"] > 0
    assert np.array_equal(tens[~caps], 10.0 * original[~caps])
    assert np.all(original[caps] == -1) and np.all(np.isnan(tens[caps]))


def test_point_data_is_passed_only_if_asked_for_and_interpolated_on_rims():
    body = meshes.torus(2.0, 1.0)
    assert clip(labelled(body), CORNER).point_data == {}
    result = clip(labelled(body), CORNER, PassPointData=True)
    linear = result.point_data["Linear"]
    inside = np.isnan(linear)  # where two planes meet within the solid there is no data
    expected = result.body.points @ [1.0, 2.0, 3.0] + 4.0
    assert np.allclose(linear[~inside], expected[~inside], rtol=0, atol=1e-12)
    assert np.count_nonzero(inside) == 0 and bad_edges(result.body) == 0


def test_points_that_coincide_stay_apart_where_they_carry_data():
    body = meshes.cube(2.0)
    creased = meshes.mesh(body.points[body.triangles.ravel()], np.arange(36))
    result = clip(labelled(creased), ABOVE, PassPointData=True)
    assert measures.is_closed(result.body) and bad_edges(result.body) > 0
    assert result.volume == pytest.approx(4 * 0.75, rel=1e-15)


def lines_of(data):
    offsets, ids = cells_of(data.GetLines())
    return [points_of(data)[ids[a:b]] for a, b in zip(offsets[:-1], offsets[1:])]


def test_outlines_run_along_the_rims_of_caps():
    result = clip(meshes.cube(2.0), CORNER, GenerateOutline=True, ScalarMode=2)
    for data in (result.surface, result.outline):
        lines = lines_of(data)
        assert len(lines) == 2
        assert all(np.array_equal(line[0], line[-1]) for line in lines)
        lengths = [np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in lines]
        assert lengths == pytest.approx([2 * (2 + 1.5), 2 * (2 + 0.75)], rel=1e-15)
        arrays = arrays_of(data.GetCellData())
        assert arrays["SourceId"][:2].tolist() == [1, 2] and arrays["Labels"][:2].tolist() == [1, 1]
    assert result.outline.GetNumberOfPolys() == 0
    assert clip(meshes.cube(2.0), CORNER).outline.GetNumberOfCells() == 0


def test_without_faces_the_outlines_are_left():
    result = clip(meshes.cube(2.0), CORNER, GenerateFaces=False, GenerateOutline=True)
    assert result.surface.GetNumberOfPolys() == 0 and result.surface.GetNumberOfLines() == 2
    assert result.surface.GetNumberOfPoints() == len({p.tobytes() for p in points_of(result.surface)})
    empty = clip(meshes.cube(2.0), CORNER, GenerateFaces=False)
    assert empty.surface.GetNumberOfCells() == empty.surface.GetNumberOfPoints() == 0


def with_lines(body):
    data = labelled(body)
    lines, verts = vtkCellArray(), vtkCellArray()
    for edge in ((0, 4), (4, 5), (0, 1)):
        lines.InsertNextCell(2, edge)
    verts.InsertNextCell(1, (0,))
    data.SetLines(lines)
    data.SetVerts(verts)
    values = numpy_to_vtk(np.arange(data.GetNumberOfCells()) * 10.0, deep=True)
    values.SetName("Tens")
    data.GetCellData().AddArray(values)
    return data


def test_lines_are_clipped_if_outlines_are_wanted_and_vertices_are_dropped():
    data = with_lines(meshes.cube(2.0))
    plain = clip(data, ABOVE)
    assert plain.surface.GetNumberOfLines() == plain.surface.GetNumberOfVerts() == 0
    assert plain.cell_data["OriginalCellId"].max() == 4 + 11
    result = clip(data, ABOVE, GenerateOutline=True)
    lines = lines_of(result.surface)
    arrays = result.cell_data
    own = [line for line, source in zip(lines, arrays["SourceId"]) if source == 0]
    assert result.surface.GetNumberOfVerts() == 0 and len(own) == 2  # one is cut, one dropped
    assert sorted(np.linalg.norm(np.diff(line, axis=0)) for line in own) == [0.75, 2.0]
    first = arrays["SourceId"][: len(lines)] == 0
    assert arrays["Tens"][: len(lines)][first].tolist() == [10.0, 20.0]


def test_an_outline_source_without_polygons_gives_its_lines():
    data = vtkPolyData()
    source = with_lines(meshes.cube(2.0))
    data.SetPoints(source.GetPoints())
    data.SetLines(source.GetLines())
    result = clip(data, ABOVE, GenerateOutline=True, ScalarMode=1)
    assert result.surface.GetNumberOfLines() == 2 and not result.warnings


def test_inside_out_keeps_the_rest_for_many_planes_too():
    body = meshes.torus(2.0, 1.0)
    for planes in (CORNER, CORNER + [((0, 0.1, 0), (0.2, 1, 0.3))]):
        kept, rest = clip(body, planes), clip(body, planes, InsideOut=True)
        assert bad_edges(rest.body) == 0 and feature_edges(rest.surface) == 0
        assert kept.volume + rest.volume == pytest.approx(measures.volume(body), rel=1e-13)
        assert kept.cap_points == rest.cap_points
    boxed = {"UseBox": True, "Box": (-1, 1, -1, 1, -1, 1)}
    hollow = clip(meshes.cube(4.0), InsideOut=True, **boxed)
    assert hollow.volume == 56.0 and bad_edges(hollow.body) == 0


# ---- open input --------------------------------------------------------------------------------


def without(body, keep):
    """The triangles whose centre passes `keep`."""
    centers = body.points[body.triangles].mean(axis=1)
    return meshes.mesh(body.points, body.triangles[keep(centers)])


def test_an_open_surface_is_closed_where_its_boundary_is_clipped_away():
    bowl = without(meshes.sphere(1.0, around=32, along=32), lambda c: c[:, 2] < 0.8)
    result = clip(bowl, [((0, 0, 0.5), (0, 0, -1))])
    assert result.status == 0 and not result.warnings and bad_edges(result.body) == 0


def test_open_contours_are_joined_along_their_hull():
    """A trough, open on top, cut across: the cap is closed over the opening."""
    trough = without(meshes.box((0, 0, 0), (4, 2, 1)), lambda c: c[:, 2] < 0.9)
    result = clip(trough, [((1.5, 0, 0), (1, 0, 0))])
    assert result.status == 24 and len(result.warnings) == 1
    assert "0 contours stayed open" in result.message and "1 were closed" in result.message
    assert result.field_data["CapArea"][0] == pytest.approx(2.0, rel=1e-15)
    assert result.field_data["OpenContourCount"][0] == 0


def test_contours_that_cannot_be_joined_get_no_cap_and_are_counted():
    """A slit within a closed box: its ends are not on the hull."""
    slit = meshes.sheet(lambda x, y: 0 * x, np.linspace(-0.5, 0.5, 3), np.linspace(-0.5, 0.5, 3))
    slit = meshes.turned(slit, meshes.rotation((1.0, 0.0, 0.0), np.pi / 2))
    both = meshes.joined(meshes.cube(4.0), slit)
    result = clip(both, [((0, 0, 0.1), (0, 0, 1))])
    assert "1 contours stayed open" in result.message
    assert result.field_data["OpenContourCount"][0] == 1
    assert result.field_data["CapArea"][0] == 16.0


# ---- bad input ---------------------------------------------------------------------------------


def refused(result, status, *words):
    assert result.status == status and len(result.errors) == 1
    assert result.message in result.errors[0]
    assert result.surface.GetNumberOfPoints() == result.outline.GetNumberOfPoints() == 0
    assert result.message.endswith(".") and ". " not in result.message
    for word in words:
        assert word in result.message, result.message


def test_bad_planes_and_tolerances_are_refused():
    body = meshes.cube(2.0)
    refused(clip(body, UsePlane=True, Normal=(0, 0, 0)), 10, "Plane 0", "length 0")
    refused(clip(body, UsePlane=True, Normal=(0, np.nan, 1)), 10, "not finite")
    refused(clip(body, Tolerance=-1.0), 10, "Tolerance")
    refused(clip(body, Tolerance=np.inf), 10, "Tolerance")


def test_a_tolerance_closes_cracks():
    closed = meshes.icosphere(3)
    noise = np.random.default_rng(1).uniform(-1e-7, 1e-7, (3 * len(closed.triangles), 3))
    cracked = meshes.mesh(closed.points[closed.triangles.ravel()] + noise, np.arange(len(noise)).reshape(-1, 3))
    result = clip(cracked, ABOVE, Tolerance=1e-4)
    assert measures.open_edges(result.body) == 0
    assert result.volume == pytest.approx(clip(closed, ABOVE).volume, abs=1e-3)
    assert measures.open_edges(clip(cracked, ABOVE).body) > 0


def test_bad_surfaces_are_refused():
    body = meshes.cube(2.0)
    points = body.points.copy()
    points[3, 1] = np.inf
    refused(clip(meshes.mesh(points, body.triangles), ABOVE), 6, "finite")
    triangles = body.triangles.copy()
    triangles[5, 0] = 99
    refused(clip(meshes.mesh(body.points, triangles), ABOVE), 7, "cell 5")
    refused(clip(vtkImageData(), ABOVE), 20, "Input")


def test_an_empty_input_gives_an_empty_output_and_says_so():
    result = clip(vtkPolyData(), ABOVE)
    assert result.status == 1 and not result.errors and len(result.warnings) == 1


def test_points_of_no_polygon_are_left_out_and_may_be_anything():
    body = meshes.cube(2.0)
    extra = meshes.mesh(np.vstack([body.points, [[np.nan, 0, 0], [0, 0, 0.9]]]), body.triangles)
    result = clip(extra, ABOVE)
    assert result.status == 0 and len(result.body.points) == len(clip(body, ABOVE).body.points)
