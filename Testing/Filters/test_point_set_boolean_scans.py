# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Boolean on real scans and CAD files, on open scans, and on input that is bad."""

import pathlib

import numpy as np
import pytest
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

import cad
import cloud_booleans
import clouds
import measures
from booleans import arrays_of, points_of, polydata, triangles_of
from cloud_booleans import DIFFERENCE, INTERSECTION, OPERATIONS, REVERSE_DIFFERENCE, UNION, run
from meshes import mesh

OK, BAD_REQUEST, NOT_POINTS, NOT_A_SURFACE, TOO_FEW_POINTS = 0, 10, 20, 21, 30
INSIDE_OUT, OPEN_TOOL, BAD_TOOL, NO_OVERLAP, OPEN_SCAN, OPEN_SEAM, COINCIDENT = 34, 36, 37, 40, 41, 42, 43
SEAM_NOT_SNAPPED = 44
SCREW = pathlib.Path("/usr/share/opencascade/data/step/screw.step")


# ---- real scans and files ----------------------------------------------------------------------


@pytest.mark.parametrize("operation", OPERATIONS)
def test_a_scanned_mask_and_a_ball(operation):
    """A small scan with a crease within a cell of its mesh, and walls as thin as the width."""
    points, normals = clouds.cgal_cloud("oni.pwn")
    result = run(clouds.cloud(points, normals), cloud_booleans.ball(points.max(axis=0), 0.35, 60), operation)
    assert not result.errors and measures.is_closed(result.body)
    assert result.number("NumberOfFlippedTriangles") == result.number("NumberOfSelfIntersections") == 0


@pytest.mark.parametrize("operation", OPERATIONS)
def test_a_scanned_cat_and_a_ball(operation):
    points, normals = clouds.cgal_cloud("kitten.xyz")
    tool = cloud_booleans.ball([0.1, 0.2, 0.1], 0.35, 60)
    result = run(clouds.cloud(points, normals), tool, operation)
    assert not result.errors and measures.is_closed(result.body)
    assert cloud_booleans.open_edges_by_id(result.surface) == 0
    assert result.number("NumberOfFlippedTriangles") == result.number("NumberOfSelfIntersections") == 0
    # The ball touches the cat's cheek, where a point may have to stay on its chord.
    assert result.number("NumberOfBackedOffPoints") <= 0.05 * result.number("NumberOfSnappedPoints")
    assert result.number("SeamResidual") < result.number("FacetError")
    errors = ("NoiseError", "FacetError", "SeamChordError", "ToolError", "SeamResidual")
    assert result.number("ErrorBudget") == pytest.approx(sum(result.number(name) for name in errors))
    both = run(clouds.cloud(points, normals), tool, INTERSECTION).volume
    a, b = result.number("CloudVolume"), result.number("ToolVolume")
    expected = {UNION: a + b - both, INTERSECTION: both, DIFFERENCE: a - both, REVERSE_DIFFERENCE: b - both}
    assert result.volume == pytest.approx(expected[operation], abs=0.01 * min(a, b))


@pytest.mark.parametrize("height, staying", [(-0.78, 0), (-0.7486, 0), (-0.74, 0), (-0.73, 1), (-0.7286, 1)])
def test_a_scanned_cat_and_a_screw_with_its_exact_faces(height, staying):
    """At the first two heights triangles that are thinner than the way stand in the way of the seam; at the last
    two an edge of the screw touches the cat without crossing it, where a point may have to stay on its chord."""
    modules = pytest.importorskip("surfacebooleans.vtk")
    if not hasattr(modules, "vtkNURBSReader") or not SCREW.exists():
        pytest.skip("built without Open CASCADE, or occt-misc is not installed")
    from vtkmodules.vtkCommonTransforms import vtkTransform
    from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

    reader = modules.vtkNURBSReader()
    reader.SetFileName(str(SCREW))
    place = vtkTransform()
    place.Translate(0.7607, height, -0.0356)
    place.RotateX(-90)
    place.Scale(0.0425, 0.0425, 0.0425)
    moved = vtkTransformPolyDataFilter()
    moved.SetTransform(place)
    moved.SetInputConnection(reader.GetOutputPort())
    moved.SetOutputPointsPrecision(1)
    moved.Update()
    result = run(clouds.cloud(*clouds.cgal_cloud("kitten.xyz")), moved.GetOutput(), UNION)
    assert not result.errors and measures.is_closed(result.body)
    assert result.number("NumberOfBorderEdges") == 0 and result.number("NumberOfBackedOffPoints") <= staying
    assert result.status == OK or staying and result.status == SEAM_NOT_SNAPPED
    assert result.number("SeamResidual") < (0.1 if staying else 1e-9) * result.number("Spacing")
    assert result.number("NumberOfFlippedTriangles") == result.number("NumberOfSelfIntersections") == 0
    face, source = result.cell_data["FaceId"], result.cell_data["SourceId"]
    assert np.array_equal(face >= 0, source == 1)
    uv = result.point_data["UV"]
    assert np.array_equal(np.isfinite(uv[:, 0]), np.isin(np.arange(len(uv)), result.body.triangles[source == 1]))
    # The seam is on the exact faces, on both of them where it crosses an edge.
    off = distances_to_faces(result)
    assert len(off) > 300 and np.mean(off > 1e-7) < 0.02 and off.max() < 0.01
    assert np.all(np.isfinite(arrays_of(result.curves.GetPointData())["UV"]))


