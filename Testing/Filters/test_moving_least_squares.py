# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The implicit function of a cloud, as any user of vtkImplicitFunction has it."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersCore import vtkCutter
from vtkmodules.vtkImagingHybrid import vtkSampleFunction

import clouds
import meshes
from booleans import points_of, polydata
from clouds import implicit

DEFINED, FAR, BORDER, CONTRADICTING = 0, 1, 2, 3


@pytest.fixture(params=[0, 1], ids=["Unbiased", "AmentaKil"])
def definition(request):
    return request.param


def hessian(surface, x):
    values = np.zeros(9)
    surface.EvaluateHessian(x, values)
    return values.reshape(3, 3)


def gradient(surface, x):
    values = [0.0] * 3
    surface.EvaluateGradient(list(x), values)
    return np.array(values)


def test_gradient_and_hessian_are_those_of_differences(definition):
    rng = np.random.default_rng(1)
    points, normals = clouds.torus(3000, rng)
    # The paper's Gaussian is cut at 4.5 widths; all points within that, its step is not in the differences.
    width = (0.25, 0.7)[definition]
    surface = implicit(points + 0.005 * rng.normal(size=points.shape), normals, Definition=definition, Width=width)
    for k in range(0, 3000, 300):
        x = points[k] + 0.03 * rng.normal(size=3)
        steps = 1e-4 * np.eye(3)
        slope = [(surface.EvaluateFunction(x + e) - surface.EvaluateFunction(x - e)) / 2e-4 for e in steps]
        assert np.abs(slope - gradient(surface, x)).max() < 1e-6
        bend = [(gradient(surface, x + e) - gradient(surface, x - e)) / 2e-4 for e in steps]
        found = hessian(surface, x)
        assert np.abs(bend - found).max() < 1e-5 * (1 + np.abs(found).max())
        assert np.abs(found - found.T).max() < 1e-12 * (1 + np.abs(found).max())


def test_inside_is_negative_and_far_points_get_the_distance(definition):
    surface = implicit(*clouds.sphere(3000), Definition=definition)
    for reach in (0.0, 0.5, 0.9, 0.96, 1.01, 1.1, 2.0, 1e6):
        x = reach * np.array([0.48, -0.6, 0.64])
        value = surface.EvaluateFunction(x)
        assert np.sign(value) == np.sign(reach - 1)
        bias = surface.GetActualWidth() ** 2 if definition else 1e-3
        # Across the band it is nearly, beyond it exactly the distance to a sample.
        assert value == pytest.approx(reach - 1, rel=0.25, abs=bias)
        assert np.dot(gradient(surface, x), x) > 0 or reach == 0
    assert not surface.IsDefined([0, 0, 0]) and surface.GetValidity([0, 0, 0]) == FAR
    assert surface.IsDefined([1, 0, 0])
    assert surface.GetValidity([np.nan, 0, 0]) == FAR


def test_without_a_cloud_there_is_no_value():
    from surfacebooleans.vtk import vtkMovingLeastSquaresSurface

    surface = vtkMovingLeastSquaresSurface()
    surface.SetNoValue(7.0)
    assert surface.EvaluateFunction([0, 0, 0]) == 7.0
    assert np.array_equal(gradient(surface, [0, 0, 0]), [0, 0, 1])
    assert not surface.Project([0, 0, 0], [0.0] * 3)
    assert surface.IntersectWithLine([0, 0, 0], [1, 0, 0], vtkPoints()) == 0
    assert surface.GetSpacing() == 0
    surface.SetInput(clouds.cloud(*clouds.sphere(3000)))
    assert surface.EvaluateFunction([0, 0, 0]) < -0.9
    assert surface.EvaluateFunction([np.inf, 0, 0]) == 7.0


def test_projected_points_are_roots(definition):
    rng = np.random.default_rng(2)
    points, normals = clouds.torus(6000, rng)
    surface = implicit(points, normals, Definition=definition)
    width = surface.GetActualWidth()
    for k in range(0, 6000, 200):
        x = points[k] + rng.uniform(-0.5, 0.5) * width * normals[k]
        found = [0.0] * 3
        assert surface.Project(x, found)
        assert abs(surface.EvaluateFunction(found)) < 1e-9 * width
    found = [0.0] * 3
    assert not surface.Project([5, 5, 5], found) and found == [5, 5, 5]


def test_all_points_of_a_line_are_found(definition):
    surface = implicit(*clouds.torus(8000, np.random.default_rng(3)), Definition=definition)
    found = vtkPoints()
    assert surface.IntersectWithLine([-3, 0.1, 0], [3, 0.1, 0], found) == 4
    x = vtk_to_numpy(found.GetData())
    assert (np.diff(x[:, 0]) > 0).all()
    bias = surface.GetActualWidth() ** 2 if definition else 0.0
    assert np.abs(clouds.distance_to_torus(x)).max() < 0.1 * surface.GetSpacing() + bias
    assert max(abs(surface.EvaluateFunction(p)) for p in x) < 1e-12
    assert surface.IntersectWithLine([-3, 0, 1], [3, 0, 1], None) == 0
    assert surface.IntersectWithLine([0, 0, 0], [0, 0, 0], None) == 0


def test_a_section_bends_as_its_circle_does():
    surface = implicit(*clouds.sphere(20000))
    # At height 0.6 the sphere's section is a circle of radius 0.8; it bends away from the gradient.
    assert surface.EvaluateSectionCurvature([0.8, 0, 0.6], [0, 0, 2.0]) == pytest.approx(-1.25, rel=0.01)
    assert surface.EvaluateSectionCurvature([0.8, 0, 0.6], [0, 0, 0]) == 0
    principal = [0.0, 0.0]
    surface.EvaluatePrincipalCurvatures([0.8, 0, 0.6], principal)
    assert principal == pytest.approx([1, 1], rel=0.01)


def test_it_follows_its_input_and_settings():
    data = clouds.cloud(*clouds.sphere(2000))
    from surfacebooleans.vtk import vtkMovingLeastSquaresSurface

    surface = vtkMovingLeastSquaresSurface()
    surface.SetInput(data)
    assert surface.EvaluateFunction([1.1, 0, 0]) == pytest.approx(0.1, abs=0.01)
    surface.FlipNormalsOn()
    assert surface.EvaluateFunction([1.1, 0, 0]) == pytest.approx(-0.1, abs=0.01)
    data.SetPoints(clouds.cloud(2 * clouds.sphere(2000)[0]).GetPoints())
    assert surface.EvaluateFunction([2.1, 0, 0]) == pytest.approx(-0.1, abs=0.01)


def test_vtks_own_filters_use_it():
    surface = implicit(*clouds.sphere(3000))
    sample = vtkSampleFunction()
    sample.SetImplicitFunction(surface)
    sample.SetModelBounds(-1.5, 1.5, -1.5, 1.5, -1.5, 1.5)
    sample.SetSampleDimensions(20, 20, 20)
    sample.Update()
    grid = sample.GetOutput()
    values = vtk_to_numpy(grid.GetPointData().GetScalars())
    places = np.linalg.norm([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())], axis=1)
    assert np.array_equal(values < 0, places < 1)
    cutter = vtkCutter()
    cutter.SetCutFunction(surface)
    cutter.SetInputData(polydata(meshes.moved(meshes.icosphere(4), (0.5, 0, 0))))
    cutter.Update()
    assert np.linalg.norm(points_of(cutter.GetOutput()), axis=1) == pytest.approx(1, abs=0.01)
    assert cutter.GetOutput().GetNumberOfLines() > 0
