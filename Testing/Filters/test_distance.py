# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What vtkPolyDataDistance and vtkImplicitPolyData promise: the interface of the paper's sections 3.1 and 3.2, values
that are known, and signs that are right."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkRectilinearGrid, vtkTable
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkClipPolyData, vtkCutter
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkImagingHybrid import vtkSampleFunction

import meshes
from booleans import points_of, polydata
from distances import arrays, cloud, distance_filter, distances, implicit, quietly
from reference_distance import to_triangle
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


# ---- beyond the paper ----------------------------------------------------------------------------


def test_the_implicit_function_serves_vtks_own_classes():
    function = implicit(meshes.cgal_mesh("eight"))
    sampled = vtkSampleFunction()
    sampled.SetImplicitFunction(function)
    sampled.SetModelBounds(-1, 1, -1, 1, -1, 1)
    sampled.SetSampleDimensions(24, 24, 24)
    sampled.Update()
    image = sampled.GetOutput()
    points = np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
    wanted = distances(cloud(points), meshes.cgal_mesh("eight"))
    assert np.abs(arrays(image.GetPointData())["scalars"] - wanted).max() < 1e-15

    ball = meshes.icosphere(4, 1.0)
    clipped = vtkClipPolyData()
    clipped.SetInputData(polydata(ball))
    clipped.SetClipFunction(implicit(meshes.box((0, -2, -2), (2, 2, 2))))
    clipped.InsideOutOn()
    clipped.Update()
    xs = points_of(clipped.GetOutput())[:, 0]
    assert clipped.GetOutput().GetNumberOfCells() > 2000 and xs.min() > -1e-12

    cut = vtkCutter()
    cut.SetInputData(polydata(ball))
    cut.SetCutFunction(implicit(meshes.box((0, -2, -2), (2, 2, 2))))
    cut.Update()
    assert cut.GetOutput().GetNumberOfCells() > 20
    assert np.abs(points_of(cut.GetOutput())[:, 0]).max() < 1e-12

    extracted = vtkExtractGeometry()
    extracted.SetInputData(polydata(ball))
    extracted.SetImplicitFunction(implicit(meshes.box((0, -2, -2), (2, 2, 2))))
    extracted.Update()
    assert 0 < extracted.GetOutput().GetNumberOfCells() < len(ball.triangles) / 2


def test_several_threads_may_evaluate_the_implicit_function_at_once():
    body = meshes.cgal_mesh("elephant")
    points = np.random.default_rng(5).uniform(-1, 1, (4000, 3))
    wanted = distances(cloud(points), body)
    function = implicit(body)  # prepared by whichever thread comes first
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(function.EvaluateFunction, points))
    assert np.array_equal(found, wanted)


def test_the_implicit_function_follows_its_input():
    data = polydata(CUBE)
    function = implicit(data)
    assert function.EvaluateFunction((2, 0, 0)) == 1
    before = function.GetMTime()
    data.SetPoints(polydata(meshes.cube(1.0)).GetPoints())
    assert function.GetMTime() > before
    assert function.EvaluateFunction((2, 0, 0)) == 1.5


def test_nearest_point_cell_and_direction_on_request():
    points = np.random.default_rng(6).uniform(-1, 1, (3000, 3))
    body = meshes.cgal_mesh("joint")
    plain = arrays(distance_filter(cloud(points), body).GetOutput().GetPointData())
    assert set(plain) == {"Distance"}
    all_on = {"ComputeNearestPoint": 1, "ComputeNearestCellId": 1, "ComputeDirection": 1}
    found = arrays(distance_filter(cloud(points), body, **all_on).GetOutput().GetPointData())
    length = np.abs(found["Distance"])
    assert np.array_equal(found["Distance"], plain["Distance"])
    assert np.abs(np.linalg.norm(found["NearestPoint"] - points, axis=1) - length).max() < 1e-15
    assert np.abs(points + found["Direction"] * length[:, None] - found["NearestPoint"]).max() < 1e-15
    corners = body.points[body.triangles[found["NearestCellId"]]].astype(np.longdouble)
    to_cell = to_triangle(*corners.transpose(1, 0, 2), points.astype(np.longdouble))
    assert np.abs(np.sqrt(to_cell) - length).max() < 1e-15


def test_distances_at_cell_centres():
    quads = vtkCubeSource()
    quads.Update()
    found = distance_filter(quads.GetOutput(), CUBE, ComputeCellCenterDistance=1)
    assert arrays(found.GetOutput().GetCellData())["Distance"] == pytest.approx([-0.5] * 6)
    assert "Distance" not in arrays(distance_filter(quads.GetOutput(), CUBE).GetOutput().GetCellData())


def test_any_data_set_is_measured_and_keeps_its_type():
    image = vtkImageData()
    image.SetDimensions(5, 4, 3)
    image.SetOrigin(-2, -2, -2)
    append = vtkAppendFilter()
    append.SetInputData(image)
    append.Update()
    grid = vtkRectilinearGrid()
    grid.SetDimensions(2, 2, 2)
    for data in (image, append.GetOutput(), grid, cloud(np.eye(3))):
        points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
        output = distance_filter(data, CUBE, ComputeCellCenterDistance=1).GetOutputDataObject(0)
        assert output.GetClassName() == data.GetClassName()
        assert arrays(output.GetPointData())["Distance"] == pytest.approx(distance_to_cube(points), abs=1e-15)
        assert len(arrays(output.GetCellData())["Distance"]) == data.GetNumberOfCells()


