# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Boolean: clouds of known shapes with designed bodies, against formulas."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk

import cloud_booleans
import clouds
import measures
from booleans import arrays_of, bytes_of, cells_of, points_of
from cloud_booleans import DIFFERENCE, INTERSECTION, OPERATIONS, REVERSE_DIFFERENCE, UNION, run

OK, NO_OVERLAP, COINCIDENT = 0, 40, 43
BALL = 4 / 3 * np.pi
CAP = np.pi * 0.7**2 * (3 - 0.7) / 3  # of the unit ball beyond x = 0.3
BOX = 1.7 * 16
BOX_AT = ([0.3, -2, -2], [2, 2, 2])


def volumes(a, b, both):
    return {
        UNION: a + b - both,
        INTERSECTION: both,
        DIFFERENCE: a - both,
        REVERSE_DIFFERENCE: b - both,
    }


def budget_of(result, area):
    """How far a volume may be off: the error of every place of the cloud's surface."""
    return result.number("ErrorBudget") * area


def is_sound(result):
    """Watertight by ids and by coordinates, right side out, with a seam on both surfaces."""
    assert result.status == OK and not result.errors and not result.warnings, result.message
    assert cloud_booleans.open_edges_by_id(result.surface) == 0
    assert measures.is_closed(result.body) and measures.non_manifold_edges(result.body) == 0
    assert result.number("NumberOfBorderEdges") == result.number("NumberOfSeamEnds") == 0
    assert result.number("NumberOfFlippedTriangles") == 0
    assert result.number("NumberOfSelfIntersections") == 0
    assert result.number("NumberOfBackedOffPoints") == 0
    assert result.number("SeamResidual") < 1e-9 * result.number("Spacing")
    assert result.number("ResultVolume") == pytest.approx(result.volume, rel=1e-9)
    return True


# ---- known shapes ------------------------------------------------------------------------------


def test_a_ball_and_a_box_have_the_volume_of_the_formula_and_get_nearer_to_it():
    exact = volumes(BALL, BOX, CAP)
    for operation in OPERATIONS:
        last = None
        for count in (2000, 8000, 32000):
            result = run(cloud_booleans.ball_cloud(count), cloud_booleans.box(*BOX_AT), operation)
            assert is_sound(result)
            off = abs(result.volume - exact[operation])
            assert off < budget_of(result, 4 * np.pi)
            if last is not None:
                assert 1.5 < np.log2(last / off) < 2.5  # second order in the spacing
            last = off


def test_areas_converge():
    exact = 2 * np.pi * 0.7 + np.pi * (1 - 0.3**2)  # of the cap and its disk
    off = [
        abs(run(cloud_booleans.ball_cloud(count), cloud_booleans.box(*BOX_AT), INTERSECTION).area - exact)
        for count in (2000, 8000, 32000)
    ]
    assert off[0] < 0.02 * exact
    assert off[0] > 3 * off[1] > 9 * off[2]


def test_the_seam_is_the_circle_in_which_the_ball_meets_the_box():
    result = run(cloud_booleans.ball_cloud(8000), cloud_booleans.box(*BOX_AT), DIFFERENCE)
    seam = result.seam
    assert np.abs(seam[:, 0] - 0.3).max() < 1e-12
    # A cloud on a sphere has no bias at all.
    assert np.abs(np.linalg.norm(seam, axis=1) - 1).max() < 1e-5 * result.number("Spacing")
    cells = arrays_of(result.curves.GetCellData())
    assert list(cells["Closed"]) == [1]
    radius = np.sqrt(1 - 0.3**2)
    offsets, ids = cells_of(result.curves.GetLines())
    ends = seam[ids]
    middles = (ends[1:] + ends[:-1]) / 2
    chords = radius - np.linalg.norm(middles[:, 1:], axis=1)
    # What was measured is what is there.
    assert cells["ChordError"][0] == pytest.approx(chords.max(), rel=0.02)
    assert cells["ChordError"][0] < 0.1 * result.number("Spacing")
    assert cells["Length"][0] == pytest.approx(2 * np.pi * radius, rel=1e-3)
    assert len(offsets) == 2 and ids[0] == ids[-1]