def distances_to_faces(result):
    """Of the seam's points on exact faces, from the point of the face at their u and v, in spacings."""
    face, patches = np.full(len(result.body.points), -1), cad.Patches(result.field_data)
    face[result.body.triangles] = result.cell_data["FaceId"][:, None]
    of_seam = (result.point_data["SeamPoint"] == 1) & (face >= 0)
    off = []
    for number in np.unique(face[of_seam]):
        at = of_seam & (face == number)
        there = patches.points(number, result.point_data["UV"][at])
        off.append(np.linalg.norm(there - result.body.points[at], axis=1))
    return np.concatenate(off) / result.number("Spacing")


# ---- open scans --------------------------------------------------------------------------------


def open_ball(count=20000, below=-0.6):
    """A ball that was scanned from above."""
    points, normals = clouds.sphere(count)
    seen = points[:, 2] > below
    return clouds.cloud(points[seen], normals[seen])


@pytest.mark.parametrize("operation", OPERATIONS)
def test_an_open_scan_is_judged_by_its_points(operation):
    """The seam is closed, the scan is open elsewhere; the tool is cut right, and surely."""
    tool = cloud_booleans.ball([0, 0, 1], 0.5, 80)
    result = run(open_ball(), tool, operation)
    assert result.status == OPEN_SCAN and len(result.warnings) == 1
    assert "Confidence" in result.message
    assert result.number("NumberOfSeamEnds") == 0
    assert 0.5 < result.number("Confidence") <= 1
    assert result.cell_data["Confidence"].min() >= result.number("Confidence") - 1e-12
    assert result.number("NumberOfFlippedTriangles") == 0
    scan_outside = operation in (UNION, DIFFERENCE)
    assert (result.number("NumberOfBorderEdges") > 0) == scan_outside
    middles = result.body.points[result.body.triangles].mean(axis=1)
    of_tool = result.cell_data["SourceId"] == 1
    distance = np.linalg.norm(middles[of_tool], axis=1)
    tool_inside = operation in (INTERSECTION, DIFFERENCE)
    assert np.all(distance < 1.001) if tool_inside else np.all(distance > 0.99)
    if not scan_outside:
        assert measures.is_closed(result.body)


def test_where_the_border_of_the_scan_crosses_the_tool_the_seam_ends():
    tool = cloud_booleans.box([0.3, -2, -2], [2, 2, 2])
    result = run(open_ball(), tool, DIFFERENCE)
    assert result.status == OPEN_SEAM and result.number("NumberOfSeamEnds") == 2
    assert "2 ends" in result.message and result.number("NumberOfBorderEdges") > 0
    assert list(arrays_of(result.curves.GetCellData())["Closed"]) == [0]


def test_an_open_scan_inside_out_is_refused():
    points, normals = clouds.sphere(8000)
    seen = points[:, 2] > -0.6
    tool = cloud_booleans.ball([0, 0, 1], 0.5, 40)
    result = run(clouds.cloud(points[seen], -normals[seen]), tool, UNION)
    assert result.status == INSIDE_OUT and len(result.errors) == 1 and result.is_empty
    flipped = run(clouds.cloud(points[seen], -normals[seen]), tool, UNION, FlipNormals=True)
    assert flipped.status == OPEN_SCAN


# ---- bad input ---------------------------------------------------------------------------------


def refused(result, status, *words):
    assert result.status == status, result.message
    assert len(result.errors) == 1 and result.is_empty
    assert result.message in result.errors[0] and result.message.endswith(".")
    return all(word in result.message for word in words)


def test_what_cannot_be_used_is_refused_in_one_sentence():
    cloud, box = cloud_booleans.ball_cloud(2000), cloud_booleans.box([0, -2, -2], [2, 2, 2])
    assert refused(run(None, box), NOT_POINTS, "Input")
    assert refused(run(cloud, None), NOT_A_SURFACE, "Tool")
    assert refused(run(vtkImageData(), box), NOT_POINTS, "vtkImageData")
    assert refused(run(vtkPolyData(), box), TOO_FEW_POINTS, "0 points")
    assert refused(run(cloud, vtkImageData()), NOT_A_SURFACE, "Tool")
    assert refused(run(cloud, cloud), NOT_A_SURFACE, "no polygon")
    assert refused(run(cloud, box, 7), BAD_REQUEST, "7")
    assert refused(run(cloud, box, Width=-1), BAD_REQUEST, "Width")
    assert refused(run(cloud, box, CellSize=np.nan), BAD_REQUEST, "CellSize")
    assert refused(run(cloud, box, CellSize=1e-12), 32, "CellSize")