def test_blocks_of_the_input_stay_blocks_and_blocks_of_the_tool_are_one_surface():
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, cloud([[3, 0, 0]]))
    blocks.SetBlock(1, cloud([[0, 0, 0], [9, 0, 0]]))
    tools = vtkMultiBlockDataSet()
    tools.SetBlock(0, polydata(CUBE))
    tools.SetBlock(1, polydata(meshes.moved(CUBE, (8, 0, 0))))
    tested = distance_filter(blocks, tools, ComputeSecondDistance=1)
    output = tested.GetOutputDataObject(0)
    found = [arrays(output.GetBlock(i).GetPointData())["Distance"] for i in range(2)]
    assert found[0] == pytest.approx([2]) and found[1] == pytest.approx([-1, 0])
    assert arrays(output.GetFieldData())["DistanceMaximum"] == pytest.approx(2)
    assert tested.GetSecondDistanceOutput().GetNumberOfPoints() == 16


def test_a_cloud_as_input_has_a_second_distance_to_its_points():
    points = np.random.default_rng(7).uniform(-3, 3, (500, 3))
    tested = distance_filter(cloud(points), CUBE, ComputeSecondDistance=1)
    second = arrays(tested.GetSecondDistanceOutput().GetPointData())["Distance"]
    wanted = np.linalg.norm(CUBE.points[:, None] - points[None], axis=2).min(axis=1)
    assert second == pytest.approx(wanted)


def test_the_summary_is_what_numpy_makes_of_the_array():
    points = np.random.default_rng(8).uniform(-2, 2, (4001, 3))
    fields = arrays(distance_filter(cloud(points), CUBE).GetOutput().GetFieldData())
    wanted = distance_to_cube(points)
    assert fields["DistanceMinimum"] == pytest.approx(wanted.min())
    assert fields["DistanceMaximum"] == pytest.approx(wanted.max())
    assert fields["DistanceMean"] == pytest.approx(wanted.mean())
    assert fields["DistanceRMS"] == pytest.approx(np.sqrt((wanted**2).mean()))
    for percent in (5, 25, 50, 75, 95):
        assert fields[f"DistanceQuantile{percent}"] == pytest.approx(np.percentile(wanted, percent))
    assert fields["HausdorffInputToTool"] == pytest.approx(np.abs(wanted).max())


def test_beyond_the_maximum_distance_there_is_no_nearest_cell():
    points = np.random.default_rng(9).uniform(-3, 3, (3000, 3))
    wanted = distance_to_cube(points)
    for signs in ({}, {"SignMethod": 1}, {"SignedDistance": 0}):
        tested = distance_filter(cloud(points), CUBE, MaximumDistance=0.5, ComputeNearestCellId=1, **signs)
        found = arrays(tested.GetOutput().GetPointData())
        expected = np.abs(wanted) if signs == {"SignedDistance": 0} else wanted
        assert found["Distance"] == pytest.approx(np.clip(expected, -0.5, 0.5), abs=1e-15)
        assert np.array_equal(found["NearestCellId"] < 0, np.abs(wanted) > 0.5)


def test_the_result_does_not_depend_on_the_number_of_threads():
    body = meshes.cgal_mesh("elephant")
    points = cloud(np.random.default_rng(10).uniform(-1, 1, (20000, 3)))
    all_on = {"ComputeNearestPoint": 1, "ComputeNearestCellId": 1, "ComputeDirection": 1}
    results = [
        arrays(distance_filter(points, body, NumberOfThreads=n, **all_on).GetOutput().GetPointData()) for n in (1, 2, 5)
    ]
    for other in results[1:]:
        for name, values in results[0].items():
            assert values.tobytes() == other[name].tobytes()


def test_points_shared_or_not_give_the_same_signs():
    body = meshes.cgal_mesh("fandisk")
    apart = meshes.mesh(body.points[body.triangles], np.arange(3 * len(body.triangles)))
    rng = np.random.default_rng(11)
    points = body.points[rng.integers(0, len(body.points), 5000)] + rng.normal(scale=1e-3, size=(5000, 3))
    assert np.array_equal(distances(cloud(points), body), distances(cloud(points), apart))


# ---- conditions ----------------------------------------------------------------------------------


def status_of(tested):
    fields = arrays(tested.GetOutputDataObject(0).GetFieldData())
    return int(fields["Status"][0]), fields["Message"][0]


