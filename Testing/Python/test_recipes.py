# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims about the recipes: what goes in, what comes out, what is raised and warned."""

import inspect
import os
import subprocess
import sys
import warnings

import numpy as np
import pytest
import surfacebooleans as sb
from surfacebooleans.meshes import faces_of, polydata
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPlane, vtkPolyData

import booleans
import clouds
import measures
import meshes

BOX = meshes.box((0, 0, 0), (2, 2, 2))
OTHER = meshes.box((1, 1, 1), (3, 3, 3))
FAR = meshes.box((5, 0, 0), (6, 1, 1))


def vtk(body):
    return booleans.polydata(body)


def volume(surface):
    body, _ = booleans.triangles_of(surface)
    assert measures.is_closed(body)
    return measures.volume(body)


def cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


# ---- Booleans ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "operation, expected",
    [("union", 15), ("intersection", 1), ("difference", 7), ("symmetric difference", 14), ("resolve", 15)],
)
def test_every_operation_by_its_name(operation, expected):
    assert volume(sb.boolean(vtk(BOX), vtk(OTHER), operation)) == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize("name", ["symmetric_difference", "Symmetric-Difference", "SYMMETRIC DIFFERENCE"])
def test_a_name_may_be_joined_in_any_way(name):
    assert volume(sb.boolean(vtk(BOX), vtk(OTHER), name)) == pytest.approx(14)


def test_lists_are_united_first():
    assert volume(sb.boolean([vtk(BOX), vtk(FAR)], [vtk(OTHER)], "difference")) == pytest.approx(8)
    assert volume(sb.boolean([vtk(BOX), vtk(OTHER), vtk(FAR)])) == pytest.approx(16)


def test_a_composite_counts_as_one_surface():
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, vtk(BOX))
    blocks.SetBlock(1, vtk(FAR))
    assert volume(sb.boolean(blocks, vtk(OTHER), "difference")) == pytest.approx(8)


def test_a_grid_counts_as_its_boundary():
    grid = vtkImageData()
    grid.SetDimensions(3, 3, 3)  # the box of edge 2
    assert volume(sb.boolean(grid, vtk(OTHER), "difference")) == pytest.approx(7)


def test_field_data_tell_how_it_went():
    fields = sb.fields_of(sb.boolean(vtk(BOX), vtk(OTHER)))
    assert (fields["Status"], fields["ResultVolume"]) == (0, pytest.approx(15))
    assert fields["OperandVolume"].tolist() == [8, 8]
    assert len(fields["StageNames"]) == len(fields["StageSeconds"])


def test_arrays_in_arrays_out():
    quads = (meshes.box_corners((0, 0, 0), (2, 2, 2)), meshes.BOX_QUADS)
    points, triangles = sb.boolean(quads, (OTHER.points, OTHER.triangles), "difference")
    assert points.dtype == np.float64 and points.shape[1] == 3
    assert np.issubdtype(triangles.dtype, np.integer) and triangles.shape[1] == 3
    body = meshes.mesh(points, triangles)
    assert measures.is_closed(body) and measures.volume(body) == pytest.approx(7)


def test_the_curves_come_too_if_asked_for():
    surface, curves = sb.boolean(vtk(BOX), vtk(OTHER), "union", curves=True)
    assert volume(surface) == pytest.approx(15)
    assert cells(curves, "Length").sum() == pytest.approx(6)


def test_inputs_are_left_alone():
    first, second = vtk(BOX), vtk(OTHER)
    before = booleans.bytes_of(first, second), first.GetMTime(), second.GetMTime()
    sb.boolean(first, second)
    assert (booleans.bytes_of(first, second), first.GetMTime(), second.GetMTime()) == before


def test_settings_reach_the_filter():
    gap = meshes.box((2 + 1e-9, 0, 0), (3, 2, 2))
    pieces = [faces_of(sb.boolean(vtk(BOX), vtk(gap), tolerance=t))[1] for t in (0.0, 1e-6)]
    assert len(pieces[0]) > len(pieces[1])  # the gap is closed, and the walls in it are gone
    inner = sb.boolean(vtk(BOX), vtk(OTHER), "difference", reorient=False)
    assert not measures.is_closed(booleans.triangles_of(inner)[0])