@pytest.mark.parametrize("noise", [0.0, 0.2])
@pytest.mark.parametrize("operation", OPERATIONS)
def test_a_drilled_torus(operation, noise):
    """A rod through the torus along y: a cloud of two holes."""
    rng = np.random.default_rng(2)
    points, normals = clouds.torus(10000, rng)
    spacing = np.sqrt(4 * np.pi**2 * 0.4 / 10000)
    points = points + noise * spacing * rng.normal(size=(len(points), 1)) * normals
    result = run(clouds.cloud(points, normals), cloud_booleans.rod(0.2, 4.0, 64), operation)
    assert is_sound(result)
    assert len(arrays_of(result.curves.GetCellData())["Closed"]) == 4
    torus, rod = 2 * np.pi**2 * 0.16, np.pi * 0.04 * 4
    both = drilled_out()
    exact = volumes(torus, rod, both)[operation]
    assert abs(result.volume - exact) < budget_of(result, 4 * np.pi**2 * 0.4)
    # Every point of the cloud's side is on the torus within what averaging leaves of the noise.
    side = result.body.points[np.isfinite(result.point_data["Residual"])]
    assert np.abs(clouds.distance_to_torus(side)).max() < (0.15 + 0.6 * noise) * result.number("Spacing")


def drilled_out():
    """What a rod of radius 0.2 about y takes out of the torus, by integration over its section."""
    u = (np.arange(2000) + 0.5) / 1000 - 1
    x, z = np.meshgrid(0.2 * u, 0.2 * u)
    inside = (x**2 + z**2 < 0.04) & (np.abs(z) < 0.4)
    x, z = x[inside], z[inside]
    half = np.sqrt(0.16 - z**2)
    far, near = np.sqrt((1 + half) ** 2 - x**2), np.sqrt((1 - half) ** 2 - x**2)
    return 2 * np.sum(far - near) * (0.4 / 2000) ** 2


def test_a_ball_and_a_finely_tessellated_ball():
    tool = cloud_booleans.ball([0.9, 0, 0], 0.7, 120)
    for operation in OPERATIONS:
        result = run(cloud_booleans.ball_cloud(8000), tool, operation)
        assert result.status == OK and measures.is_closed(result.body)
        assert result.number("NumberOfFlippedTriangles") == 0
        distance, big, small = 0.9, 1.0, 0.7
        lens = (
            np.pi
            * (big + small - distance) ** 2
            * (distance**2 + 2 * distance * (big + small) - 3 * (big - small) ** 2)
            / (12 * distance)
        )
        exact = volumes(BALL, result.number("ToolVolume"), lens)[operation]
        assert abs(result.volume - exact) < budget_of(result, 4 * np.pi) + 0.002


def random_body(rng, size, at):
    """A ball, a box, a slender prism or a flat drum, turned anyhow."""
    r = size * rng.uniform(0.04, 0.25)
    makers = [
        lambda: cloud_booleans.ball([0, 0, 0], r, 4 * int(rng.integers(4, 20))),
        lambda: cloud_booleans.box(-r * rng.uniform(0.3, 1, 3), r * rng.uniform(0.3, 1, 3)),
        lambda: cloud_booleans.rod(r * rng.uniform(0.2, 1), 2 * r, int(rng.integers(3, 60))),
        lambda: cloud_booleans.rod(r, r * rng.uniform(0.2, 1), int(rng.integers(20, 200))),
    ]
    return cloud_booleans.placed(makers[rng.integers(4)](), at, rng.uniform(0, 360), rng.normal(size=3))


