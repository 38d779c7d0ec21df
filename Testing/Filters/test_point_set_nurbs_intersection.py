# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Intersection with exact surfaces: every point on both, with its parameters."""

import numpy as np
import pytest
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

import cad
import clouds
import patches
from booleans import arrays_of, points_of
from sections import curves_of, values_at

OK, FACETS_ONLY, TOOL_BORDER = 0, 5, 1


def check_on_both(result, data, faces, size=2.0):
    """Each point is where its parameters say, evaluated here, and on the cloud's surface."""
    assert result.status == OK and not result.errors and not result.warnings
    uv, face = result.of_points["UV"], result.of_points["FaceId"]
    assert len(uv) == len(result.points) > 0 and "OriginalCellId" not in result.of_points
    for number, patch in enumerate(faces):
        mine = face == number
        if mine.any():
            exact = patch(uv[mine, 0], uv[mine, 1])
            assert np.abs(exact - result.points[mine]).max() <= 1e-12 * size
    assert np.isin(face, np.arange(len(faces))).all()
    assert np.abs(values_at(data, result.points)).max() <= 1e-12 * size


def test_two_spheres_meet_in_a_circle():
    """About x, off the seam and the poles of the patch, and across them."""
    points, normals = clouds.sphere(10000)
    faces = [patches.sphere(0.7)]
    height = (1.44 + 1 - 0.49) / 2.4  # of the circle's plane in the cloud, whose centre is 1.2 away
    radius = np.sqrt(1 - height * height)
    for away in ((0, 1.2, 0), (-1.2, 0, 0), (0, 0, 1.2)):
        data = clouds.cloud(points + away, normals)
        for across in ((24, 12), (8, 4)):  # facets say where the patch is, not what is cut
            result = curves_of(data, patches.body(faces, across), ChordError=1e-4)
            check_on_both(result, data, faces)
            assert result.of_curves["Closed"].tolist() == [1], (away, across)
            assert result.of_curves["Length"][0] == pytest.approx(2 * np.pi * radius, rel=1e-3)
            assert result.of_curves["ChordError"][0] <= 1e-4
            assert np.median(result.of_points["Curvature"]) == pytest.approx(-1 / radius, rel=0.05)


def test_a_drum_is_cut_across_its_faces():
    """A ball over the rim of a drum: one loop over wall and lid, joined across their edge."""
    points, normals = clouds.sphere(20000)
    faces = [patches.wall(1.0, -1.0, 1.0), patches.disc(1.0, 1.0, True), patches.disc(1.0, -1.0, False)]
    drum = patches.body(faces)
    centre = np.array([0.2, 0.9, 1.1])
    data = clouds.cloud(0.6 * points + centre, normals)
    result = curves_of(data, drum, ChordError=1e-4)
    check_on_both(result, data, faces)
    assert result.of_curves["Closed"].tolist() == [1]
    assert set(result.of_points["FaceId"].tolist()) == {0, 1}
    line = result.points[result.lines[0]]
    assert np.linalg.norm(np.diff(line, axis=0), axis=1).max() < 0.2  # no leap at an edge
    # The arc on the lid, of a circle in the plane z = 1, and that on the wall, sampled.
    t = np.linspace(0, 2 * np.pi, 200001)
    r = np.sqrt(0.36 - 0.01)
    on_lid = np.hypot(centre[0] + r * np.cos(t), centre[1] + r * np.sin(t)) < 1
    lid = on_lid.mean() * 2 * np.pi * r
    a = np.linspace(0, 2 * np.pi, 400001)
    flat = 0.36 - (np.cos(a) - centre[0]) ** 2 - (np.sin(a) - centre[1]) ** 2
    below = centre[2] - np.sqrt(np.where(flat > 0, flat, np.nan))
    wall = np.stack([np.cos(a), np.sin(a), below], 1)[below < 1]
    steps = np.linalg.norm(np.diff(wall, axis=0), axis=1)
    assert result.of_curves["Length"][0] == pytest.approx(lid + steps[steps < 0.01].sum(), rel=2e-3)


def test_an_open_patch_has_ends():
    points, normals = clouds.sphere(10000)
    faces = [patches.wall(0.5, 0.0, 0.8)]  # ends inside of the cloud's surface
    data = clouds.cloud(points + [0.5, 0, 0.6], normals)
    result = curves_of(data, patches.body(faces), ChordError=1e-4)
    check_on_both(result, data, faces)
    assert (result.of_curves["Closed"] == 0).any()
    opened = result.of_curves["Ends"][result.of_curves["Closed"] == 0]
    assert set(opened.ravel().tolist()) == {TOOL_BORDER}
    for line, closed in zip(result.lines, result.of_curves["Closed"]):
        if not closed:
            ends = result.points[line[[0, -1]], 2]
            assert (np.minimum(np.abs(ends), np.abs(ends - 0.8)) < 1e-9).all()