# ---- errors and warnings -----------------------------------------------------------------------


def test_an_error_is_raised_with_the_filters_sentence():
    with pytest.raises(sb.SurfaceBooleansError, match="^The difference needs a second surface.*set Tool") as caught:
        sb.boolean(vtk(BOX), None, "difference")
    assert caught.value.status == 21
    assert "0x" not in str(caught.value) and "\n" not in str(caught.value)


def test_an_error_is_heard_where_vtk_was_told_to_be_silent():
    vtkObject.GlobalWarningDisplayOff()
    try:
        with pytest.raises(sb.SurfaceBooleansError):
            sb.boolean(vtk(BOX), None, "difference")
        assert vtkObject.GetGlobalWarningDisplay() == 0
    finally:
        vtkObject.GlobalWarningDisplayOn()


def test_nothing_of_an_error_goes_to_the_terminal(capfd):
    with pytest.raises(sb.SurfaceBooleansError):
        sb.boolean(vtk(BOX), None, "difference")
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("wrong", [3, "box.stl", None, np.zeros((3, 2)), (np.zeros((3, 2)), np.zeros((1, 3), int))])
def test_what_is_no_mesh_is_a_type_error(wrong):
    with pytest.raises(TypeError, match="mesh is|shape"):
        sb.boolean([wrong], vtk(BOX))


def test_an_unknown_operation_is_told_with_those_there_are():
    with pytest.raises(
        ValueError, match="'minus'; there are: union, intersection, difference, symmetric difference, resolve"
    ):
        sb.boolean(vtk(BOX), vtk(OTHER), "minus")


def test_bad_indices_are_the_filters_error():
    with pytest.raises(sb.SurfaceBooleansError) as caught:
        sb.boolean((BOX.points, np.array([[0, 1, 99]])), vtk(OTHER))
    assert caught.value.status == 7


def test_a_warning_points_at_the_line_that_called():
    opened = meshes.mesh(BOX.points, BOX.triangles[:-1])
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        sb.boolean(vtk(OTHER), vtk(opened))
    assert [w.category for w in caught] == [sb.SurfaceBooleansWarning] * len(caught) != []
    assert "not closed" in str(caught[0].message) and os.path.basename(caught[0].filename) == "test_recipes.py"


def test_warnings_can_be_made_errors():
    with warnings.catch_warnings():
        warnings.simplefilter("error", sb.SurfaceBooleansWarning)
        with pytest.raises(sb.SurfaceBooleansWarning):
            sb.boolean(vtk(BOX), vtkPolyData())


# ---- curves and distances ----------------------------------------------------------------------


def test_intersection_gives_the_curve():
    curves = sb.intersection(vtk(BOX), vtk(OTHER))
    assert cells(curves, "Length").tolist() == [pytest.approx(6)] and cells(curves, "Closed").tolist() == [1]


def test_curves_of_arrays_are_arrays():
    (curve,) = sb.intersection((BOX.points, BOX.triangles), (OTHER.points, OTHER.triangles))
    assert curve.shape[1] == 3 and np.array_equal(curve[0], curve[-1])
    assert np.linalg.norm(np.diff(curve, axis=0), axis=1).sum() == pytest.approx(6)
    assert sb.intersection((BOX.points, BOX.triangles), (FAR.points, FAR.triangles)) == []


def test_a_surface_meets_itself():
    both = meshes.joined(BOX, OTHER)
    assert cells(sb.intersection(vtk(both)), "Length").sum() == pytest.approx(6)


def test_split_takes_nothing_away():
    first, second = sb.split(vtk(BOX), vtk(OTHER))
    assert volume(first) == volume(second) == pytest.approx(8)
    assert set(cells(first, "PatchId")) == set(cells(second, "PatchId")) == {0, 1}


