# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What vtkPolyDataDistance and vtkImplicitPolyData promise: the interface of the paper's sections 3.1 and 3.2, values
that are known, and signs that are right."""

import numpy as np
import pytest
from vtkmodules.vtkFiltersSources import vtkCubeSource

import meshes
from booleans import polydata
from distances import arrays, cloud, distances, implicit
from surfacebooleans.vtk import vtkImplicitPolyData, vtkPolyDataDistance

CUBE = meshes.cube(2.0)


def cube_with_split_normals(side=2.0):
    """VTK's own cube: 24 points, three at each corner."""
    source = vtkCubeSource()
    source.SetXLength(side), source.SetYLength(side), source.SetZLength(side)
    source.Update()
    return source.GetOutput()


def distance_to_cube(points, half=1.0):
    """Signed, in closed form."""
    beyond = np.abs(points) - half
    outside = np.linalg.norm(np.maximum(beyond, 0), axis=1)
    return np.where(outside > 0, outside, beyond.max(axis=1))


# ---- section 3.1: vtkImplicitPolyData ------------------------------------------------------------


def test_the_implicit_function_is_the_signed_distance():
    points = np.random.default_rng(1).uniform(-2, 2, (2000, 3))
    function = implicit(CUBE)
    found = np.array([function.EvaluateFunction(p) for p in points])
    assert np.abs(found - distance_to_cube(points)).max() < 4e-16


def test_its_gradient_is_the_pseudonormal_of_face_edge_and_vertex():
    for surface in (polydata(CUBE), cube_with_split_normals()):
        function = implicit(surface)
        for place, wanted in (((3, 0.2, 0.1), (1, 0, 0)), ((3, 3, 0.1), (1, 1, 0)), ((3, -3, 3), (1, -1, 1))):
            gradient = [0.0, 0.0, 0.0]
            function.EvaluateGradient(place, gradient)
            assert gradient == pytest.approx(np.array(wanted) / np.linalg.norm(wanted), abs=1e-15)


def test_without_a_surface_it_has_no_value_and_no_gradient():
    function = vtkImplicitPolyData()
    assert function.GetNoValue() == 0.0 and function.GetTolerance() == 0.0
    function.SetNoValue(7.0)
    function.SetNoGradient((3.0, 4.0, 5.0))
    gradient = [0.0, 0.0, 0.0]
    function.EvaluateGradient((1, 2, 3), gradient)
    assert function.EvaluateFunction((1, 2, 3)) == 7.0
    assert gradient == [3.0, 4.0, 5.0]


def test_within_the_tolerance_the_distance_is_zero():
    function = implicit(CUBE)
    function.SetTolerance(0.25)
    values = [function.EvaluateFunction((x, 0, 0)) for x in (0.7, 0.75, 1.0, 1.25, 1.3)]
    assert values == pytest.approx([-0.3, 0, 0, 0, 0.3], abs=1e-15)


# ---- section 3.2: vtkPolyDataDistance ------------------------------------------------------------


def test_the_defaults_are_those_of_the_source_document():
    tested = vtkPolyDataDistance()
    assert tested.GetSignedDistance() == 1
    assert tested.GetNegateDistance() == 0
    assert tested.GetComputeSecondDistance() == 0
    for name in ("SignedDistance", "NegateDistance", "ComputeSecondDistance"):
        getattr(tested, name + "Off")()
        assert getattr(tested, "Get" + name)() == 0
        getattr(tested, name + "On")()
        assert getattr(tested, "Get" + name)() == 1


def test_the_array_distance_is_signed_unsigned_or_negated():
    points = np.random.default_rng(2).uniform(-2, 2, (5000, 3))
    wanted = distance_to_cube(points)
    for settings, expected in (
        ({}, wanted),
        ({"SignedDistance": 0}, np.abs(wanted)),
        ({"NegateDistance": 1}, -wanted),
        ({"NegateDistance": 1, "SignedDistance": 0}, np.abs(wanted)),
        ({"SignMethod": 1}, wanted),
    ):
        assert np.abs(distances(cloud(points), CUBE, **settings) - expected).max() < 4e-16


def test_the_second_output_has_the_distances_of_the_tool():
    small, large = meshes.cube(1.0), meshes.cube(4.0)
    tested = vtkPolyDataDistance()
    tested.SetInputData(polydata(small))
    tested.SetToolData(polydata(large))
    tested.Update()
    assert "Distance" not in arrays(tested.GetSecondDistanceOutput().GetPointData())
    tested.ComputeSecondDistanceOn()
    tested.Update()
    assert arrays(tested.GetOutput().GetPointData())["Distance"] == pytest.approx([-1.5] * 8)
    second = arrays(tested.GetSecondDistanceOutput().GetPointData())["Distance"]
    assert second == pytest.approx([np.sqrt(3) * 1.5] * 8)
    fields = arrays(tested.GetOutput().GetFieldData())
    assert fields["HausdorffDistance"] == pytest.approx(np.sqrt(3) * 1.5)
    assert fields["HausdorffInputToTool"] == pytest.approx(1.5)


@pytest.mark.parametrize("name", ["elephant", "blobby"])
def test_both_sign_methods_agree_on_a_closed_mesh(name):
    body = meshes.cgal_mesh(name)
    points = cloud(np.random.default_rng(3).uniform(-1, 1, (20000, 3)))
    assert np.array_equal(distances(points, body), distances(points, body, SignMethod=1))
