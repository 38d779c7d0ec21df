# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Intersection: sections of clouds with planes, as a filter and as a proxy."""

import numpy as np
import pytest
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkTable

import clouds
from sections import plane_section

OK, BAD_REQUEST, NOT_POINTS, TOO_FEW_POINTS = 0, 10, 20, 30


def test_a_sphere_gives_circles():
    data = clouds.cloud(*clouds.sphere(10000))
    curves = plane_section(data, (0, 0, 0.6), (0, 0, 3), ChordError=1e-4)
    assert curves.status == OK and not curves.errors
    cell, point, x = curves.of_curves, curves.of_points, curves.points
    assert cell["Closed"].tolist() == [1]
    assert cell["Length"] == pytest.approx(2 * np.pi * 0.8, rel=1e-3)
    assert 0 < cell["ChordError"][0] <= 1e-4
    assert np.abs(x[:, 2] - 0.6).max() < 1e-12 and np.hypot(x[:, 0], x[:, 1]) == pytest.approx(0.8, abs=1e-5)
    # 0.8 sin(half the angle of a step) is half of it: about 2 pi / (2 acos(1 - e / r)) steps.
    assert len(x) < 3 * np.pi / np.arccos(1 - 1e-4 / 0.8)
    assert np.median(point["Curvature"]) == pytest.approx(-1.25, rel=0.01)
    assert np.einsum("ij,ij->i", point["Normals"], x).min() > 0.999
    ids = curves.lines[0]
    assert ids[0] == ids[-1] and len(set(ids.tolist())) == len(x)  # closed by its first point
    # Seen from above the inside is on the left.
    turn = np.cross(x[ids[:-1], :2], x[ids[1:], :2]).sum()
    assert turn > 0
    flipped = plane_section(data, (0, 0, 0.6), FlipNormals=True, ChordError=1e-4)
    y, ids = flipped.points, flipped.lines[0]
    assert np.cross(y[ids[:-1], :2], y[ids[1:], :2]).sum() < 0


def test_the_bound_decides_the_number_of_points():
    data = clouds.cloud(*clouds.torus(8000, np.random.default_rng(1)))
    counts = [len(plane_section(data, ChordError=e, Width=0.25).points) for e in (4e-3, 1e-3, 2.5e-4)]
    assert 1.5 < counts[1] / counts[0] < 3 and 1.5 < counts[2] / counts[1] < 3


def test_the_kitten_is_sliced():
    points, normals = clouds.cgal_cloud("kitten.xyz")
    lower, upper = points.min(axis=0), points.max(axis=0)
    bound = 1e-3
    for share in (0.15, 0.3, 0.5, 0.7, 0.9):
        origin = lower + share * (upper - lower)
        curves = plane_section(clouds.cloud(points, normals), origin, (0, 1, 0), ChordError=bound)
        assert curves.status == OK and not curves.errors and curves.lines
        assert curves.of_curves["Closed"].all() and curves.of_curves["ChordError"].max() <= bound
        assert np.abs(curves.points[:, 1] - origin[1]).max() < 1e-12


def test_the_order_of_points_and_threads_do_not_matter():
    rng = np.random.default_rng(2)
    points, normals = clouds.torus(4000, rng)
    order = rng.permutation(4000)
    one = plane_section(clouds.cloud(points, normals), normal=(0.3, 0.1, 1), NumberOfThreads=1)
    other = plane_section(clouds.cloud(points[order], normals[order]), normal=(0.3, 0.1, 1), NumberOfThreads=3)
    assert len(one.points) > 50 and one.bytes() == other.bytes()


def test_a_plane_that_misses_gives_nothing_and_no_error():
    curves = plane_section(clouds.cloud(*clouds.sphere(2000)), (0, 0, 5))
    assert curves.status == OK and not curves.errors and curves.points.size == 0


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
    curves = plane_section(data, **settings)
    assert curves.status == wanted and len(curves.errors) == 1 and word in curves.errors[0]
    assert curves.points.size == 0 and not curves.lines


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
