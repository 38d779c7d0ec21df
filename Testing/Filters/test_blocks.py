# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Composite data on any port: merged, with an array that says which block everything came from, and the blocks' names."""

import numpy as np
import pytest
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkMultiBlockDataSet,
    vtkMultiPieceDataSet,
    vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection,
    vtkPlane,
    vtkPlaneCollection,
    vtkPolyData,
)

import clouds
import meshes
from booleans import arrays_of, heard_from, points_of, polydata
from surfacebooleans.vtk import (
    vtkPointSetBooleanFilter,
    vtkPointSetIntersectionFilter,
    vtkPointSetSurfaceFilter,
    vtkPolyDataBooleanOperationFilter,
    vtkPolyDataClipClosedSurface,
    vtkPolyDataContourTriangulator,
    vtkPolyDataCutClosedSurface,
    vtkPolyDataDistance,
    vtkPolyDataDistanceField,
    vtkPolyDataIntersection,
    vtkPolyDataSurfaceCheck,
)

COMPOSITES = (vtkMultiBlockDataSet, vtkPartitionedDataSetCollection)
NAMES = ["left", "right"]
OF_NONE = -1


def grouped(kind, parts, names):
    """Composite data of named parts."""
    group = kind()
    if kind is vtkMultiBlockDataSet:
        group.SetNumberOfBlocks(len(parts))
    for k, (part, name) in enumerate(zip(parts, names)):
        if kind is vtkMultiBlockDataSet:
            group.SetBlock(k, part)
        else:
            partition = vtkPartitionedDataSet()
            partition.SetPartition(0, part)
            group.SetPartitionedDataSet(k, partition)
        if name is not None:
            group.GetMetaData(k).Set(vtkCompositeDataSet.NAME(), name)
    return group


def box(x, y=0, z=0):
    return polydata(meshes.box((x, y, z), (x + 2, y + 2, z + 2)))


def boxes(kind, y=0, z=0, names=NAMES):
    """Two cubes, the right one at x = 10."""
    return grouped(kind, [box(0, y, z), box(10, y, z)], names)


def balls(kind):
    """Two scanned balls, the right one at x = 10."""
    points, normals = clouds.sphere(3000)
    return grouped(kind, [clouds.cloud(points + [x, 0, 0], normals) for x in (0, 10)], NAMES)


def updated(tested, *inputs):
    for port, data in enumerate(inputs):
        tested.SetInputDataObject(port, data)
    errors, _ = heard_from(tested)
    assert not errors
    return tested


def names_in(data):
    return arrays_of(data.GetFieldData()).get("BlockNames")


def middles(data):
    """The x of each cell's middle."""
    places = points_of(data)
    return np.array(
        [
            places[[data.GetCell(i).GetPointId(k) for k in range(data.GetCell(i).GetNumberOfPoints())], 0].mean()
            for i in range(data.GetNumberOfCells())
        ]
    )


def assert_blocks_by_place(data, numbers, first=0):
    """What is on the left is of the first block, what is on the right of the second one."""
    assert len(numbers) == data.GetNumberOfCells() > 0
    assert np.array_equal(numbers, first + (middles(data) > 6))


@pytest.mark.parametrize("kind", COMPOSITES)
def test_boolean_numbers_the_blocks_of_both_ports_through(kind):
    tested = updated(
        vtkPolyDataBooleanOperationFilter(), boxes(kind), boxes(kind, 1, 1, ["drill", None]), 
    )
    result = tested.GetOutput()
    assert names_in(result) == ["left", "right", "drill", "Block 1"]
    cells = arrays_of(result.GetCellData())
    for source in (0, 1):
        mine = cells["SourceId"] == source
        assert np.array_equal(cells["BlockId"][mine], 2 * source + (middles(result)[mine] > 6))


@pytest.mark.parametrize("kind", COMPOSITES)
def test_a_surface_beside_blocks_is_of_none(kind):
    tested = vtkPolyDataBooleanOperationFilter()
    tested.SetOperationToDifference()
    result = updated(tested, box(10, 1, 1), boxes(kind)).GetOutput()
    cells = arrays_of(result.GetCellData())
    assert names_in(result) == NAMES
    assert set(cells["BlockId"][cells["SourceId"] == 0]) == {OF_NONE}
    assert set(cells["BlockId"][cells["SourceId"] == 1]) == {1}