def test_distances_of_an_array_are_an_array():
    found = sb.distance(np.array([[1.0, 1, 1], [1, 1, 2], [1, 1, 5]]), vtk(BOX))
    assert found.tolist() == [-1, 0, 3]
    assert sb.distance(np.array([[1.0, 1, 1]]), vtk(BOX), signed=False).tolist() == [1]
    assert sb.distance(np.array([[1.0, 1, 1]]), vtk(BOX), negate=True, sign="winding number").tolist() == [1]


def test_distances_of_any_data_set():
    grid = vtkImageData()
    grid.SetDimensions(5, 5, 5)
    measured = sb.distance(grid, vtk(BOX), cells=True, nearest=True)
    assert isinstance(measured, vtkImageData) and sb.fields_of(measured)["DistanceMinimum"] == -1
    assert measured.GetPointData().GetArray("NearestPoint") and measured.GetCellData().GetArray("Distance")


def test_both_ways_give_the_hausdorff_distance():
    first, second = sb.distance(vtk(BOX), vtk(OTHER), second=True)
    assert sb.fields_of(first)["HausdorffDistance"] == pytest.approx(np.sqrt(3))
    assert second.GetPointData().GetArray("Distance").GetNumberOfValues() == len(OTHER.points)


def test_a_distance_needs_polygons():
    with pytest.raises(sb.SurfaceBooleansError) as caught:
        sb.distance(vtk(BOX), clouds.cloud(BOX.points))
    assert caught.value.status == 30


def test_the_field_covers_the_surface():
    image = sb.distance_field(vtk(BOX), spacing=0.5, margin=0.25)
    assert image.GetSpacing() == (0.5, 0.5, 0.5)
    low, high = image.GetScalarRange()
    assert low == -1 and high == pytest.approx(np.linalg.norm([0.5] * 3))
    assert sb.distance_field(vtk(BOX), dimensions=(4, 5, 6)).GetDimensions() == (4, 5, 6)


# ---- checks ------------------------------------------------------------------------------------


def test_a_check_finds_a_missing_triangle():
    body = meshes.icosphere(1)
    marked, defects = sb.check(vtk(body))
    assert sb.fields_of(marked)["Fit"] == 1 and defects.GetNumberOfCells() == 0
    holed = meshes.mesh(body.points, np.delete(body.triangles, 3, 0))
    marked, defects = sb.check(vtk(holed))
    assert sb.fields_of(marked)["Fit"] == 0 and "open" in sb.fields_of(marked)["Verdict"]
    assert defects.GetNumberOfLines() == 3
    assert set(map(tuple, vtk_to_numpy(defects.GetPoints().GetData()))) == set(
        map(tuple, body.points[body.triangles[3]])
    )
    crossing = meshes.joined(body, meshes.moved(body, (0.3, 0.2, 0.1)))
    assert sb.fields_of(sb.check(vtk(crossing))[0])["SelfIntersectionCount"] > 0
    assert sb.fields_of(sb.check(vtk(crossing), self_intersections=False)[0])["SelfIntersectionCount"] == -1


# ---- planes ------------------------------------------------------------------------------------


def vtk_plane(origin, normal):
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    return plane


UP, SIDEWAYS = ((0, 0, 0.5), (0, 0, 1)), ((1, 0, 0), (1, 0, 0))


@pytest.mark.parametrize(
    "planes, expected",
    [
        (UP, 6),
        ([UP], 6),
        ([*UP[0], *UP[1]], 6),
        (vtk_plane(*UP), 6),
        ([UP, SIDEWAYS], 3),
        ([vtk_plane(*UP), SIDEWAYS], 3),
        (np.array([[*UP[0], *UP[1]], [*SIDEWAYS[0], *SIDEWAYS[1]]]), 3),
    ],
)
def test_planes_may_be_given_in_many_ways(planes, expected):
    clipped = sb.clip(vtk(BOX), planes)
    assert volume(clipped) == pytest.approx(expected)
    assert cells(clipped, "SourceId").max() == (1 if expected == 6 else 2)