def test_random_bodies_anywhere_at_a_cloud():
    """Creases that graze the cloud and facets that nearly lie in it included: nothing turns over, nothing crosses,
    and hardly a point of the seam is off."""
    rng = np.random.default_rng(8)
    points, normals = clouds.torus(8000, rng)
    spacing = np.sqrt(4 * np.pi**2 * 0.4 / 8000)
    noisy = points + 0.2 * spacing * rng.normal(size=(len(points), 1)) * normals
    scans = [(noisy, normals), clouds.sphere(6000), clouds.cgal_cloud("kitten.xyz")]
    staying = seams = 0
    for trial in range(36):
        where, turned = scans[trial % 3]
        size = np.linalg.norm(np.ptp(where, axis=0))
        at = where[rng.integers(len(where))] + 0.05 * size * rng.normal(size=3)
        result = run(clouds.cloud(where, turned), random_body(rng, size, at), OPERATIONS[trial % 4])
        assert not result.errors and measures.is_closed(result.body), trial
        assert result.number("NumberOfFlippedTriangles") == result.number("NumberOfSelfIntersections") == 0, trial
        assert result.number("NumberOfBorderEdges") == result.number("NumberOfSeamEnds") == 0, trial
        assert result.status in (OK, NO_OVERLAP, COINCIDENT), (trial, result.message)
        assert result.number("SeamResidual") <= 0.5 * result.number("ErrorBudget"), trial
        staying += result.number("NumberOfBackedOffPoints") > 0
        seams += result.number("NumberOfSnappedPoints") > 0
    assert seams >= 30 and staying <= 2


def test_volumes_of_union_and_intersection_add_up():
    cloud, tool = cloud_booleans.ball_cloud(8000), cloud_booleans.box(*BOX_AT)
    results = {operation: run(cloud, tool, operation) for operation in OPERATIONS}
    a, b = results[UNION].number("CloudVolume"), results[UNION].number("ToolVolume")
    v = {operation: result.volume for operation, result in results.items()}
    # Only near the seam there are other chords: within a cell on both sides, along its length.
    rim = 4 * np.pi * results[UNION].number("CellSize") * results[UNION].number("ErrorBudget")
    assert abs(v[UNION] + v[INTERSECTION] - a - b) < rim
    assert abs(v[DIFFERENCE] + v[INTERSECTION] - a) < rim
    assert abs(v[REVERSE_DIFFERENCE] + v[INTERSECTION] - b) < rim


# ---- what comes out ----------------------------------------------------------------------------


@pytest.mark.parametrize("operation", OPERATIONS)
def test_triangles_face_the_way_the_surfaces_do(operation):
    result = run(cloud_booleans.ball_cloud(8000), cloud_booleans.box(*BOX_AT), operation)
    source, original = result.cell_data["SourceId"], result.cell_data["OriginalCellId"]
    middles = result.body.points[result.body.triangles].mean(axis=1)
    of_cloud = np.flatnonzero(source == 0)
    turned = -1 if operation == REVERSE_DIFFERENCE else 1
    outwards = turned * middles[of_cloud] / np.linalg.norm(middles[of_cloud], axis=1)[:, None]
    assert cloud_booleans.facing(result, of_cloud, outwards).min() > 0
    assert np.all(original[of_cloud] == -1)
    of_tool = np.flatnonzero(source == 1)
    assert np.all((original[of_tool] >= 0) & (original[of_tool] < 6))
    # The cube's cells are at -x, +x, -y, +y, -z, +z.
    axis, side = original[of_tool] // 2, 2 * (original[of_tool] % 2) - 1
    faces = np.zeros((len(of_tool), 3))
    faces[np.arange(len(of_tool)), axis] = side * (-1 if operation == DIFFERENCE else 1)
    assert cloud_booleans.facing(result, of_tool, faces).min() > 0.999
    assert np.all(result.cell_data["Confidence"] == 1)


def test_normals_and_residuals():
    result = run(cloud_booleans.ball_cloud(8000), cloud_booleans.box(*BOX_AT), DIFFERENCE)
    residual, normals = result.point_data["Residual"], result.point_data["Normals"]
    on_cloud = np.isfinite(residual)
    assert np.allclose(np.linalg.norm(normals, axis=1), 1)
    outwards = result.body.points / np.linalg.norm(result.body.points, axis=1)[:, None]
    assert np.einsum("ij,ij->i", normals, outwards)[on_cloud].min() > 0.999
    assert np.abs(residual[on_cloud]).max() < 1e-9
    assert np.all(result.body.points[~on_cloud][:, 0] > 0.3 - 1e-12)  # the disk, without its rim
    seam = result.point_data["SeamPoint"] == 1
    assert np.count_nonzero(seam) == len(result.seam)
    assert np.all(on_cloud[seam])


