# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Intersection with a mesh as its Tool: the filter, the proxy, real scans and real meshes."""

import numpy as np
import pytest
from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPartitionedDataSet,
    vtkPolyData,
    vtkTable,
)

import clouds
import meshes
import states
from booleans import polydata
from sections import curves_of, plane_section, update, values_at

OK, COINCIDENT_AREA, FACETS_ONLY, TOUCHING, BAD_REQUEST, NOT_POINTS, NOT_A_SURFACE, TOO_FEW_POINTS = 0, 4, 5, 6, 10, 20, 21, 30
NO_END, TOOL_BORDER, SCAN_BORDER = 0, 1, 2


def check(result, tool, bound, may_touch=False):
    """What holds of all curves: in the plane of their cell of the tool and in it, closed or with two ends."""
    assert not result.errors and (result.status == OK or may_touch and result.status == TOUCHING)
    assert len(result.warnings) == (result.status != OK)
    assert result.of_curves["ChordError"].max(initial=0) <= bound
    corners = tool.points[tool.triangles[result.of_points["OriginalCellId"]]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(normals, axis=1)
    off = np.einsum("ij,ij->i", result.points - corners[:, 0], normals)
    assert (np.abs(off) <= 1e-12 * size * np.abs(tool.points).max()).all()
    for k in range(3):  # and on the inner side of its edges
        along = corners[:, (k + 1) % 3] - corners[:, k]
        side = np.einsum("ij,ij->i", np.cross(along, result.points - corners[:, k]), normals)
        assert (side > -1e-9 * size * size).all()
    for line, closed, ends, length in zip(
        result.lines, result.of_curves["Closed"], result.of_curves["Ends"], result.of_curves["Length"]
    ):
        assert (line[0] == line[-1]) == bool(closed)
        assert (ends == NO_END).all() == bool(closed)
        steps = np.linalg.norm(np.diff(result.points[line], axis=0), axis=1)
        assert length == pytest.approx(steps.sum(), rel=1e-12)


def test_a_box_cuts_arcs_out_of_a_sphere():
    data = clouds.cloud(*clouds.sphere(10000))
    box = meshes.box((0.3, 0.3, 0.3), (4, 4, 4))
    result = curves_of(data, box, ChordError=1e-4)
    check(result, box, 1e-4)
    radius = np.sqrt(1 - 0.09)
    exact = 3 * radius * (np.pi / 2 - 2 * np.arcsin(0.3 / radius))
    assert result.of_curves["Closed"].tolist() == [1] and result.of_curves["Tangential"].tolist() == [0]
    assert result.of_curves["Length"][0] == pytest.approx(exact, rel=1e-3)
    assert np.abs(np.linalg.norm(result.points, axis=1) - 1).max() < 1e-5
    assert np.einsum("ij,ij->i", result.of_points["Normals"], result.points).min() > 0.999
    assert np.median(result.of_points["Curvature"]) == pytest.approx(-1 / radius, rel=0.01)
    assert result.number("CoincidentArea") == 0
    # A corner is a point of each curve that turns around it: the three arcs lie on three planes.
    assert all((np.abs(result.points[:, axis] - 0.3) < 1e-12).sum() > 5 for axis in range(3))


def test_circles_converge_with_the_mesh():
    data = clouds.cloud(*clouds.sphere(10000))
    height = (1.44 + 1 - 0.49) / 2.4  # of the plane of the circle of two spheres 1.2 apart
    exact = 2 * np.pi * np.sqrt(1 - height * height)
    found = []
    for level in (2, 3, 4, 5):
        ball = meshes.moved(meshes.icosphere(level, 0.7), (1.2, 0, 0))
        result = curves_of(data, ball, ChordError=1e-4)
        check(result, ball, 1e-4)
        assert result.of_curves["Closed"].tolist() == [1]
        found.append(abs(result.of_curves["Length"][0] - exact))
    assert found[1] < 0.4 * found[0] and found[2] < 0.4 * found[1] and found[3] < 1e-3


def test_a_cylinder_leaves_two_circles():
    data = clouds.cloud(*clouds.sphere(10000))
    tube = meshes.cylinder(0.5, 4, around=200)
    result = curves_of(data, tube, ChordError=1e-4)
    check(result, tube, 1e-4)
    assert result.of_curves["Closed"].tolist() == [1, 1]
    assert result.of_curves["Length"] == pytest.approx(np.pi, rel=1e-3)


def test_a_torus_and_a_ball_around_its_hole():
    rng = np.random.default_rng(1)
    data = clouds.cloud(*clouds.torus(20000, rng))
    ball = meshes.icosphere(5)
    result = curves_of(data, ball)
    check(result, ball, 0.1 * result.number("Spacing"))
    # Both circles about the axis at a distance of (1 + 1 - 0.16) / 2 from it.
    assert result.of_curves["Closed"].tolist() == [1, 1]
    assert result.of_curves["Length"] == pytest.approx(2 * np.pi * 0.92, rel=2e-3)


def test_open_meshes_and_open_scans_end_as_told():
    data = clouds.cloud(*clouds.plane(60))
    wall = meshes.mesh([[0.5, 0.4, -1], [4, 0.4, -1], [4, 0.4, 1], [0.5, 0.4, 1]], [[0, 1, 2], [0, 2, 3]])
    result = curves_of(data, wall)
    check(result, wall, 1)
    assert sorted(result.of_curves["Ends"][0].tolist()) == [TOOL_BORDER, SCAN_BORDER]
    line = result.points[result.lines[0]]
    assert line[:, 0].min() == pytest.approx(0.5, abs=1e-12) and line[:, 0].max() == pytest.approx(1, abs=0.05)
    # The plane's curves have both ends at the border of the scan.
    cut = plane_section(data, (0.5, 0.4, 0), (0, 1, 0))
    assert cut.of_curves["Ends"].tolist() == [[SCAN_BORDER, SCAN_BORDER]]


def test_a_loop_inside_of_one_triangle_and_a_touch():
    data = clouds.cloud(*clouds.sphere(10000))  # spacing 0.035
    for radius, tangential in ((0.075, 1), (0.15, 0)):
        z = np.sqrt(1 - radius**2)
        large = meshes.mesh([[-9, -8, z], [10, -7, z], [0, 9, z]], [[0, 1, 2]])
        result = curves_of(data, large)
        check(result, large, 1)
        assert result.of_curves["Length"] == pytest.approx([2 * np.pi * radius], rel=0.02)
        assert result.of_curves["Tangential"].tolist() == [tangential]
    above = meshes.mesh([[-9, -8, 1.001], [10, -7, 1.001], [0, 9, 1.001]], [[0, 1, 2]])
    result = curves_of(data, above)
    assert result.status == TOUCHING and not result.lines and len(result.warnings) == 1
    assert result.field_data["NumberOfTouches"][0] == 1 and "Tool touches" in result.message
    corner = meshes.mesh([[0, 0, 1.002], [1, 0, 2], [0, 1, 2]], [[0, 1, 2]])
    assert curves_of(data, corner).status == TOUCHING
    away = meshes.mesh([[-9, -8, 1.01], [10, -7, 1.01], [0, 9, 1.01]], [[0, 1, 2]])
    assert curves_of(data, away).status == OK


@pytest.mark.parametrize(
    "cloud, mesh, share",
    [("kitten.xyz", "elephant", 0.6), ("oni.pwn", "knot1", 0.5), ("kitten.xyz", "mannequin-devil", 0.7)],
)
def test_real_scans_and_real_meshes(cloud, mesh, share):
    """Wherever the function's sign changes along an edge of the mesh, a curve goes through."""
    points, normals = clouds.cgal_cloud(cloud)
    data = clouds.cloud(points, normals)
    lower, upper = points.min(axis=0), points.max(axis=0)
    body = meshes.cgal_mesh(mesh)
    low, high = body.points.min(axis=0), body.points.max(axis=0)
    factor = share * np.linalg.norm(upper - lower) / np.linalg.norm(high - low)
    body = meshes.mesh((body.points - (low + high) / 2) * factor + lower + 0.7 * (upper - lower), body.triangles)
    result = curves_of(data, body)
    spacing = result.number("Spacing")
    assert result.lines
    check(result, body, 0.1 * spacing, may_touch=True)
    assert np.abs(values_at(data, result.points)).max() < 1e-9 * spacing
    edges = np.unique(np.sort(np.concatenate([body.triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1), axis=0)
    a, b = body.points[edges[:, 0]], body.points[edges[:, 1]]
    near = np.linalg.norm((a + b) / 2 - result.points.mean(axis=0), axis=1) < np.linalg.norm(upper - lower)
    short = np.linalg.norm(a - b, axis=1) < 2 * spacing
    edges = edges[near & short]
    values = dict(zip(np.unique(edges), values_at(data, body.points[np.unique(edges)])))
    f = np.array([[values[i] for i in edge] for edge in edges])
    crossed = f[:, 0] * f[:, 1] < 0
    assert crossed.sum() > 30
    t = f[crossed, 0] / (f[crossed, 0] - f[crossed, 1])
    crossings = body.points[edges[crossed, 0]] + t[:, None] * (
        body.points[edges[crossed, 1]] - body.points[edges[crossed, 0]]
    )
    for x in crossings:
        assert np.linalg.norm(result.points - x, axis=1).min() < spacing


def test_the_order_of_points_and_threads_do_not_matter():
    rng = np.random.default_rng(2)
    points, normals = clouds.torus(4000, rng)
    order = rng.permutation(4000)
    ball = meshes.moved(meshes.icosphere(2, 0.7), (0.8, 0.1, 0))
    one = curves_of(clouds.cloud(points, normals), ball, NumberOfThreads=1)
    other = curves_of(clouds.cloud(points[order], normals[order]), ball, NumberOfThreads=3)
    assert len(one.points) > 50 and one.bytes() == other.bytes()


def test_a_scan_of_the_tool_itself_is_reported_and_not_marched():
    rng = np.random.default_rng(3)
    u, v = rng.uniform(-1, 1, (2, 12000))
    face = rng.integers(0, 3, 12000)
    side = rng.choice([-1.0, 1.0], 12000)
    points = np.stack([side, u, v], axis=1)
    normals = np.stack([side, 0 * u, 0 * u], axis=1)
    for axis in (1, 2):
        points[face == axis] = np.roll(points[face == axis], axis, axis=1)
        normals[face == axis] = np.roll(normals[face == axis], axis, axis=1)
    points += 0.005 * rng.normal(size=(12000, 1)) * normals
    data, box = clouds.cloud(points, normals), meshes.box((-1, -1, -1), (1, 1, 1))
    result = curves_of(data, box)
    assert result.status == COINCIDENT_AREA and not result.errors
    assert len(result.warnings) == 1 and "area" in result.warnings[0]
    assert 12 < result.number("CoincidentArea") < 24
    moved = curves_of(data, meshes.moved(box, (0.2, 0.1, 0.05)))
    assert moved.status == OK and moved.number("CoincidentArea") == 0 and len(moved.lines) == 1


def test_composite_inputs_count_as_one():
    points, normals = clouds.sphere(10000)
    box = meshes.box((0.3, 0.3, 0.3), (4, 4, 4))
    one = curves_of(clouds.cloud(points, normals), box)
    cloud, tool = vtkMultiBlockDataSet(), vtkPartitionedDataSet()
    for k in range(2):
        cloud.SetBlock(k, clouds.cloud(points[k::2], normals[k::2]))
        tool.SetPartition(k, polydata(meshes.mesh(box.points, box.triangles[k::2])))
    other = curves_of(cloud, tool)
    assert other.status == OK
    assert other.of_curves["Closed"].tolist() == [1]
    assert other.of_curves["Length"] == pytest.approx(one.of_curves["Length"], rel=1e-3)


def test_polygons_are_cells_of_the_tool():
    data = clouds.cloud(*clouds.sphere(10000))
    quads = vtkPolyData()
    corners = vtkPoints()
    for x in ((-3, -3, 0.2), (3, -3, 0.2), (3, 3, 0.2), (-3, 3, 0.2), (3, 6, 3), (-3, 6, 3)):
        corners.InsertNextPoint(x)
    cells = vtkCellArray()
    for ids in ((3, 2, 4, 5), (0, 1, 2, 3)):
        cells.InsertNextCell(4, ids)
    quads.SetPoints(corners)
    quads.SetPolys(cells)
    result = curves_of(data, quads)
    assert result.status == OK and result.of_curves["Closed"].tolist() == [1]
    assert set(result.of_points["OriginalCellId"].tolist()) == {1}


def lone_points():
    data = vtkPolyData()
    corners = vtkPoints()
    corners.InsertNextPoint(0, 0, 0)
    data.SetPoints(corners)
    return data


def broken(value):
    return meshes.mesh([[0, 0, 0], [2, 0, 0], [0, value, 0]], [[0, 1, 2]])


@pytest.mark.parametrize(
    "tool, wanted, word",
    [
        (vtkTable(), NOT_A_SURFACE, "Tool"),
        (vtkImageData(), NOT_A_SURFACE, "Extract Surface"),
        (broken(np.nan), NOT_A_SURFACE, "Tool"),
        (broken(np.inf), NOT_A_SURFACE, "Tool"),
    ],
)
def test_a_bad_tool_is_refused_in_one_sentence(tool, wanted, word):
    result = curves_of(clouds.cloud(*clouds.sphere(500)), tool)
    assert result.status == wanted and len(result.errors) == 1 and word in result.errors[0]
    assert result.errors[0].strip().endswith(".")
    assert result.data.GetNumberOfPoints() == 0 and result.data.GetNumberOfCells() == 0


@pytest.mark.parametrize("tool", [vtkPolyData(), lone_points(), meshes.cube(1, (9, 9, 9)), broken(0.0)])
def test_a_tool_without_polygons_or_far_away_gives_nothing_and_no_error(tool):
    result = curves_of(clouds.cloud(*clouds.sphere(500)), tool)
    assert result.status == OK and not result.errors and not result.lines


def test_bad_clouds_are_refused_with_a_tool_as_without():
    ball = meshes.icosphere(1)
    for data, wanted in ((vtkTable(), NOT_POINTS), (clouds.cloud(np.eye(3)), TOO_FEW_POINTS)):
        result = curves_of(data, ball)
        assert result.status == wanted and len(result.errors) == 1 and not result.lines
    result = curves_of(clouds.cloud(*clouds.sphere(100)), ball, ChordError=-1.0)
    assert result.status == BAD_REQUEST and len(result.errors) == 1


def proxy_with_a_tool():
    scan = simple.Sphere(registrationName="Scan", ThetaResolution=60, PhiResolution=60, Radius=1)
    body = simple.Box(registrationName="Body", XLength=1, YLength=1, ZLength=8)
    return simple.PointSetIntersection(registrationName="Curves", Input=scan, Tool=body)


def check_proxy(proxy):
    proxy.UpdatePipeline()
    assert proxy.FieldData["Status"].GetRange() == (0, 0)
    assert proxy.GetDataInformation().GetNumberOfCells() == 2  # the column leaves at both ends
    assert proxy.CellData["Length"].GetRange()[0] == pytest.approx(4 * 1.04, rel=0.03)


def test_the_proxy_takes_a_tool_and_gives_it_back():
    simple.ResetSession()
    proxy = proxy_with_a_tool()
    check_proxy(proxy)
    proxy.Tool = None
    proxy.UpdatePipeline()
    assert proxy.GetDataInformation().GetNumberOfCells() == 1  # the plane's circle
    assert "CoincidentArea" not in proxy.FieldData.keys()


@pytest.mark.parametrize("kind", states.KINDS)
def test_a_state_file_gives_the_same_curves(kind, tmp_path):
    simple.ResetSession()
    proxy = proxy_with_a_tool()
    proxy.ChordError = 0.002
    check_proxy(proxy)
    wanted = proxy.GetDataInformation().GetNumberOfPoints()
    states.replay(kind, tmp_path)
    again = simple.FindSource("Curves")
    assert again.ChordError == 0.002
    check_proxy(again)
    assert again.GetDataInformation().GetNumberOfPoints() == wanted
