# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Surface on shapes that are known, on scans, and on input that is bad."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkTable

import clouds
import measures
from clouds import cloud, run, surface_of

OK, BAD_NORMALS, DOUBTFUL, INVALID = 0, 1, 2, 3
BAD_REQUEST, NOT_POINTS, TOO_FEW_POINTS, NO_PLANE, TOO_FINE = 10, 20, 30, 31, 32
SPACING_OF_TORUS = np.sqrt(4 * np.pi**2 * 0.4)  # by the root of the number of points


# ---- known shapes ------------------------------------------------------------------------------


@pytest.mark.parametrize("count", [4000, 16000])
@pytest.mark.parametrize("noise", [0.0, 0.2, 0.5])
def test_a_torus_is_found_within_its_noise(count, noise):
    rng = np.random.default_rng(1)
    points, normals = clouds.torus(count, rng)
    spacing = SPACING_OF_TORUS / np.sqrt(count)
    noisy = points + noise * spacing * rng.normal(size=(count, 1)) * normals
    result = surface_of(noisy, normals, GenerateSurface=True)
    assert result.status == OK and not result.errors
    assert result.number("Spacing") == pytest.approx(spacing, rel=0.05 + 0.12 * noise)
    # Averaging leaves about 0.13 of the noise; curvature adds a little on the coarse cloud.
    for found in (result.points, result.mesh.points):
        off = clouds.distance_to_torus(found) / spacing
        assert np.sqrt(np.mean(off**2)) < 0.02 + 0.18 * noise
        assert abs(np.mean(off)) < 0.005 + 0.04 * noise  # noise of sigma on a curvature k: about -k sigma^2
    assert measures.is_closed(result.mesh)
    euler = len(result.mesh.points) - len(result.mesh.triangles) / 2
    assert euler == 0
    if noise:
        assert result.number("ResidualRMS") == pytest.approx(noise * spacing, rel=0.1)


def test_volume_and_area_of_a_sphere_converge():
    errors = []
    for count in (2000, 8000, 32000):
        result = surface_of(*clouds.sphere(count), GenerateSurface=True)
        assert measures.is_closed(result.mesh)
        errors.append((4 * np.pi / 3 - measures.volume(result.mesh), 4 * np.pi - measures.area(result.mesh)))
        assert np.abs(np.linalg.norm(result.points, axis=1) - 1).max() < 1e-6
    rates = np.log2(np.array(errors)[:-1] / np.array(errors)[1:])
    assert np.abs(rates - 2).max() < 0.15  # second order in the spacing


def test_the_papers_surface_lies_inside_by_its_bias():
    points, normals = clouds.sphere(6000)
    for width in (0.12, 0.2):
        result = surface_of(points, normals, Definition=1, Width=width)
        bias = np.linalg.norm(result.points, axis=1).mean() - 1
        assert bias == pytest.approx(-(width**2) / 2, rel=0.05)


def test_curvatures_have_their_sign_and_size():
    points, normals = clouds.sphere(8000, radius=2.0)
    ball = surface_of(points, normals)
    assert ball.arrays["MeanCurvature"].mean() == pytest.approx(0.5, rel=0.01)
    assert ball.arrays["GaussCurvature"].mean() == pytest.approx(0.25, rel=0.02)
    turned = surface_of(points, normals, FlipNormals=True)
    assert turned.arrays["MeanCurvature"].mean() == pytest.approx(-0.5, rel=0.01)
    points, normals = clouds.cylinder(6000, np.random.default_rng(2))
    tube = surface_of(points, normals, Width=0.2)
    inner = (tube.arrays["Validity"] == 0) & (np.abs(points[:, 2]) < 0.5)
    assert np.median(tube.arrays["MaximumCurvature"][inner]) == pytest.approx(2, rel=0.03)
    assert abs(np.median(tube.arrays["MinimumCurvature"][inner])) < 0.1


def test_normals_are_found_where_there_are_none():
    rng = np.random.default_rng(3)
    points, normals = clouds.torus(10000, rng)
    result = surface_of(points, GenerateSurface=True)
    assert result.number("NormalsEstimated") == 1 and result.number("DoubtfulShare") < 0.01
    agreement = np.einsum("ij,ij->i", result.arrays["Normals"], normals)
    assert agreement.min() > np.cos(np.radians(10))
    assert measures.is_closed(result.mesh) and measures.volume(result.mesh) > 0
    assert np.linalg.norm(result.arrays["Normals"], axis=1) == pytest.approx(1, abs=1e-12)