def test_tools_that_are_no_solid_are_refused():
    cloud = cloud_booleans.ball_cloud(2000)
    closed = triangles_of(cloud_booleans.box([0, -2, -2], [2, 2, 2]))[0]
    assert refused(run(cloud, polydata(mesh(closed.points, closed.triangles[1:]))), OPEN_TOOL, "not closed")
    torn = cloud_booleans.ball([0, 0, 1], 0.5, 20)
    torn.GetPolys().ReverseCellAtId(3)
    assert refused(run(cloud, torn), BAD_TOOL, "oriented against each other")
    bad = cloud_booleans.box([0, -2, -2], [2, 2, 2])
    bad.GetPoints().SetPoint(0, np.nan, 0, 0)
    assert refused(run(cloud, bad), NOT_A_SURFACE, "not a finite number")


def test_normals_that_point_inwards_are_refused_and_can_be_flipped():
    points, normals = clouds.sphere(4000)
    box = cloud_booleans.box([0.3, -2, -2], [2, 2, 2])
    assert refused(run(clouds.cloud(points, -normals), box), INSIDE_OUT, "Flip Normals")
    assert run(clouds.cloud(points, -normals), box, FlipNormals=True).status == OK
    # One of two balls.
    both = np.concatenate([points, points + [4, 0, 0]])
    mixed = clouds.cloud(both, np.concatenate([normals, -normals]))
    assert refused(run(mixed, box), INSIDE_OUT, "Flip Normals")


def test_a_cavity_is_no_part_that_is_inside_out():
    points, normals = clouds.sphere(6000)
    inner, inwards = clouds.sphere(2000, 0.5)
    hollow = clouds.cloud(np.concatenate([points, inner]), np.concatenate([normals, -inwards]))
    result = run(hollow, cloud_booleans.box([0, -2, -2], [2, 2, 2]), DIFFERENCE)
    assert result.status == OK and measures.is_closed(result.body)
    assert result.volume == pytest.approx(2 / 3 * np.pi * (1 - 0.5**3), rel=0.01)
    assert len(arrays_of(result.curves.GetCellData())["Closed"]) == 2


def test_surfaces_that_do_not_meet():
    cloud = cloud_booleans.ball_cloud(2000)
    away = cloud_booleans.box([3, -1, -1], [4, 1, 1])
    union = run(cloud, away, UNION)
    assert union.status == NO_OVERLAP and len(union.warnings) == 1
    assert union.volume == pytest.approx(4 / 3 * np.pi + 4, rel=0.02) and measures.is_closed(union.body)
    nothing = run(cloud, away, INTERSECTION)
    assert nothing.status == NO_OVERLAP and nothing.is_empty
    assert run(cloud, away, DIFFERENCE).volume == pytest.approx(4 / 3 * np.pi, rel=0.02)
    assert run(cloud, away, REVERSE_DIFFERENCE).volume == pytest.approx(4)


def test_a_scan_of_the_tool_itself_is_told():
    result = run(cloud_booleans.ball_cloud(4000), cloud_booleans.ball([0, 0, 0], 1.0, 100), UNION)
    assert not result.errors and measures.is_closed(result.body)
    assert result.status in (COINCIDENT, NO_OVERLAP)
    assert result.volume == pytest.approx(4 / 3 * np.pi, rel=0.01)


def test_points_that_are_not_finite_duplicates_and_outliers_do_no_harm():
    points, normals = clouds.sphere(6000)
    rng = np.random.default_rng(4)
    outliers = rng.uniform(-3, 3, (20, 3))
    dirty = np.concatenate([points, points[:100], [[np.nan, 0, 0], [0, np.inf, 0]], outliers])
    theirs = np.concatenate([normals, normals[:100], np.tile([0.0, 0, 1], (22, 1))])
    box = cloud_booleans.box([0.3, -2, -2], [2, 2, 2])
    result = run(clouds.cloud(dirty, theirs), box, DIFFERENCE)
    clean = run(clouds.cloud(points, normals), box, DIFFERENCE)
    assert result.status in (OK, OPEN_SCAN) and not result.errors
    assert np.all(np.isfinite(points_of(result.surface)))
    assert result.number("ResultVolume") == pytest.approx(clean.number("ResultVolume"), rel=0.01)


def test_stopping_leaves_empty_outputs():
    from surfacebooleans.vtk import vtkPointSetBooleanFilter

    tested = vtkPointSetBooleanFilter()
    tested.SetInputDataObject(0, cloud_booleans.ball_cloud(20000))
    tested.SetInputDataObject(1, cloud_booleans.box([0.3, -2, -2], [2, 2, 2]))
    tested.AddObserver("ProgressEvent", lambda *_: tested.SetAbortExecuteAndUpdateTime())
    result = cloud_booleans.update(tested)
    assert result.status == 9 and result.is_empty and not result.errors
