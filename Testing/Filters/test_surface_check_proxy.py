# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""How paraview.simple knows the check, and that what its verdict recommends does cure the surface."""

import numpy as np
import pytest
import surfacebooleans.vtk  # noqa: F401  (before the first proxy, so that its objects have our methods)
from paraview import simple

import meshes
import states
from booleans import polydata
from meshes import box, inside_out, joined, mesh, moved, scaled

BALL = meshes.icosphere(3)
PROPERTIES = {"Input": None, "SelfIntersections": 1, "NumberOfThreads": 0}


@pytest.fixture(autouse=True)
def session():
    simple.ResetSession()


def source(body):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(polydata(body))
    producer.UpdatePipeline()
    return producer


def field(proxy, name):
    proxy.UpdatePipeline()
    return int(proxy.FieldData[name].GetRange()[0])


def verdict(checked):
    checked.UpdatePipeline()
    data = checked.GetClientSideObject().GetOutputDataObject(0)
    return data.GetFieldData().GetAbstractArray("Verdict").GetValue(0)


def part(proxy, name, value, port=0):
    """What Threshold of a cell array picks, as a surface again."""
    picked = simple.Threshold(
        Input=simple.OutputPort(proxy, port),
        Scalars=["CELLS", name],
        ThresholdMethod="Between",
        LowerThreshold=value - 0.5,
        UpperThreshold=value + 0.5,
    )
    return simple.ExtractSurface(Input=picked)


def assert_cured(body, by, *words):
    """The surface is not clean, its verdict names these filters, and they make it clean."""
    checked = simple.SurfaceCheck(Input=source(body))
    assert field(checked, "Clean") == 0
    for word in words:
        assert word in verdict(checked), verdict(checked)
    assert field(simple.SurfaceCheck(Input=by(checked)), "Clean") == 1


def test_duplicate_cells():
    twice = mesh(BALL.points, np.vstack([BALL.triangles, BALL.triangles[5:9]]))
    assert_cured(twice, lambda c: part(c, "Duplicate", 0), "Threshold Duplicate from 0 to 0", "Extract Surface")


def consistent(proxy):
    return simple.GenerateSurfaceNormals(Input=simple.Clean(Input=proxy), Consistency=1)


def test_contradicting_neighbours():
    triangles = BALL.triangles.copy()
    triangles[[3, 100]] = triangles[[3, 100]][:, ::-1]
    soup = mesh(BALL.points[triangles.ravel()], np.arange(triangles.size))
    for body in (mesh(BALL.points, triangles), soup):
        assert_cured(body, consistent, "Clean", "Generate Surface Normals", "Consistency")


def test_inside_out():
    assert_cured(inside_out(BALL), lambda c: simple.ReverseSense(Input=c), "Reverse Sense")


def test_one_shell_inside_out():
    def turn(c):
        wrong = simple.ReverseSense(Input=part(c, "WrongWay", 1))
        return simple.AppendGeometry(Input=[part(c, "WrongWay", 0), wrong])

    body = joined(BALL, moved(inside_out(scaled(BALL, 0.5)), (3, 0, 0)))
    assert_cured(body, turn, "Threshold WrongWay", "Reverse Sense", "Append Geometry")


def resolved(c):
    return simple.SurfaceBoolean(Input=c, Operation="Resolve")


def test_a_ball_in_a_ball():
    def hollow(c):
        return simple.AppendGeometry(Input=[part(c, "ShellId", 0), simple.ReverseSense(Input=part(c, "ShellId", 1))])

    body = joined(BALL, scaled(BALL, 0.5))
    assert_cured(body, hollow, "Threshold ShellId", "Reverse Sense", "Append Geometry")
    assert_cured(body, resolved, "Resolve")


def test_self_intersections():
    assert_cured(joined(BALL, moved(BALL, (0.9, 0.123, 0.07))), resolved, "Resolve")


def test_a_flat_hole():
    def filled(c):
        rim = part(c, "LoopId", 0, port=1)
        cap = simple.ContourTriangulator(Input=rim)
        return consistent(simple.AppendGeometry(Input=[c, cap]))

    cube = box((0, 0, 0), (2, 2, 2))
    lidless = mesh(cube.points, [t for t in cube.triangles if not np.all(cube.points[t][:, 2] == 2)])
    assert_cured(lidless, filled, "LoopId", "Contour Triangulator", "Append Geometry", "Clean", "Consistency")


def test_cracks():
    corners = BALL.points[BALL.triangles.ravel()] + 1e-9 * np.random.default_rng(1).normal(size=(BALL.triangles.size, 3))
    body = mesh(corners, np.arange(BALL.triangles.size))
    assert_cured(body, lambda c: simple.Clean(Input=c, Tolerance=1e-6), "Clean with a small tolerance")


def test_points_without_a_place_that_nothing_uses():
    body = mesh(np.vstack([BALL.points, [[np.nan, 0, 0]]]), BALL.triangles)
    assert_cured(body, lambda c: simple.Clean(Input=c), "Clean")


def test_pinched_cells():
    body = mesh(BALL.points, np.vstack([BALL.triangles, [[0, 0, 3]]]))
    assert_cured(body, lambda c: simple.Clean(Input=c), "Clean")


# ---- the proxy ----------------------------------------------------------------------------------------


def test_the_properties_and_their_help():
    proxy = simple.SurfaceCheck(Input=simple.Sphere())
    assert set(proxy.ListProperties()) == set(PROPERTIES)
    for name, default in PROPERTIES.items():
        assert default is None or proxy.GetPropertyValue(name) == default
        text = proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription()
        assert len(text.strip()) > 40, name
    assert [proxy.SMProxy.GetOutputPortName(k) for k in range(2)] == ["Surface", "Defects"]
    hint = proxy.GetHints().FindNestedElementByName("ShowInMenu")
    assert hint.GetAttribute("category") == "Surface Booleans" and hint.GetAttribute("icon").endswith(".svg")
    help_text = proxy.SMProxy.GetDocumentation().GetDescription()
    proxy.UpdatePipeline()
    data = proxy.GetClientSideObject().GetOutputDataObject(0)
    arrays = [attributes.GetArrayName(k) for attributes in (data.GetCellData(), data.GetPointData()) for k in range(attributes.GetNumberOfArrays())]
    assert all(name in help_text for name in arrays if name != "Normals")


@pytest.mark.parametrize("kind", states.KINDS)
def test_a_state_file_gives_the_same_pipeline(kind, tmp_path):
    tube = simple.Cylinder(Capping=0, Resolution=8)
    checked = simple.SurfaceCheck(registrationName="Look", Input=tube, SelfIntersections=0)
    assert field(checked, "BoundaryLoopCount") == 2
    states.replay(kind, tmp_path)
    again = simple.FindSource("Look")
    assert again.SelfIntersections == 0 and field(again, "BoundaryLoopCount") == 2


def test_a_changed_input_is_checked_again():
    tube = simple.Cylinder(Capping=0)
    checked = simple.SurfaceCheck(Input=tube)
    assert field(checked, "Fit") == 0
    tube.Capping = 1
    assert field(checked, "Fit") == 1 and field(checked, "Clean") == 1