def test_attributes_of_the_cloud_are_carried():
    points, normals = clouds.sphere(8000)
    cloud = clouds.cloud(points, normals)
    for name, values in (("Height", points[:, 2].copy()), ("Number", np.arange(len(points)))):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        cloud.GetPointData().AddArray(array)
    result = run(cloud, cloud_booleans.box(*BOX_AT), UNION)
    height, number = result.point_data["Height"], result.point_data["Number"]
    on_cloud = np.isfinite(result.point_data["Residual"])
    places = result.body.points
    apart = np.linalg.norm(places[on_cloud, None] - points[number[on_cloud]][:, None], axis=2)
    assert apart.max() < result.number("Spacing")
    assert np.array_equal(height[on_cloud], points[number[on_cloud], 2])
    assert np.all(np.isnan(height[~on_cloud])) and np.all(number[~on_cloud] == 0)


@pytest.mark.parametrize("operation", OPERATIONS)
def test_points_are_those_left_of_the_cloud_and_the_seam(operation):
    points, normals = clouds.sphere(8000)
    result = run(clouds.cloud(points, normals), cloud_booleans.box(*BOX_AT), operation)
    arrays = arrays_of(result.points.GetPointData())
    inside = points[:, 0] > 0.3
    kept = np.flatnonzero(inside == (operation in (INTERSECTION, REVERSE_DIFFERENCE)))
    seam = arrays["SeamPoint"] == 1
    assert np.array_equal(arrays["OriginalPointId"][~seam], kept)
    assert np.array_equal(points_of(result.points)[~seam], points[kept])
    assert np.allclose(arrays["Normals"][~seam], normals[kept])
    assert np.all(arrays["OriginalPointId"][seam] == -1)
    assert np.array_equal(points_of(result.points)[seam], result.seam)
    assert result.points.GetNumberOfVerts() == len(seam)


# ---- what must not matter ----------------------------------------------------------------------


def test_neither_threads_nor_the_order_of_the_points_matter():
    rng = np.random.default_rng(3)
    points, normals = clouds.torus(5000, rng)
    points += 0.005 * rng.normal(size=(len(points), 1)) * normals
    tool = cloud_booleans.rod(0.2, 4.0, 50)
    order = rng.permutation(len(points))
    one = run(clouds.cloud(points, normals), tool, UNION, NumberOfThreads=1)
    three = run(clouds.cloud(points, normals), tool, UNION, NumberOfThreads=3)
    other = run(clouds.cloud(points[order], normals[order]), tool, UNION)
    assert bytes_of(one.surface, one.points, one.curves) == bytes_of(three.surface, three.points, three.curves)
    assert bytes_of(one.surface, one.curves) == bytes_of(other.surface, other.curves)


def test_coordinates_far_from_the_origin_cost_digits_only():
    points, normals = clouds.sphere(4000)
    here = run(clouds.cloud(points, normals), cloud_booleans.box(*BOX_AT), DIFFERENCE)
    lower, upper = (np.array(corner) + 1e6 for corner in BOX_AT)
    away = run(clouds.cloud(points + 1e6, normals), cloud_booleans.box(lower, upper), DIFFERENCE)
    assert away.status == OK and measures.is_closed(away.body)
    assert away.number("ResultVolume") == pytest.approx(here.number("ResultVolume"), rel=1e-6)
    assert away.number("SeamResidual") < 1e-8 and away.number("NumberOfFlippedTriangles") == 0


def test_a_tool_that_is_inside_out_is_turned_with_a_warning():
    tool = cloud_booleans.box(*BOX_AT)
    tool.GetPolys().ReverseCellAtId(0)
    for cell in range(1, 6):
        tool.GetPolys().ReverseCellAtId(cell)
    result = run(cloud_booleans.ball_cloud(4000), tool, INTERSECTION)
    assert result.status == 46 and len(result.warnings) == 1
    assert result.volume == pytest.approx(CAP, rel=0.02)


# ---- attributes of the tool --------------------------------------------------------------------