def test_a_box_and_what_is_around_it():
    assert volume(sb.clip(vtk(BOX), box=(0.5, 1, 0.5, 1, -9, 9))) == pytest.approx(0.5)
    assert volume(sb.clip(vtk(BOX), box=(0.5, 1, 0.5, 1, -9, 9), inside_out=True)) == pytest.approx(7.5)


def test_the_outline_comes_too_if_asked_for():
    clipped, outline = sb.clip((BOX.points, BOX.triangles), UP, outline=True)
    assert measures.volume(meshes.mesh(*clipped)) == pytest.approx(6)
    assert sum(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in outline) == pytest.approx(8)


@pytest.mark.parametrize("planes", [[1, 2], "x", [UP, 3], 7])
def test_what_is_no_plane_is_a_type_error(planes):
    with pytest.raises(TypeError):
        sb.clip(vtk(BOX), planes)


def test_a_normal_of_zero_is_a_value_error():
    with pytest.raises(ValueError, match="normal"):
        sb.clip(vtk(BOX), ((0, 0, 0), (0, 0, 0)))
    with pytest.raises(sb.SurfaceBooleansError, match="ormal"):
        sb.cut(vtk(BOX), normal=(0, 0, 0))


def test_cross_sections_and_their_outlines():
    caps = sb.cut(vtk(BOX), offsets=[0.5, 1.5])
    assert measures.area(booleans.triangles_of(caps)[0]) == pytest.approx(8)
    assert set(cells(caps, "Offset")) == {0.5, 1.5}
    outlines = sb.cut(vtk(BOX), (0, 0, 1), outlines=True)
    filled = sb.triangulate_contours(outlines)
    assert outlines.GetNumberOfPolys() == 0 and measures.area(booleans.triangles_of(filled)[0]) == pytest.approx(4)


# ---- points ------------------------------------------------------------------------------------


def test_a_cloud_gives_a_closed_mesh():
    points, normals = clouds.sphere(4000)
    body = meshes.mesh(*sb.point_set_surface((points, normals)))
    assert measures.is_closed(body)
    assert measures.volume(body) == pytest.approx(4 / 3 * np.pi, rel=1e-2)
    finer = sb.point_set_surface(clouds.cloud(points, normals), cell_size=0.04)
    assert finer.GetNumberOfCells() > len(body.triangles)


def test_points_get_normals_and_curvatures():
    points, normals = clouds.sphere(4000, radius=2.0)
    moved = sb.point_set_points((1.001 * points, normals))
    curvature = vtk_to_numpy(moved.GetPointData().GetArray("MeanCurvature"))
    assert moved.GetNumberOfPoints() == 4000 and np.median(curvature) == pytest.approx(0.5, rel=1e-2)
    kept = sb.point_set_points(points, project=False, curvatures=False)
    assert np.array_equal(booleans.points_of(kept), points) and not kept.GetPointData().GetArray("MeanCurvature")


def test_a_plane_cuts_a_cloud():
    points, normals = clouds.sphere(4000)
    curves = sb.point_set_intersection(clouds.cloud(points, normals), ((0, 0, 0.6), (0, 0, 1)))
    assert cells(curves, "Length").tolist() == [pytest.approx(2 * np.pi * 0.8, rel=3e-3)]
    (curve,) = sb.point_set_intersection(points, vtk_plane((0, 0, 0), (0, 0, 1)))
    assert np.linalg.norm(curve, axis=1) == pytest.approx(1, abs=1e-3)
    with pytest.raises(TypeError, match="mesh"):
        sb.point_set_intersection(points, 3)


def test_a_mesh_cuts_a_cloud():
    points, normals = clouds.sphere(4000)
    tool = meshes.box((-2, -2, 0), (2, 2, 2))
    curves = sb.point_set_intersection(clouds.cloud(points, normals), vtk(tool))
    assert cells(curves, "Length").tolist() == [pytest.approx(2 * np.pi, rel=3e-3)] and cells(
        curves, "Closed"
    ).tolist() == [1]
    assert np.abs(booleans.points_of(curves)[:, 2]).max() < 1e-12