def test_names_live_through_a_second_boolean():
    first = updated(vtkPolyDataBooleanOperationFilter(), boxes(vtkMultiBlockDataSet), box(0, 1, 1)).GetOutput()
    chained = updated(vtkPolyDataBooleanOperationFilter(), boxes(vtkMultiBlockDataSet, 1, 0, ["up", "down"]), first).GetOutput()
    assert names_in(chained) == ["up", "down", "left", "right"]
    cells = arrays_of(chained.GetCellData())
    of_first = cells["BlockId"][cells["SourceId"] == 1]
    assert set(of_first) == {OF_NONE, 2, 3}
    assert set(cells["BlockId"][cells["SourceId"] == 0]) == {0, 1}


def test_nested_empty_and_partitioned_blocks():
    inner = grouped(vtkMultiBlockDataSet, [box(0), None, box(10)], ["case", "lid", "foot"])
    bolts, parts = vtkMultiPieceDataSet(), vtkPartitionedDataSet()
    for k in (0, 1):
        bolts.SetPiece(k, box(20 + 10 * k))
        parts.SetPartition(k, box(20 + 10 * k))
    outer = grouped(vtkMultiBlockDataSet, [inner, bolts], ["pump", "bolts"])
    result = updated(vtkPolyDataSurfaceCheck(), outer).GetOutput()
    assert names_in(result) == ["pump/case", "pump/lid", "pump/foot", "bolts"]
    assert np.bincount(arrays_of(result.GetCellData())["BlockId"]).tolist() == [12, 0, 12, 24]
    result = updated(vtkPolyDataSurfaceCheck(), parts).GetOutput()
    assert names_in(result) is None and "BlockId" not in arrays_of(result.GetCellData()), "parts of one thing"


def test_a_renamed_block_and_one_that_vanishes_keep_the_others_numbers():
    group = boxes(vtkMultiBlockDataSet)
    tested = updated(vtkPolyDataSurfaceCheck(), group)
    group.GetMetaData(0).Set(vtkCompositeDataSet.NAME(), "middle")
    group.Modified()
    assert names_in(updated(tested, group).GetOutput()) == ["middle", "right"]
    group.SetBlock(0, None)
    result = updated(tested, group).GetOutput()
    assert len(names_in(result)) == 2 and names_in(result)[1] == "right"
    assert set(arrays_of(result.GetCellData())["BlockId"]) == {1}


@pytest.mark.parametrize("kind", COMPOSITES)
def test_intersection_marks_both_cut_surfaces(kind):
    tested = updated(vtkPolyDataIntersection(), boxes(kind), boxes(kind, 1, 1, ["up", "down"]))
    for port, first in ((1, 0), (2, 2)):
        split = tested.GetOutputDataObject(port)
        assert names_in(split) == [*NAMES, "up", "down"]
        assert_blocks_by_place(split, arrays_of(split.GetCellData())["BlockId"], first)


@pytest.mark.parametrize("kind", COMPOSITES)
def test_distance_keeps_the_blocks_of_input_and_marks_those_of_tool(kind):
    tested = vtkPolyDataDistance()
    tested.SetComputeSecondDistance(1)
    updated(tested, boxes(kind), boxes(kind, 1, 1, ["up", "down"]))
    output, second = tested.GetOutputDataObject(0), tested.GetOutputDataObject(1)
    assert isinstance(output, kind)
    assert [output.GetMetaData(k).Get(vtkCompositeDataSet.NAME()) for k in (0, 1)] == NAMES
    assert names_in(second) == ["up", "down"]
    assert_blocks_by_place(second, arrays_of(second.GetCellData())["BlockId"])


@pytest.mark.parametrize("kind", COMPOSITES)
def test_the_distance_field_is_that_of_all_blocks(kind):
    field = updated(vtkPolyDataDistanceField(), boxes(kind)).GetOutput()
    inside = arrays_of(field.GetPointData())["Distance"].reshape(-1) < 0
    x = np.array([field.GetPoint(i)[0] for i in np.flatnonzero(inside)])
    assert np.any(x < 2) and np.any(x > 10) and not np.any((x > 2.01) & (x < 9.99))


@pytest.mark.parametrize("kind", COMPOSITES)
def test_check_marks_its_surface(kind):
    result = updated(vtkPolyDataSurfaceCheck(), boxes(kind)).GetOutput()
    assert names_in(result) == NAMES
    assert_blocks_by_place(result, arrays_of(result.GetCellData())["BlockId"])