def test_an_open_tube_gives_an_open_mesh_and_marks_its_rims():
    rng = np.random.default_rng(4)
    points, normals = clouds.cylinder(20000, rng)
    result = surface_of(points, normals, GenerateSurface=True)
    spacing = result.number("Spacing")
    assert result.number("NumberOfBorderEdges") == measures.open_edges(result.mesh) > 0
    border = result.arrays["Validity"] == 2
    assert border.any() and np.abs(points[border, 2]).min() > 1 - 3 * spacing
    assert np.abs(result.mesh.points[:, 2]).max() < 1 + 2 * spacing
    assert np.abs(result.mesh.points[:, 2]).max() > 1 - 2 * spacing
    assert np.hypot(*result.mesh.points[:, :2].T) == pytest.approx(0.5, abs=0.1 * spacing)


def test_points_may_stay_where_they_are():
    rng = np.random.default_rng(5)
    points, normals = clouds.torus(3000, rng)
    data = cloud(points + 0.005 * normals * rng.normal(size=(3000, 1)), normals)
    kept, moved = run(data, ProjectPoints=False), run(data)
    assert np.array_equal(kept.points, clouds.points_of(data))
    apart = np.linalg.norm(moved.points - kept.points, axis=1)
    assert np.abs(moved.arrays["Residual"]) == pytest.approx(apart, abs=1e-12)
    ahead = np.einsum("ij,ij->i", kept.points - moved.points, moved.arrays["Normals"])
    assert np.array_equal(np.sign(ahead), np.sign(moved.arrays["Residual"]))


def test_coordinates_far_from_the_origin_cost_digits_only():
    rng = np.random.default_rng(6)
    points, normals = clouds.torus(4000, rng)
    here = surface_of(points, normals, GenerateSurface=True)
    away = surface_of(points + 1e6, normals, GenerateSurface=True)
    assert np.abs(away.points - 1e6 - here.points).max() < 1e-8
    assert measures.is_closed(away.mesh)
    assert np.nanmax(np.abs(away.arrays["MeanCurvature"] - here.arrays["MeanCurvature"])) < 1e-4


@pytest.mark.parametrize("with_normals", [True, False])
def test_sharp_edges_are_rounded_but_closed(with_normals):
    points, normals = clouds.cube(12000, np.random.default_rng(11))
    result = surface_of(points, normals if with_normals else None, GenerateSurface=True)
    assert result.status == OK and measures.is_closed(result.mesh)
    assert len(result.mesh.points) - len(result.mesh.triangles) / 2 == 2
    assert measures.volume(result.mesh) == pytest.approx(1, abs=0.005)


# ---- what must not matter ----------------------------------------------------------------------


def test_the_order_of_the_points_does_not_matter():
    rng = np.random.default_rng(7)
    points, normals = clouds.torus(4000, rng)
    order = rng.permutation(4000)
    for with_normals in (True, False):
        one = surface_of(points, normals if with_normals else None, GenerateSurface=True)
        other = surface_of(points[order], normals[order] if with_normals else None, GenerateSurface=True)
        assert np.array_equal(one.points[order], other.points)
        assert np.array_equal(one.mesh.points, other.mesh.points)
        assert np.array_equal(one.mesh.triangles, other.mesh.triangles)
        for name, values in one.arrays.items():
            assert np.array_equal(values[order], other.arrays[name], equal_nan=True), name


def test_the_number_of_threads_does_not_matter():
    points, _ = clouds.torus(6000, np.random.default_rng(8))
    results = [surface_of(points, GenerateSurface=True, NumberOfThreads=n).bytes() for n in (1, 2, 3)]
    assert results[0] == results[1] == results[2]


