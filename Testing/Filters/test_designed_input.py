# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Filters compute with the exact surfaces of a designed body, wherever its facets have been moved to."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPolyData

import cad
import clouds
from booleans import heard_from, points_of

cad.needs_cad()

MOVES = {
    "left alone": np.eye(3),
    "turned": np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]]),
    "scaled": 40.0 * np.eye(3),
    "stretched": np.array([[1.0, 0.3, 0.0], [0.0, 2.0, 0.0], [0.0, 0.1, 0.5]]),
    "mirrored": np.diag([-1.0, 1.0, 1.0]),
}


def with_points(data, points):
    copy = vtkPolyData()
    copy.DeepCopy(data)
    copy.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    return copy


def curves_with_a_ball(tool):
    """The curves in which the surface of a cloud, a ball in the middle of the tool, meets the tool."""
    from surfacebooleans.vtk import vtkPointSetIntersectionFilter

    bounds = np.array(tool.GetBounds()).reshape(3, 2)
    points, normals = clouds.sphere(4000, 0.3 * (bounds[2, 1] - bounds[2, 0]))
    section = vtkPointSetIntersectionFilter()
    section.SetInputDataObject(0, clouds.cloud(points + bounds.mean(axis=1), normals))
    section.SetInputDataObject(1, tool)
    errors, warnings = heard_from(section)
    return cad.plain(section.GetOutputDataObject(0), errors, warnings)


@pytest.mark.parametrize("name", MOVES)
def test_curves_lie_on_the_moved_exact_surface(name):
    matrix, shift = MOVES[name], np.array([5.0, -3.0, 100.0])
    first = cad.read(f"{cad.SAMPLES}/step/screw.step")
    tool = with_points(first.data, points_of(first.data) @ matrix.T + shift)
    curves = curves_with_a_ball(tool)
    assert curves.status == 0 and curves.errors == [] and curves.warnings == []
    points, face = points_of(curves.data), curves.point_data["FaceId"]
    # A patch that was mirrored has u and v exchanged, so that its normal still points out.
    uv = curves.point_data["UV"][:, ::-1] if name == "mirrored" else curves.point_data["UV"]
    patches = cad.Patches(first.field_data)
    exact = np.concatenate([patches.points(f, uv[k : k + 1]) for k, f in enumerate(face)]) @ matrix.T + shift
    size = np.linalg.norm(np.ptp(points_of(tool), axis=0))
    assert len(points) > 30
    assert np.linalg.norm(points - exact, axis=1).max() < 1e-13 * size


def test_of_bent_facets_the_facets_are_used_and_a_warning_says_so():
    first = cad.read(f"{cad.SAMPLES}/step/screw.step")
    points = points_of(first.data).copy()
    points[:, 0] += 0.01 * points[:, 2] ** 2
    curves = curves_with_a_ball(with_points(first.data, points))
    assert curves.errors == [] and len(curves.warnings) == 1 and "bend" in curves.warnings[0]
    assert "UV" not in curves.point_data and curves.data.GetNumberOfLines() > 0