def test_what_cannot_be_measured_is_said_in_one_sentence_and_gives_nothing():
    bad = meshes.mesh(np.where(CUBE.points == CUBE.points.max(), np.nan, CUBE.points), CUBE.triangles)
    wrong = polydata(CUBE, [[0, 1, 99]])
    for points, tool, settings, status, word in (
        (cloud(np.eye(3)), meshes.EMPTY, {}, 30, "no polygon"),
        (cloud(np.eye(3)), bad, {}, 6, "finite"),
        (cloud(np.eye(3)), wrong, {}, 7, "does not exist"),
        (cloud(np.eye(3)), vtkImageData(), {}, 20, "Extract Surface"),
        (vtkTable(), CUBE, {}, 20, "no points"),
        (cloud(np.eye(3)), CUBE, {"MaximumDistance": -1.0}, 10, "MaximumDistance"),
        (meshes.EMPTY, CUBE, {"ComputeSecondDistance": 1}, 30, "no point"),
    ):
        tested = quietly(points, tool, **settings)
        assert status_of(tested)[0] == status and word in status_of(tested)[1]
        assert tested.GetOutput().GetNumberOfPoints() == 0
        assert tested.GetSecondDistanceOutput().GetNumberOfPoints() == 0
        assert len(tested.heard["ErrorEvent"]) == 1 and not tested.heard["WarningEvent"]


def test_missing_inputs_are_named():
    for tool, status, word in ((None, 21, "Tool"), (CUBE, 10, "Input")):
        tested = quietly(None if tool else cloud(np.eye(3)), tool)
        assert status_of(tested)[0] == status and word in status_of(tested)[1]


def test_doubtful_signs_are_warned_of_and_unsigned_distances_are_not():
    hole = meshes.mesh(CUBE.points, CUBE.triangles[:-1])
    turned = meshes.mesh(CUBE.points, np.vstack([CUBE.triangles[:-1], CUBE.triangles[-1:, ::-1]]))
    for tool, status in ((hole, 2), (turned, 32), (meshes.inside_out(CUBE), 4)):
        tested = quietly(cloud(np.eye(3)), tool)
        assert status_of(tested)[0] == status
        assert len(tested.heard["WarningEvent"]) == 1 and not tested.heard["ErrorEvent"]
        for settings in ({"SignedDistance": 0}, {"SignMethod": 1}):
            tested = quietly(cloud(np.eye(3)), tool, **settings)
            assert status_of(tested)[0] == 0 and not tested.heard["WarningEvent"]


def test_the_winding_number_gives_signs_to_open_and_dirty_surfaces():
    rng = np.random.default_rng(12)
    ball = meshes.icosphere(4, 1.0)
    points = rng.normal(size=(3000, 3))
    points *= rng.choice([0.8, 1.2], (3000, 1)) / np.linalg.norm(points, axis=1)[:, None]
    points = points[points[:, 2] < 0.3]  # away from the hole
    inside = np.linalg.norm(points, axis=1) < 1
    hole = meshes.mesh(ball.points, ball.triangles[ball.points[ball.triangles].mean(axis=1)[:, 2] < 0.9])
    flip = rng.random(len(ball.triangles)) < 0.05
    dirty = meshes.mesh(ball.points, np.where(flip[:, None], ball.triangles[:, ::-1], ball.triangles))
    for tool in (hole, dirty):
        assert np.array_equal(distances(cloud(points), tool, SignMethod=1) < 0, inside)


def test_points_that_are_not_finite_have_no_distance():
    points = np.array([[3.0, 0, 0], [np.nan, 0, 0], [0, np.inf, 0], [0, 0, 0]])
    tested = quietly(cloud(points), CUBE, ComputeNearestCellId=1)
    found = arrays(tested.GetOutput().GetPointData())
    assert found["Distance"] == pytest.approx([2, np.nan, np.nan, -1], nan_ok=True)
    assert found["NearestCellId"][1] == found["NearestCellId"][2] == -1
    assert status_of(tested)[0] == 31 and len(tested.heard["WarningEvent"]) == 1
    assert arrays(tested.GetOutput().GetFieldData())["DistanceMaximum"] == pytest.approx(2)


def test_without_points_there_is_an_empty_array():
    tested = quietly(meshes.EMPTY, CUBE)
    assert len(arrays(tested.GetOutput().GetPointData())["Distance"]) == 0
    assert status_of(tested)[0] == 0 and not tested.heard["ErrorEvent"]


def test_an_open_surface_has_the_side_of_its_nearest_polygon():
    sheet = meshes.mesh([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], [[0, 1, 2], [0, 2, 3]])
    tested = quietly(cloud([[2, 2, 1], [2, 2, -1], [-3, 2, 4], [-3, 2, -4]]), sheet)
    assert arrays(tested.GetOutput().GetPointData())["Distance"] == pytest.approx([1, -1, 5, -5])


def test_it_can_be_stopped():
    tested = vtkPolyDataDistance()
    tested.SetInputData(cloud(np.random.default_rng(13).uniform(-1, 1, (300000, 3))))
    tested.SetToolData(polydata(meshes.cgal_mesh("elephant")))
    tested.AddObserver("ProgressEvent", lambda *_: tested.SetAbortExecuteAndUpdateTime())
    tested.Update()
    assert status_of(tested)[0] == 9
    assert tested.GetOutput().GetNumberOfPoints() == 0