def test_attributes_and_blocks_arrive():
    points, normals = clouds.sphere(2000)
    data = cloud(points, normals)
    mark = numpy_to_vtk(np.arange(2000), deep=True)
    mark.SetName("Mark")
    data.GetPointData().AddArray(mark)
    whole = run(data)
    assert np.array_equal(whole.arrays["Mark"], np.arange(2000))
    assert whole.data.GetNumberOfVerts() == 2000
    blocks = vtkMultiBlockDataSet()
    for k, part in enumerate((slice(0, 1200), slice(1200, 2000))):
        block = cloud(points[part], normals[part])
        numbers = numpy_to_vtk(np.arange(2000)[part], deep=True)
        numbers.SetName("Mark")
        block.GetPointData().AddArray(numbers)
        blocks.SetBlock(k, block)
    joined = run(blocks)
    assert np.array_equal(joined.points, whole.points)
    assert np.array_equal(joined.arrays["Mark"], whole.arrays["Mark"])


# ---- scans -------------------------------------------------------------------------------------


def test_the_kitten_becomes_watertight():
    points, normals = clouds.cgal_cloud("kitten.xyz")
    given = surface_of(points, normals, GenerateSurface=True)
    assert given.status == OK and given.number("NumberOfValidPoints") == len(points)
    assert given.number("NumberOfBorderEdges") == 0 and measures.is_closed(given.mesh)
    assert len(given.mesh.points) - len(given.mesh.triangles) / 2 == 0  # its tail makes a handle
    estimated = surface_of(points, GenerateSurface=True)
    assert measures.is_closed(estimated.mesh)
    assert measures.volume(estimated.mesh) == pytest.approx(measures.volume(given.mesh), rel=0.01)
    turned = np.einsum("ij,ij->i", estimated.arrays["Normals"], normals) < 0
    assert turned.mean() < 0.005


def test_meshes_are_closed_whatever_their_cells():
    points, normals = clouds.sphere(4000)
    for size in np.linspace(0.024, 0.1, 12):
        result = run(cloud(points, normals), GenerateSurface=True, CellSize=size)
        assert result.status == 0 and measures.is_closed(result.mesh)
        assert measures.volume(result.mesh) == pytest.approx(4 / 3 * np.pi, rel=1e-2)


@pytest.mark.parametrize("name", ["kitten.xyz", "oni.pwn"])
def test_no_triangle_of_a_scan_faces_away(name):
    """Within one cube of the oni's mesh there is a crease; filled in another way its triangles lay across it."""
    result = surface_of(*clouds.cgal_cloud(name), GenerateSurface=True)
    assert measures.is_closed(result.mesh)
    corners = result.mesh.points[result.mesh.triangles]
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = result.mesh_arrays["Normals"][result.mesh.triangles].sum(axis=1)
    lengths = np.linalg.norm(facing, axis=1) * np.linalg.norm(normals, axis=1)
    assert np.all(np.einsum("ij,ij->i", facing, normals) > 0.1 * lengths)


def test_a_terrain_stays_open():
    points, _ = clouds.cgal_cloud("radar.xyz")
    result = surface_of(points, GenerateSurface=True)
    assert result.status == OK and result.number("DoubtfulShare") < 0.01
    assert result.number("NumberOfBorderEdges") > 0
    lower, upper = points.min(axis=0), points.max(axis=0)
    margin = 2 * result.number("Width")
    assert (result.mesh.points > lower - margin).all() and (result.mesh.points < upper + margin).all()


# ---- bad input ---------------------------------------------------------------------------------


def assert_refused(result, status, *words):
    assert result.is_empty and result.status == status
    assert len(result.errors) == 1, result.errors
    for word in words:
        assert word in result.message


def test_too_few_points_are_refused():
    assert_refused(surface_of(np.zeros((0, 3))), TOO_FEW_POINTS, "six")
    assert_refused(surface_of(np.eye(3)), TOO_FEW_POINTS, "3 points")
    assert_refused(surface_of(np.ones((100, 3))), TOO_FEW_POINTS, "99 duplicates")
    assert_refused(surface_of(np.full((50, 3), np.nan)), TOO_FEW_POINTS, "50 not finite")


def test_points_on_a_line_are_refused():
    line = np.arange(100)[:, None] * np.array([[1.0, 2.0, -0.5]])
    assert_refused(surface_of(line), NO_PLANE, "line")


def test_what_is_no_cloud_is_refused():
    assert_refused(run(None), NOT_POINTS, "no data")
    assert_refused(run(vtkImageData()), NOT_POINTS, "vtkImageData")
    assert_refused(run(vtkTable()), NOT_POINTS, "Table To Points")