@pytest.mark.parametrize("kind", COMPOSITES)
def test_clip_marks_its_surface_and_its_caps(kind):
    plane, planes = vtkPlane(), vtkPlaneCollection()
    plane.SetOrigin(1, 1, 1)
    plane.SetNormal(0, 0, 1)
    planes.AddItem(plane)
    tested = vtkPolyDataClipClosedSurface()
    tested.SetClippingPlanes(planes)
    result = updated(tested, boxes(kind)).GetOutput()
    assert names_in(result) == NAMES
    assert set(arrays_of(result.GetCellData())["SourceId"]) == {0, 1}
    assert_blocks_by_place(result, arrays_of(result.GetCellData())["BlockId"])


@pytest.mark.parametrize("kind", COMPOSITES)
@pytest.mark.parametrize("triangles", (0, 1))
def test_cut_marks_its_caps(kind, triangles):
    tested = vtkPolyDataCutClosedSurface()
    tested.SetOrigin(1, 1, 1)
    tested.SetTriangulate(triangles)
    result = updated(tested, boxes(kind)).GetOutput()
    assert names_in(result) == NAMES
    assert_blocks_by_place(result, arrays_of(result.GetCellData())["BlockId"])


@pytest.mark.parametrize("kind", COMPOSITES)
def test_contours_are_filled_block_by_block(kind):
    """Slices come as blocks, each in a plane of its own, so they are not merged; their names stay where they are."""
    slices = []
    for z in (0.5, 1.5):
        tested = vtkPolyDataCutClosedSurface()
        tested.SetOrigin(1, 1, z)
        tested.SetTriangulate(0)
        slices.append(updated(tested, box(0)).GetOutput())
    filled = updated(vtkPolyDataContourTriangulator(), grouped(kind, slices, ["low", "high"])).GetOutputDataObject(0)
    assert isinstance(filled, kind)
    assert [filled.GetMetaData(k).Get(vtkCompositeDataSet.NAME()) for k in (0, 1)] == ["low", "high"]
    for k, z in enumerate((0.5, 1.5)):
        part = filled.GetBlock(k) if kind is vtkMultiBlockDataSet else filled.GetPartition(k, 0)
        assert part.GetNumberOfCells() > 0 and set(points_of(part)[:, 2]) == {z}
        assert arrays_of(part.GetFieldData())["Status"][0] == 0


def assert_points_by_place(data):
    numbers = arrays_of(data.GetPointData())["BlockId"]
    assert names_in(data) == NAMES
    assert np.array_equal(numbers, points_of(data)[:, 0] > 6)


@pytest.mark.parametrize("kind", COMPOSITES)
def test_the_points_of_a_cloud_are_marked(kind):
    tested = vtkPointSetSurfaceFilter()
    tested.SetGenerateSurface(1)
    updated(tested, balls(kind))
    assert_points_by_place(tested.GetOutputDataObject(0))


@pytest.mark.parametrize("kind", COMPOSITES)
def test_curves_of_clouds_and_bodies_in_blocks(kind):
    tools = grouped(kind, [box(0), box(10)], ["up", "down"])
    curves = updated(vtkPointSetIntersectionFilter(), balls(kind), tools).GetOutput()
    assert names_in(curves) == ["up", "down"]
    numbers = arrays_of(curves.GetPointData())["BlockId"]
    assert np.array_equal(numbers, points_of(curves)[:, 0] > 6) and set(numbers) == {0, 1}


@pytest.mark.parametrize("kind", COMPOSITES)
def test_the_boolean_of_a_cloud_marks_points_by_cloud_and_cells_by_body(kind):
    tools = grouped(kind, [box(0), box(10)], ["up", "down"])
    tested = vtkPointSetBooleanFilter()
    tested.SetOperation(2)
    updated(tested, balls(kind), tools)
    surface, points = tested.GetOutputDataObject(0), tested.GetOutputDataObject(1)
    assert names_in(surface) == names_in(points) == [*NAMES, "up", "down"]
    cells, of_points = arrays_of(surface.GetCellData()), arrays_of(surface.GetPointData())
    of_tool = cells["SourceId"] == 1
    assert np.array_equal(cells["BlockId"][of_tool], 2 + (middles(surface)[of_tool] > 6))
    assert set(cells["BlockId"][~of_tool]) == {OF_NONE}
    known = of_points["BlockId"] >= 0
    assert np.array_equal(of_points["BlockId"][known], points_of(surface)[known, 0] > 6) and known.sum() > 1000
