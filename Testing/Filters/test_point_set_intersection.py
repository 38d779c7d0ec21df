# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Intersection: sections of clouds with planes, as a filter and as a proxy."""

import numpy as np
import pytest
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkTable

import clouds
from booleans import arrays_of, cells_of, heard_from, points_of

OK, BAD_REQUEST, NOT_POINTS, TOO_FEW_POINTS = 0, 10, 20, 30


def section(data, origin=(0, 0, 0), normal=(0, 0, 1), **settings):
    """The output, and the error messages."""
    from surfacebooleans.vtk import vtkPointSetIntersectionFilter

    tested = vtkPointSetIntersectionFilter()
    if normal is not None:
        plane = vtkPlane()
        plane.SetOrigin(origin)
        plane.SetNormal(normal)
        tested.SetPlane(plane)
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    if data is not None:
        tested.SetInputDataObject(0, data)
    errors, _ = heard_from(tested)
    return tested.GetOutput(), errors


def status(curves):
    return int(vtk_to_numpy(curves.GetFieldData().GetArray("Status"))[0])


def test_a_sphere_gives_circles():
    data = clouds.cloud(*clouds.sphere(10000))
    curves, errors = section(data, (0, 0, 0.6), (0, 0, 3), ChordError=1e-4)
    assert status(curves) == OK and not errors
    cell, point, x = arrays_of(curves.GetCellData()), arrays_of(curves.GetPointData()), points_of(curves)
    assert cell["Closed"].tolist() == [1]
    assert cell["Length"] == pytest.approx(2 * np.pi * 0.8, rel=1e-3)
    assert 0 < cell["ChordError"][0] <= 1e-4
    assert np.abs(x[:, 2] - 0.6).max() < 1e-12 and np.hypot(x[:, 0], x[:, 1]) == pytest.approx(0.8, abs=1e-5)
    # 0.8 sin(half the angle of a step) is half of it: about 2 pi / (2 acos(1 - e / r)) steps.
    assert len(x) < 3 * np.pi / np.arccos(1 - 1e-4 / 0.8)
    assert np.median(point["Curvature"]) == pytest.approx(-1.25, rel=0.01)
    assert np.einsum("ij,ij->i", point["Normals"], x).min() > 0.999
    _, ids = cells_of(curves.GetLines())
    assert ids[0] == ids[-1] and len(set(ids.tolist())) == len(x)  # closed by its first point
    # Seen from above the inside is on the left.
    turn = np.cross(x[ids[:-1], :2], x[ids[1:], :2]).sum()
    assert turn > 0
    flipped, _ = section(data, (0, 0, 0.6), FlipNormals=True, ChordError=1e-4)
    _, ids = cells_of(flipped.GetLines())
    y = points_of(flipped)
    assert np.cross(y[ids[:-1], :2], y[ids[1:], :2]).sum() < 0


def test_the_bound_decides_the_number_of_points():
    data = clouds.cloud(*clouds.torus(8000, np.random.default_rng(1)))
    counts = [section(data, ChordError=e, Width=0.25)[0].GetNumberOfPoints() for e in (4e-3, 1e-3, 2.5e-4)]
    assert 1.5 < counts[1] / counts[0] < 3 and 1.5 < counts[2] / counts[1] < 3


def test_the_kitten_is_sliced():
    points, normals = clouds.cgal_cloud("kitten.xyz")
    lower, upper = points.min(axis=0), points.max(axis=0)
    bound = 1e-3
    for share in (0.15, 0.3, 0.5, 0.7, 0.9):
        origin = lower + share * (upper - lower)
        curves, errors = section(clouds.cloud(points, normals), origin, (0, 1, 0), ChordError=bound)
        arrays = arrays_of(curves.GetCellData())
        assert status(curves) == OK and not errors and curves.GetNumberOfLines() > 0
        assert arrays["Closed"].all() and arrays["ChordError"].max() <= bound
        assert np.abs(points_of(curves)[:, 1] - origin[1]).max() < 1e-12


def test_the_order_of_points_and_threads_do_not_matter():
    rng = np.random.default_rng(2)
    points, normals = clouds.torus(4000, rng)
    order = rng.permutation(4000)
    one, _ = section(clouds.cloud(points, normals), normal=(0.3, 0.1, 1), NumberOfThreads=1)
    other, _ = section(clouds.cloud(points[order], normals[order]), normal=(0.3, 0.1, 1), NumberOfThreads=3)
    assert one.GetNumberOfPoints() > 50
    assert np.array_equal(points_of(one), points_of(other))
    assert all(np.array_equal(a, b) for a, b in zip(cells_of(one.GetLines()), cells_of(other.GetLines())))


def test_a_plane_that_misses_gives_nothing_and_no_error():
    curves, errors = section(clouds.cloud(*clouds.sphere(2000)), (0, 0, 5))
    assert status(curves) == OK and not errors and curves.GetNumberOfPoints() == 0


@pytest.mark.parametrize(
    "data, settings, wanted, word",
    [
        (None, {}, NOT_POINTS, "no data"),
        (vtkTable(), {}, NOT_POINTS, "Table To Points"),
        (clouds.cloud(np.eye(3)), {}, TOO_FEW_POINTS, "six"),
        (clouds.cloud(*clouds.sphere(100)), {"ChordError": -1.0}, BAD_REQUEST, "ChordError"),
        (clouds.cloud(*clouds.sphere(100)), {"Width": np.inf}, BAD_REQUEST, "Width"),
        (clouds.cloud(*clouds.sphere(100)), {"normal": None}, BAD_REQUEST, "Plane"),
        (clouds.cloud(*clouds.sphere(100)), {"normal": (0, 0, 0)}, BAD_REQUEST, "length zero"),
        (clouds.cloud(*clouds.sphere(100)), {"origin": (np.nan, 0, 0)}, BAD_REQUEST, "finite"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(data, settings, wanted, word):
    curves, errors = section(data, **settings)
    assert status(curves) == wanted and len(errors) == 1 and word in errors[0]
    assert curves.GetNumberOfPoints() == 0 and curves.GetNumberOfCells() == 0


def test_the_proxy_has_a_plane_to_move():
    simple.ResetSession()
    ball = simple.Sphere(ThetaResolution=60, PhiResolution=60, Radius=1)
    proxy = simple.PointSetIntersection(Input=ball)
    wanted = {"Input", "Tool", "Plane", "ChordError", "Definition", "Width", "FlipNormals", "NumberOfThreads"}
    assert set(proxy.ListProperties()) == wanted | {"HasTool"}  # by which the panel hides the plane
    for name in wanted:
        assert len(proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription().strip()) > 40, name
    proxy.Plane.Origin = [0, 0, 0.6]
    proxy.Plane.Normal = [0, 0, 1]
    proxy.UpdatePipeline()
    assert proxy.CellData["Length"].GetRange()[0] == pytest.approx(2 * np.pi * 0.8, rel=0.02)
    proxy.Plane.Origin = [0, 0, 0]
    proxy.UpdatePipeline()
    assert proxy.CellData["Length"].GetRange()[0] == pytest.approx(2 * np.pi, rel=0.02)
    assert proxy.GetHints().FindNestedElementByName("ShowInMenu").GetAttribute("category") == "Surface Booleans"