@pytest.mark.parametrize("name, value", [("Width", -1.0), ("Width", np.nan), ("CellSize", -2.0), ("Definition", 7)])
def test_unusable_settings_are_refused(name, value):
    assert_refused(surface_of(*clouds.sphere(500), **{name: value}), BAD_REQUEST, name)


def test_cells_that_are_too_small_are_refused():
    result = surface_of(*clouds.sphere(500), GenerateSurface=True, CellSize=1e-12)
    assert_refused(result, TOO_FINE, "CellSize")


def test_bad_points_and_duplicates_do_no_harm():
    points, normals = clouds.sphere(4000)
    good = surface_of(points, normals, GenerateSurface=True)
    bad = points.copy()
    bad[::100] = np.nan
    bad[50::100, 1] = np.inf
    worse = np.concatenate([bad, points[:300]])
    result = surface_of(worse, np.concatenate([normals, normals[:300]]), GenerateSurface=True)
    assert result.status == OK and not result.errors
    assert result.number("NumberOfBadPoints") == 80 and result.number("NumberOfDuplicates") == 294
    assert measures.is_closed(result.mesh)
    assert measures.volume(result.mesh) == pytest.approx(measures.volume(good.mesh), rel=1e-3)
    assert np.isnan(result.arrays["Residual"][0]) and result.arrays["Validity"][0] == 1


def test_outliers_stay_and_are_marked():
    rng = np.random.default_rng(9)
    points, normals = clouds.sphere(8000)
    astray = rng.uniform(2, 50, (60, 3))
    result = surface_of(
        np.concatenate([points, astray]), np.concatenate([normals, rng.normal(size=(60, 3))]), GenerateSurface=True
    )
    assert (result.arrays["Validity"][8000:] == 1).all()
    assert np.array_equal(result.points[8000:], astray)
    assert measures.is_closed(result.mesh)
    assert measures.volume(result.mesh) == pytest.approx(4 * np.pi / 3, rel=0.01)


def test_normals_without_direction_are_left_out_with_a_word():
    points, normals = clouds.sphere(4000)
    some = normals * 7.5
    some[::50] = 0
    result = surface_of(points, some, GenerateSurface=True)
    assert result.status == BAD_NORMALS and "80 points" in result.warnings[0]
    assert measures.is_closed(result.mesh)
    none = surface_of(points, np.zeros_like(normals))
    assert none.status == BAD_NORMALS and none.number("NormalsEstimated") == 1
    assert np.einsum("ij,ij->i", none.arrays["Normals"], normals).min() > 0.99


def test_normals_of_the_wrong_shape_are_not_used():
    points, normals = clouds.sphere(1000)
    data = cloud(points)
    short = numpy_to_vtk(normals[:10].copy(), deep=True)
    short.SetName("Normals")
    data.GetPointData().AddArray(short)
    result = run(data)
    assert result.number("NormalsEstimated") == 1 and "10 tuples" in result.warnings[0]
    assert np.einsum("ij,ij->i", result.arrays["Normals"], normals).min() > 0.99


def test_flipped_normals_are_reported():
    rng = np.random.default_rng(10)
    points, normals = clouds.sphere(4000)
    some = normals * np.where(rng.uniform(size=4000) < 0.1, -1, 1)[:, None]
    result = surface_of(points, some)
    assert result.number("DoubtfulShare") == pytest.approx(0.1, abs=0.02)
    flipped = np.einsum("ij,ij->i", some, normals) < 0
    assert np.array_equal(result.arrays["DoubtfulNormal"] == 1, flipped)
    mixed = surface_of(points, normals * np.where(rng.uniform(size=4000) < 0.45, -1, 1)[:, None])
    assert mixed.status == DOUBTFUL and mixed.warnings


def test_stopping_leaves_nothing_and_it_can_run_again():
    from surfacebooleans.vtk import vtkPointSetSurfaceFilter

    tested = vtkPointSetSurfaceFilter()
    tested.SetInputDataObject(0, cloud(*clouds.sphere(20000)))
    tested.GenerateSurfaceOn()
    stop = tested.AddObserver("ProgressEvent", lambda *_: tested.SetAbortExecuteAndUpdateTime())
    result = clouds.update(tested)
    assert result.is_empty and not result.errors
    tested.RemoveObserver(stop)
    tested.SetAbortExecute(0)
    tested.Modified()
    assert measures.is_closed(clouds.update(tested).mesh)