@pytest.mark.parametrize("operation", OPERATIONS)
def test_arrays_of_the_tool_are_carried(operation):
    tool = cloud_booleans.box(*BOX_AT)
    corners = points_of(tool)
    named(tool.GetPointData(), "Height", corners[:, 1] + 3 * corners[:, 2])  # linear: interpolation is exact
    named(tool.GetPointData(), "Shared", np.full(len(corners), 7.0))
    named(tool.GetCellData(), "Part", np.arange(10, 16, dtype=np.int32))
    cloud = cloud_booleans.ball_cloud(4000)
    named(cloud.GetPointData(), "Shared", np.full(4000, 5.0))
    result = run(cloud, tool, operation)
    assert is_sound(result)
    source, part = result.cell_data["SourceId"], result.cell_data["Part"]
    assert np.array_equal(part[source == 1], result.cell_data["OriginalCellId"][source == 1] + 10)
    assert np.all(part[source == 0] == 0)
    x, height = result.body.points, result.point_data["Height"]
    of_tool = np.isin(np.arange(len(x)), result.body.triangles[source == 1])
    assert of_tool.sum() > 100 and np.isnan(height[~of_tool]).all()
    assert np.abs(height[of_tool] - (x[of_tool, 1] + 3 * x[of_tool, 2])).max() < 1e-9
    of_cloud = np.isin(np.arange(len(x)), result.body.triangles[source == 0])
    assert np.all(result.point_data["Shared"] == np.where(of_cloud, 5.0, 7.0))
    assert result.surface.GetPointData().GetTCoords() is None  # of which the cloud has none


def test_an_array_that_cannot_be_carried_is_told():
    tool, cloud = cloud_booleans.box(*BOX_AT), cloud_booleans.ball_cloud(2000)
    named(tool.GetPointData(), "Shared", np.zeros((tool.GetNumberOfPoints(), 2)))
    named(cloud.GetPointData(), "Shared", np.zeros(2000))
    result = run(cloud, tool, DIFFERENCE)
    assert result.status == OK and len(result.warnings) == 1 and "'Shared' of Tool" in result.warnings[0]


def named(attributes, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    attributes.AddArray(array)


# ---- updates after the first -------------------------------------------------------------------


def test_moving_the_tool_does_not_prepare_the_cloud_again():
    from surfacebooleans.vtk import vtkPointSetBooleanFilter

    def seconds(result):
        times = dict(zip(result.field_data["StageNames"], result.field_data["StageSeconds"]))
        return times["Prepare cloud"] + times["Mesh cloud"]

    cloud = cloud_booleans.ball_cloud(60000)
    tested = vtkPointSetBooleanFilter()
    tested.SetInputDataObject(0, cloud)
    tested.SetInputDataObject(1, cloud_booleans.box(*BOX_AT))
    first = cloud_booleans.update(tested)
    moved = cloud_booleans.box([0.35, -2, -2], [2, 2, 2])
    tested.SetInputDataObject(1, moved)
    second = cloud_booleans.update(tested)
    assert seconds(second) < 0.1 * seconds(first)
    assert outputs_of(second) == outputs_of(run(cloud, moved))
    # Other arrays on the same points are carried, and are no reason to begin anew.
    array = numpy_to_vtk(np.arange(60000.0), deep=True)
    array.SetName("Number")
    cloud.GetPointData().AddArray(array)
    third = cloud_booleans.update(tested)
    assert seconds(third) < 0.1 * seconds(first) and "Number" in third.point_data
    # Moved points, other normals and other settings are.
    cloud.GetPoints().GetData().SetComponent(0, 0, 1.5)
    cloud.GetPoints().Modified()
    assert seconds(cloud_booleans.update(tested)) > 0.3 * seconds(first)
    cloud.GetPointData().GetNormals().Modified()
    assert seconds(cloud_booleans.update(tested)) > 0.3 * seconds(first)
    tested.SetWidth(4 * first.number("Spacing"))
    assert cloud_booleans.update(tested).number("Width") == pytest.approx(4 * first.number("Spacing"))


def outputs_of(result):
    return bytes_of(result.surface, result.points, result.curves)