@pytest.mark.parametrize(
    "operation, share", [("union", 2.5), ("intersection", 0.5), ("difference", 0.5), ("reverse_difference", 1.5)]
)
def test_the_solid_of_a_cloud_is_combined_with_a_body(operation, share):
    points, normals = clouds.sphere(4000)
    tool = meshes.box((-1.25, -1.25, 0), (1.25, 1.25, (4 / 3 * np.pi / 2 + 4 / 3 * np.pi * 1.5) / 1.25**2 / 4))
    ball = 4 / 3 * np.pi  # the box holds half of it, and one and a half times as much beside
    surface, rest, seam = sb.point_set_boolean(
        clouds.cloud(points, normals), vtk(tool), operation, points=True, curves=True
    )
    assert volume(surface) == pytest.approx(share * ball, rel=1e-2)
    assert 0 < rest.GetNumberOfPoints() and cells(seam, "Length").sum() == pytest.approx(2 * np.pi, rel=1e-2)
    assert set(cells(surface, "SourceId")) == {0, 1}


def test_too_few_points_are_an_error():
    with pytest.raises(sb.SurfaceBooleansError) as caught:
        sb.point_set_surface(np.zeros((3, 3)))
    assert caught.value.status == 30


# ---- measures ----------------------------------------------------------------------------------


def test_a_mesh_is_measured_as_the_referee_does():
    body = meshes.bumpy_sphere(np.random.default_rng(7))
    measured = sb.measure(vtk(body))
    assert measured["volume"] == pytest.approx(measures.volume(body), rel=1e-13)
    assert measured["area"] == pytest.approx(measures.area(body), rel=1e-13)
    assert measured["closed"] and measured["polygons"] == len(body.triangles)


def test_concave_polygons_have_their_area():
    arrow = polydata(np.array([[0, 0, 0], [2, 1, 0], [0, 2, 0], [1, 1, 0.0]]), np.array([[0, 1, 2, 3]]))
    assert sb.measure(arrow)["area"] == pytest.approx(1) and not sb.measure(arrow)["closed"]


def test_closed_means_by_coordinates():
    body = meshes.box((0, 0, 0), (1, 1, 1))
    apart = meshes.mesh(body.points[body.triangles.ravel()], np.arange(36).reshape(-1, 3))
    signed_zero = meshes.mesh(np.where(apart.points == 0, -0.0, apart.points), apart.triangles)
    signed_zero.points[:12] = np.abs(signed_zero.points[:12])
    assert sb.measure(vtk(apart))["closed"] and sb.measure(vtk(signed_zero))["closed"]
    for cell in range(12):
        turned = body.triangles.copy()
        turned[cell] = turned[cell, ::-1]
        assert not sb.measure(vtk(meshes.mesh(body.points, turned)))["closed"]
        assert not sb.measure(vtk(meshes.mesh(body.points, np.delete(body.triangles, cell, 0))))["closed"]


# ---- the package -------------------------------------------------------------------------------

RECIPES = [item for name in sb.__all__ if inspect.isfunction(item := getattr(sb, name))]


@pytest.mark.parametrize("recipe", RECIPES, ids=lambda recipe: recipe.__name__)
def test_every_parameter_is_explained(recipe):
    text = inspect.getdoc(recipe)
    assert "Parameters\n----------" in text
    section = text.split("Parameters\n----------")[1].split("\n\n")[0]
    explained = {
        n.strip() for line in section.splitlines() if not line.startswith(" ") for n in line.split(":")[0].split(",")
    }
    assert set(inspect.signature(recipe).parameters) <= explained
    assert any(f"{word}\n{'-' * len(word)}" in text for word in ("Returns", "Raises"))


def test_the_package_needs_numpy_and_vtk_only():
    code = "import sys, surfacebooleans; print(sorted({'pyvista', 'meshio', 'tqdm', 'paraview'} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"