def test_tori_of_a_cloud_and_of_a_patch():
    rng = np.random.default_rng(4)
    points, normals = clouds.torus(30000, rng)
    data = clouds.cloud(points, normals)
    faces = [patches.torus(1.0, 0.3)]
    tool = patches.body(faces, (48, 24))
    inside = curves_of(data, tool)  # does not reach the other one
    assert inside.status == OK and not inside.lines
    turn = vtkTransform()
    turn.Translate(0.5, 0.1, 0.0)
    turn.RotateX(90.0)
    moved = vtkTransformPolyDataFilter()
    moved.SetTransform(turn)
    moved.SetInputData(tool)
    moved.Update()
    result = curves_of(data, moved.GetOutput(), ChordError=1e-3)
    matrix = np.array([[turn.GetMatrix().GetElement(i, j) for j in range(4)] for i in range(3)])
    poles = faces[0].poles.copy()
    poles[..., :3] = poles[..., :3] @ matrix[:, :3].T + matrix[:, 3]
    # Patches follow their facets; the map is found again from these, which are rounded.
    uv = result.of_points["UV"]
    exact = patches.Patch(faces[0].degrees, faces[0].knots, poles)(uv[:, 0], uv[:, 1])
    assert result.status == OK and np.abs(exact - result.points).max() < 1e-11
    assert np.abs(clouds.distance_to_torus(result.points)).max() < 2e-3
    assert result.of_curves["Closed"].all() and len(result.lines) == 2


def test_the_order_of_points_and_threads_do_not_matter():
    rng = np.random.default_rng(5)
    points, normals = clouds.torus(6000, rng)
    order = rng.permutation(6000)
    tool = patches.body([patches.sphere(1.05)])
    one = curves_of(clouds.cloud(points, normals), tool, NumberOfThreads=1)
    other = curves_of(clouds.cloud(points[order], normals[order]), tool, NumberOfThreads=3)
    assert len(one.points) > 50 and one.bytes() == other.bytes()


def test_a_bent_body_is_cut_by_its_facets_with_a_warning():
    tool = patches.body([patches.sphere(0.7)])
    for i in range(tool.GetNumberOfPoints()):
        x, y, z = tool.GetPoint(i)
        tool.GetPoints().SetPoint(i, x + 0.3 * z * z, y, z)
    points, normals = clouds.sphere(10000)
    result = curves_of(clouds.cloud(points + [0, 1.2, 0], normals), tool)
    assert result.status == FACETS_ONLY and len(result.warnings) == 1 and not result.errors
    assert result.warnings[0].count("facets") and "UV" not in result.of_points
    assert result.of_curves["Closed"].tolist() == [1]


def test_a_patch_that_cannot_be_used_is_told():
    tool = patches.body([patches.sphere(0.7)])
    array = tool.GetFieldData().GetArray("NURBSPoles")
    array.SetComponent(3, 3, -1.0)
    points, normals = clouds.sphere(4000)
    result = curves_of(clouds.cloud(points + [0, 1.2, 0], normals), tool)
    assert result.status == FACETS_ONLY and len(result.warnings) == 1 and not result.errors
    assert len(result.lines) == 1 and arrays_of(result.data.GetPointData()).keys() >= {"OriginalCellId"}


@pytest.mark.parametrize("name, share", [("step/screw.step", 1.1), ("step/linkrods.step", 0.9)])
def test_a_real_scan_and_a_real_cad_file(name, share):
    """The kitten, made as large as the body and turned through it: all loops, on both."""
    cad.needs_cad()
    body = cad.read(f"{cad.SAMPLES}/{name}")
    points, normals = clouds.cgal_cloud("kitten.xyz")
    corners = points_of(body.data)
    low, high = corners.min(axis=0), corners.max(axis=0)
    size = np.linalg.norm(high - low)
    points = points * share * size / np.linalg.norm(points.max(axis=0) - points.min(axis=0)) + (low + high) / 2
    data = clouds.cloud(points, normals)
    result = curves_of(data, body.data)
    assert result.status == OK and not result.errors and not result.warnings
    assert len(result.lines) > 0 and result.of_curves["Closed"].all()
    assert result.of_curves["ChordError"].max() <= 0.1 * result.number("Spacing")
    exact = cad.Patches(body.field_data)
    for face in np.unique(result.of_points["FaceId"]):
        mine = result.of_points["FaceId"] == face
        assert np.abs(exact.points(face, result.of_points["UV"][mine]) - result.points[mine]).max() <= 1e-12 * size
    assert np.abs(values_at(data, result.points)).max() <= 1e-12 * size
