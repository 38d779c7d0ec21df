# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What vtkPolyDataBooleanOperationFilter promises around the computation: its settings, what it reads, which arrays it
carries and how, and what it says of input that it cannot use."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_FLOAT, VTK_INT, VTK_SHORT, VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection,
    vtkPolyData,
    vtkTable,
)
from vtkmodules.vtkFiltersSources import vtkCubeSource

import booleans
import measures
import meshes
from booleans import (
    DIFFERENCE,
    INTERSECTION,
    RESOLVE,
    SET_OPERATIONS,
    SYMMETRIC_DIFFERENCE,
    UNION,
    boolean,
    cells_of,
    points_of,
    polydata,
)
from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter

# Two cubes of side 2 that overlap in a cube of side 1; every coordinate is exact.
CUBE_POINTS = np.array([[x, y, z] for z in (0, 2) for y in (0, 2) for x in (0, 2)], dtype=float)
CUBE_QUADS = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
VOLUMES = {UNION: 15, INTERSECTION: 1, DIFFERENCE: 7, SYMMETRIC_DIFFERENCE: 14, RESOLVE: 15}


def quads(at=(0.0, 0.0, 0.0), side=2.0):
    """A cube as six quadrilaterals over eight points."""
    points = CUBE_POINTS * (side / 2) + np.asarray(at, dtype=float)
    return polydata(meshes.mesh(points, []), CUBE_QUADS)


def with_arrays(data, point=None, cell=None):
    for attributes, arrays in ((data.GetPointData(), point), (data.GetCellData(), cell)):
        for name, values in (arrays or {}).items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            attributes.AddArray(array)
    return data


def cube_with_normals(center, side=2.0):
    """VTK's own cube: 24 points, three normals and three texture coordinates a corner."""
    source = vtkCubeSource()
    source.SetCenter(*center)
    source.SetXLength(side), source.SetYLength(side), source.SetZLength(side)
    source.Update()
    return source.GetOutput()


def ids_array(values):
    return numpy_to_vtkIdTypeArray(np.asarray(values, dtype=np.int64), deep=True)


def facing(data, arrays="point"):
    """For each cell, its normal from its corners times its `Normals`."""
    offsets, ids = cells_of(data.GetPolys())
    corners = points_of(data)[ids]
    result = []
    for cell, (begin, end) in enumerate(zip(offsets[:-1], offsets[1:])):
        a, b, c = corners[begin : begin + 3]
        normal = np.cross(b - a, c - a)
        given = data.GetPointData().GetArray("Normals") if arrays == "point" else data.GetCellData().GetArray("Normals")
        rows = ids[begin:end] if arrays == "point" else [cell]
        result += [normal @ vtk_to_numpy(given)[row] / np.linalg.norm(normal) for row in rows]
    return np.array(result)


# ---- settings ---------------------------------------------------------------------------------------


def test_the_defaults_are_those_of_the_source_document():
    tested = vtkPolyDataBooleanOperationFilter()
    assert tested.GetOperation() == tested.VTK_UNION == 0
    assert tested.GetReorientDifferenceCells() == 1
    assert tested.GetTolerance() == 0.0
    assert tested.GetNumberOfThreads() == 0
    assert tested.GetNumberOfInputPorts() == 2 and tested.GetNumberOfOutputPorts() == 2


def test_every_operation_has_its_setter_and_its_number():
    tested = vtkPolyDataBooleanOperationFilter()
    for number, name in enumerate((UNION, INTERSECTION, DIFFERENCE, SYMMETRIC_DIFFERENCE, RESOLVE)):
        getattr(tested, "SetOperationTo" + name)()
        assert tested.GetOperation() == number
        tested.SetOperation(number)
        assert tested.GetOperation() == number


def test_switches_have_on_and_off_and_threads_are_never_negative():
    tested = vtkPolyDataBooleanOperationFilter()
    tested.ReorientDifferenceCellsOff()
    assert tested.GetReorientDifferenceCells() == 0
    tested.ReorientDifferenceCellsOn()
    assert tested.GetReorientDifferenceCells() == 1
    tested.SetNumberOfThreads(-3)
    assert tested.GetNumberOfThreads() == 0


@pytest.mark.parametrize("operation", VOLUMES)
def test_the_field_data_tell_what_was_done(operation):
    first = quads()
    note = vtkStringArray()
    note.SetName("Author")
    note.InsertNextValue("a field of the input")
    first.GetFieldData().AddArray(note)
    result = boolean([first], [quads((1, 1, 1))], operation)
    fields = result.field_data
    assert fields["Author"] == ["a field of the input"]
    assert result.status == 0 and result.message == "The result is complete."
    assert fields["OperandVolume"].tolist() == [8, 8] and fields["OperandArea"].tolist() == [24, 24]
    assert fields["ResultVolume"][0] == pytest.approx(VOLUMES[operation], rel=1e-14)
    assert fields["ResultVolume"][0] == pytest.approx(result.volume, rel=1e-12)
    assert fields["ResultArea"][0] == pytest.approx(result.area, rel=1e-12)
    assert fields["ContactCount"][0] > 0
    assert len(fields["StageNames"]) == len(fields["StageSeconds"]) > 2
    assert all(0 <= seconds < 10 for seconds in fields["StageSeconds"])


def test_the_tool_has_its_own_methods():
    tested = vtkPolyDataBooleanOperationFilter()
    tested.SetInputData(quads())
    tested.SetToolData(quads((1, 1, 1)))
    tested.AddToolData(quads((-1, -1, -1)))
    tested.SetOperationToDifference()
    assert tested.GetNumberOfInputConnections(1) == 2
    assert booleans.update(tested).volume == pytest.approx(6)
    tested.RemoveAllTools()
    assert tested.GetNumberOfInputConnections(1) == 0
    tested.SetOperationToUnion()
    assert booleans.update(tested).volume == pytest.approx(8)


def test_several_inputs_and_tools_are_united_and_counted_through():
    result = boolean([quads(), quads((1, 0, 0))], [quads((0.5, 1, -1)), quads((0.5, 1, 1))], DIFFERENCE)
    assert result.volume == pytest.approx(3 * 2 * 2 - 2 * 1 * 2)
    assert set(result.cell_data["SourceId"]) == {0, 1, 2, 3}
    assert measures.open_edges(result.body) == 0


# ---- cells and where they come from -----------------------------------------------------------------


@pytest.mark.parametrize("operation", SET_OPERATIONS)
def test_every_cell_lies_in_the_cell_that_it_names(operation):
    operands = [quads(), quads((1, 1, 1))]
    result = boolean(operands[:1], operands[1:], operation)
    offsets, ids = cells_of(result.surface.GetPolys())
    points = points_of(result.surface)
    for cell, (begin, end) in enumerate(zip(offsets[:-1], offsets[1:])):
        source = int(result.cell_data["SourceId"][cell])
        corners = points_of(operands[source])[CUBE_QUADS[int(result.cell_data["OriginalCellId"][cell])]]
        axis = int(np.flatnonzero(np.ptp(corners, axis=0) == 0)[0])
        assert np.all(points[ids[begin:end], axis] == corners[0, axis])
        assert np.all(points[ids[begin:end]] >= corners.min(axis=0))
        assert np.all(points[ids[begin:end]] <= corners.max(axis=0))


def test_untouched_polygons_stay_whole_and_in_order():
    bite = quads((1.5, 0.5, 0.5), side=1.0)  # through the face x = 2 alone
    result = boolean([quads()], [bite], DIFFERENCE)
    offsets, ids = cells_of(result.surface.GetPolys())
    whole = [cell for cell in range(len(offsets) - 1) if offsets[cell + 1] - offsets[cell] == 4]
    ours = [cell for cell in whole if result.cell_data["SourceId"][cell] == 0]
    assert result.cell_data["OriginalCellId"][ours].tolist() == [0, 1, 2, 3, 4]
    points = points_of(result.surface)
    for cell in ours:
        corners = points[ids[offsets[cell] : offsets[cell + 1]]]
        assert corners.tolist() == CUBE_POINTS[CUBE_QUADS[result.cell_data["OriginalCellId"][cell]]].tolist()
    # The bite's bottom is untouched too; a difference turns it over, its first corner in place.
    theirs = [cell for cell in whole if result.cell_data["SourceId"][cell] == 1]
    assert result.cell_data["OriginalCellId"][theirs].tolist() == [4]
    corners = points[ids[offsets[theirs[0]] : offsets[theirs[0] + 1]]]
    wanted = points_of(bite)[np.array(CUBE_QUADS[4])[[0, 3, 2, 1]]]
    assert corners.tolist() == wanted.tolist()
    assert result.volume == pytest.approx(8 - 0.5)


def test_points_that_nothing_touches_keep_their_bytes():
    body, tool = meshes.sphere(radius=1.0), meshes.moved(meshes.sphere(radius=1.0), (0.7, 0.1, 0.2))
    result = boolean([body], [tool], UNION)
    kept = {row.tobytes() for row in np.concatenate([body.points, tool.points])}
    offsets, ids = cells_of(result.surface.GetPolys())
    points = points_of(result.surface)
    seam = {row.tobytes() for row in points_of(result.curves)}
    assert all(row.tobytes() in kept | seam for row in points[ids])
    assert sum(row.tobytes() in kept for row in points) > len(points) / 2


def test_polygons_of_any_shape_are_read_right():
    # A prism over a C, its caps as one polygon of eight corners that is not convex.
    outline = np.array([[0, 0], [3, 0], [3, 1], [1, 1], [1, 2], [3, 2], [3, 3], [0, 3]], dtype=float)
    points = np.concatenate([np.c_[outline, np.zeros(8)], np.c_[outline, np.ones(8)]])
    sides = [[k, (k + 1) % 8, (k + 1) % 8 + 8, k + 8] for k in range(8)]
    prism = polydata(meshes.mesh(points, []), [list(range(7, -1, -1)), list(range(8, 16)), *sides])
    alone = boolean([prism], [], UNION)
    assert alone.field_data["OperandVolume"][0] == pytest.approx(7, rel=1e-14)
    assert alone.surface.GetNumberOfCells() == 10  # all polygons whole
    slit = quads((2, -1, -1), side=5.0)
    cut = boolean([prism], [slit], DIFFERENCE)
    assert cut.volume == pytest.approx(7 - 2, rel=1e-14)
    assert measures.open_edges(cut.body) == 0


def random_star(rng, corners):
    """A polygon on whole numbers that goes once round the origin, in and out: rarely convex, some corners on a line."""
    steps = np.sort(rng.choice(64, corners, replace=False)) * (2 * np.pi / 64)
    radii = rng.integers(300, 1000, corners)
    outline = np.round(np.c_[radii * np.cos(steps), radii * np.sin(steps)])
    middle = rng.integers(corners)
    between = (outline[middle] + np.roll(outline, -1, axis=0)[middle]) / 2
    return np.insert(outline, middle + 1, between, axis=0)


@pytest.mark.parametrize("seed", range(40))
def test_a_prism_over_any_polygon_has_its_volume_and_is_cut_right(seed):
    rng = np.random.default_rng(seed)
    outline = random_star(rng, int(rng.integers(12, 30)))
    count = len(outline)
    following = np.roll(outline, -1, axis=0)
    base = np.sum(outline[:, 0] * following[:, 1] - outline[:, 1] * following[:, 0]) / 2
    order = rng.permutation(3)  # which coordinate comes where: the caps may face any axis
    keeps_sense = np.linalg.det(np.eye(3)[order]) > 0
    points = np.concatenate([np.c_[outline, np.full(count, z)] for z in (0.0, 100.0)])[:, order]
    sides = [[k, (k + 1) % count, (k + 1) % count + count, k + count] for k in range(count)]
    faces = [list(range(count - 1, -1, -1)), list(range(count, 2 * count)), *sides]
    prism = polydata(meshes.mesh(points, []), faces if keeps_sense else [face[::-1] for face in faces])
    alone = boolean([prism], [], UNION)
    assert alone.field_data["OperandVolume"][0] == pytest.approx(100 * base, rel=1e-13)
    assert alone.surface.GetNumberOfCells() == count + 2
    lower = np.where(order == 2, 50.0, -5000.0)
    cut = boolean([prism], [meshes.box(lower, (5000.0, 5000.0, 5000.0))], DIFFERENCE)
    assert cut.volume == pytest.approx(50 * base, rel=1e-13)
    assert measures.open_edges(cut.body) == 0 and not cut.errors and not cut.warnings


def test_polygons_with_corners_on_a_line_and_far_from_flat_stay_closed():
    # A cube with a point in the middle of an edge, which only one of the two faces at that edge passes through a bend.
    points = np.concatenate([CUBE_POINTS, [[1.0, -0.25, 2.0]], [[1.0, 2.0, 2.0]]])
    faces = [[0, 2, 3, 1], [4, 8, 5, 7, 9, 6], [0, 1, 5, 8, 4], [2, 6, 9, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    bent = polydata(meshes.mesh(points, []), faces)
    result = boolean([bent], [quads((1, 1, 1))], UNION)
    assert result.status == 0 and not result.errors and not result.warnings
    assert result.field_data["ResultVolume"][0] == pytest.approx(
        result.field_data["OperandVolume"][0] + 8 - 1, rel=1e-13
    )


def test_strips_are_read_and_come_out_as_triangles():
    # A tetrahedron as one strip of four triangles.
    points = np.array([[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3]], dtype=float)
    data = polydata(meshes.mesh(points, [[0, 0, 0]]))
    strips = vtkCellArray()
    strips.SetData(ids_array([0, 6]), ids_array([0, 2, 1, 3, 0, 2]))
    data.SetPolys(vtkCellArray())
    data.SetStrips(strips)
    alone = boolean([data], [], UNION)
    assert alone.volume == pytest.approx(4.5) and alone.surface.GetNumberOfPolys() == 4
    assert alone.surface.GetNumberOfStrips() == 0
    assert alone.cell_data["OriginalCellId"].tolist() == [0, 0, 0, 0]
    corner = boolean([data], [quads((-1, -1, -1))], DIFFERENCE)
    assert corner.volume == pytest.approx(4.5 - 1) and measures.open_edges(corner.body) == 0


def test_vertices_and_lines_are_ignored_but_counted_in_the_cell_ids():
    data = quads()
    for set_cells, ids in ((data.SetVerts, [0]), (data.SetLines, [0, 1])):
        cells = vtkCellArray()
        cells.SetData(ids_array([0, len(ids)]), ids_array(ids))
        set_cells(cells)
    with_arrays(data, cell={"Number": np.arange(8.0)})
    result = boolean([data], [quads((1, 1, 1))], UNION)
    assert result.volume == pytest.approx(15)
    mine = result.cell_data["SourceId"] == 0
    assert set(result.cell_data["OriginalCellId"][mine]) == {2, 3, 4, 5, 6, 7}
    assert np.array_equal(result.cell_data["Number"][mine], result.cell_data["OriginalCellId"][mine])
    assert result.surface.GetNumberOfVerts() == 0 and result.surface.GetNumberOfLines() == 0


def test_ids_of_32_and_64_bits_give_the_same_bytes():
    wide = [meshes.sphere(), meshes.moved(meshes.sphere(), (0.3, 0.2, 0.1))]
    narrow = [polydata(body) for body in wide]
    for data in narrow:
        assert data.GetPolys().ConvertTo32BitStorage()
    assert boolean(wide[:1], wide[1:], UNION).bytes() == boolean(narrow[:1], narrow[1:], UNION).bytes()


def test_the_curves_are_closed_polylines_with_their_length():
    result = boolean([quads()], [quads((0.5, 0.5, 1), side=1.0)], UNION)
    # The small cube's top lies in the big one's: nothing is left of it but the square in which they touch.
    assert result.curves.GetNumberOfLines() >= 1
    result = boolean([quads()], [quads((0.5, 0.5, 1.5), side=1.0)], UNION)
    arrays = booleans.arrays_of(result.curves.GetCellData())
    assert result.curves.GetNumberOfLines() == 1
    assert arrays["Closed"].tolist() == [1] and arrays["Length"][0] == pytest.approx(4, rel=1e-14)
    assert set(np.unique(points_of(result.curves)[:, 2])) == {2.0}
    assert boolean([quads()], [quads((5, 5, 5))], UNION).curves.GetNumberOfLines() == 0


# ---- attributes -------------------------------------------------------------------------------------


def test_arrays_that_are_linear_in_space_stay_linear_at_new_points():
    operands = [meshes.sphere(), meshes.moved(meshes.sphere(), (0.4, 0.3, 0.2))]
    data = [with_arrays(polydata(body), point={"Place": body.points, "Sum": body.points.sum(axis=1)}) for body in operands]
    for operation in SET_OPERATIONS:
        result = boolean(data[:1], data[1:], operation)
        points = points_of(result.surface)
        assert np.abs(result.point_data["Place"] - points).max() < 1e-15
        assert np.abs(result.point_data["Sum"] - points.sum(axis=1)).max() < 2e-15


def test_arrays_of_one_side_are_filled_on_the_other():
    first = with_arrays(quads(), {"A": np.arange(8.0), "N": np.arange(8, dtype=np.int32) + 1}, {"CellA": np.ones(6)})
    second = with_arrays(quads((1, 1, 1)), {"B": np.ones((8, 3), np.float32)}, {"CellB": np.ones(6, np.uint8)})
    result = boolean([first], [second], UNION)
    assert not result.warnings
    assert set(result.point_data) == {"A", "N", "B"}
    assert set(result.cell_data) == {"CellA", "CellB", "SourceId", "OriginalCellId"}
    of_second = result.cell_data["SourceId"] == 1
    assert np.all(np.isnan(result.cell_data["CellA"]) == of_second)
    assert np.all(result.cell_data["CellB"] == of_second)
    offsets, ids = cells_of(result.surface.GetPolys())
    owner = np.full(len(points_of(result.surface)), -1)
    owner[ids] = np.repeat(result.cell_data["SourceId"], np.diff(offsets))
    assert np.all(np.isnan(result.point_data["A"]) == (owner == 1))
    assert np.all((result.point_data["N"] == 0) == (owner == 1))
    assert np.all(np.isnan(result.point_data["B"][:, 0]) == (owner == 0))
    assert result.surface.GetPointData().GetArray("B").GetDataType() == VTK_FLOAT


def test_the_scalars_of_an_input_are_carried_although_the_source_becomes_active():
    first = with_arrays(quads(), {}, {"Material": np.full(6, 7.0)})
    first.GetCellData().SetActiveScalars("Material")
    result = boolean([first], [quads((1, 1, 1))], DIFFERENCE)
    assert np.all((result.cell_data["Material"] == 7) == (result.cell_data["SourceId"] == 0))
    assert result.surface.GetCellData().GetScalars().GetName() == "SourceId"


def test_each_side_of_a_seam_has_its_own_values():
    first = with_arrays(quads(), {"Side": np.zeros(8)})
    second = with_arrays(quads((1, 1, 1)), {"Side": np.ones(8)})
    result = boolean([first], [second], UNION)
    assert set(result.point_data["Side"]) == {0.0, 1.0}
    offsets, ids = cells_of(result.surface.GetPolys())
    sides = result.point_data["Side"][ids]
    assert np.array_equal(sides, np.repeat(result.cell_data["SourceId"], np.diff(offsets)))


def test_without_point_arrays_a_closed_result_is_closed_by_its_point_ids():
    result = boolean([quads()], [quads((1, 1, 1))], UNION)
    _, ids = cells_of(result.surface.GetPolys())
    assert len(np.unique(ids)) == len(points_of(result.surface))
    assert len(np.unique(points_of(result.surface), axis=0)) == len(points_of(result.surface))


@pytest.mark.parametrize(
    "first, second, carried",
    [
        (np.int32, np.int32, VTK_INT),
        (np.uint8, np.uint8, VTK_UNSIGNED_CHAR),
        (np.uint8, np.int16, VTK_SHORT),
        (np.float32, np.int8, VTK_FLOAT),
    ],
)
def test_number_types_become_one_that_holds_both(first, second, carried):
    operands = [with_arrays(quads(), cell={"V": np.full(6, 7, first)}), with_arrays(quads((1, 1, 1)), cell={"V": np.full(6, 9, second)})]
    result = boolean(operands[:1], operands[1:], UNION)
    assert not result.warnings
    assert result.surface.GetCellData().GetArray("V").GetDataType() == carried
    assert np.array_equal(result.cell_data["V"], 7 + 2 * result.cell_data["SourceId"])


def test_float_against_wide_integers_becomes_double():
    operands = [with_arrays(quads(), cell={"V": np.full(6, 0.5, np.float32)}), with_arrays(quads((1, 1, 1)), cell={"V": np.full(6, 16777217, np.int32)})]
    result = boolean(operands[:1], operands[1:], UNION)
    assert set(result.cell_data["V"]) == {0.5, 16777217.0}


def test_arrays_that_do_not_go_together_are_left_out_with_one_sentence():
    first = with_arrays(quads(), {"V": np.ones((8, 3))}, {"Short": np.ones(2)})
    second = with_arrays(quads((1, 1, 1)), {"V": np.ones(8)})
    result = boolean([first], [second], UNION)
    assert len(result.warnings) == 2 and not result.errors
    assert any("point array 'V' of Tool" in text and "rename" in text for text in result.warnings)
    assert any("cell array 'Short' of Input has 2 tuples for 6 cells" in text for text in result.warnings)
    assert result.point_data["V"].shape[1] == 3 and "Short" not in result.cell_data
    assert result.volume == pytest.approx(15)


def test_texts_and_ids_come_from_the_nearest_corner():
    first = quads()
    names = vtkStringArray()
    names.SetName("Name")
    for k in range(8):
        names.InsertNextValue(f"corner {k}")
    first.GetPointData().AddArray(names)
    ids = ids_array(1000 * np.arange(8))
    ids.SetName("Id")
    first.GetPointData().AddArray(ids)
    result = boolean([first], [quads((1, 1, 1))], DIFFERENCE)
    points = points_of(result.surface)
    for point, name, number in zip(points, result.point_data["Name"], result.point_data["Id"]):
        if name:
            corner = int(name.split()[1])
            assert number == 1000 * corner
            assert np.abs(point - CUBE_POINTS[corner]).max() <= 1.0
    assert result.point_data["Name"].count("") > 0  # the tool has no names
    assert {f"corner {k}" for k in range(7)} <= set(result.point_data["Name"])


def test_arrays_without_a_name_and_bits_do_no_harm():
    first = with_arrays(quads(), {"": np.arange(8.0)})
    first.GetPointData().GetArray(0).SetName(None)
    result = boolean([first], [quads((1, 1, 1))], UNION)
    assert result.volume == pytest.approx(15) and len(result.point_data) == 1


def test_the_arrays_of_an_earlier_boolean_give_way():
    once = boolean([quads()], [quads((1, 1, 1))], DIFFERENCE).surface
    twice = boolean([once], [quads((-1, -1, -1))], DIFFERENCE)
    assert twice.volume == pytest.approx(6)
    assert set(twice.cell_data) == {"SourceId", "OriginalCellId"}
    assert set(twice.cell_data["SourceId"]) == {0, 1}
    assert twice.field_data["OperandVolume"].tolist() == pytest.approx([7, 8])


@pytest.mark.parametrize("operation", SET_OPERATIONS)
def test_duplicated_points_stay_and_all_normals_face_outwards(operation):
    first, second = cube_with_normals((0, 0, 0)), cube_with_normals((1, 1, 1))
    result = boolean([first], [second], operation)
    assert result.surface.GetPointData().GetNormals() is not None
    assert result.surface.GetPointData().GetTCoords() is not None
    assert facing(result.surface).min() == pytest.approx(1, abs=1e-6)
    assert result.volume == pytest.approx(VOLUMES[operation])


def test_cell_normals_are_turned_over_with_their_cells():
    first, second = quads(), quads((1, 1, 1))
    for data in (first, second):
        outwards = np.array([[0, 0, -1], [0, 0, 1], [0, -1, 0], [0, 1, 0], [-1, 0, 0], [1, 0, 0]], dtype=float)
        with_arrays(data, cell={"Normals": outwards})
        data.GetCellData().SetActiveNormals("Normals")
    for operation in SET_OPERATIONS:
        result = boolean([first], [second], operation)
        assert facing(result.surface, "cell").min() == pytest.approx(1)


def test_reorienting_can_be_switched_off():
    first, second = cube_with_normals((0, 0, 0)), cube_with_normals((1, 1, 1))
    result = boolean([first], [second], DIFFERENCE, ReorientDifferenceCells=0)
    assert facing(result.surface).min() == pytest.approx(1, abs=1e-6)  # as in the inputs, both of them
    assert measures.open_edges(result.body) > 0  # at the seam, cells are now oriented against each other
    assert result.field_data["ResultVolume"][0] == pytest.approx(7)


def test_normals_of_one_side_alone_are_carried_but_not_active():
    result = boolean([cube_with_normals((0, 0, 0))], [quads((0, 0, 0))], UNION)
    assert result.surface.GetPointData().GetNormals() is None
    assert "Normals" in result.point_data


# ---- precision and memory ---------------------------------------------------------------------------


def as_float(data):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(points_of(data).astype(np.float32), deep=True))
    data.SetPoints(points)
    return data


def test_the_output_is_single_precision_only_if_all_inputs_are():
    for first, second, wanted in (
        (as_float(quads()), as_float(quads((1, 1, 1))), "float"),
        (as_float(quads()), quads((1, 1, 1)), "double"),
        (quads(), quads((1, 1, 1)), "double"),
    ):
        result = boolean([first], [second], UNION)
        for output in (result.surface, result.curves):
            assert output.GetPoints().GetData().GetDataTypeAsString() == wanted
        assert result.volume == pytest.approx(15)


def test_an_input_that_changes_is_read_again():
    tested = vtkPolyDataBooleanOperationFilter()
    moving = quads((1, 1, 1))
    tested.SetInputData(quads())
    tested.SetToolData(moving)
    assert booleans.update(tested).volume == pytest.approx(15)
    points = vtk_to_numpy(moving.GetPoints().GetData())
    points += 0.5
    moving.GetPoints().GetData().Modified()
    moving.GetPoints().Modified()
    moving.Modified()
    assert booleans.update(tested).volume == pytest.approx(16 - 0.125)
    with_arrays(moving, cell={"New": np.ones(6)})
    moving.Modified()
    assert "New" in booleans.update(tested).cell_data
    tested.SetToolData(quads((5, 5, 5)))
    assert booleans.update(tested).volume == pytest.approx(16)


# ---- composite data ------------------------------------------------------------------------


def grouped(kind, parts):
    group = kind()
    if kind is vtkPartitionedDataSetCollection:
        for k, part in enumerate(parts):
            partition = vtkPartitionedDataSet()
            partition.SetPartition(0, part)
            group.SetPartitionedDataSet(k, partition)
    else:
        for k, part in enumerate(parts):
            group.SetBlock(k, part) if kind is vtkMultiBlockDataSet else group.SetPartition(k, part)
    return group


@pytest.mark.parametrize("kind", [vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection])
def test_the_blocks_of_a_composite_count_as_one_surface(kind):
    first = grouped(kind, [with_arrays(quads(), {"A": np.ones(8)}, {"Id": np.arange(6.0)}), None, with_arrays(quads((5, 0, 0)), cell={"Id": np.arange(6.0) + 6})])
    second = grouped(kind, [quads((1, 1, 1)), quads((6, 1, 1))])
    result = boolean([first], [second], DIFFERENCE)
    assert result.volume == pytest.approx(14) and not result.errors
    mine = result.cell_data["SourceId"] == 0
    assert set(result.cell_data["SourceId"]) == {0, 1}
    assert np.array_equal(result.cell_data["Id"][mine], result.cell_data["OriginalCellId"][mine])
    assert set(result.cell_data["OriginalCellId"][mine]) == set(range(12))


def test_an_empty_composite_is_the_empty_set():
    result = boolean([quads()], [vtkMultiBlockDataSet()], DIFFERENCE)
    assert result.volume == pytest.approx(8) and result.status == 1


# ---- input that cannot be used ----------------------------------------------------------------------


def broken_index():
    data = quads()
    cells = vtkCellArray()
    ids = np.array(CUBE_QUADS)
    ids[4, 2] = 99
    cells.SetData(ids_array(np.arange(0, 25, 4)), ids_array(ids.ravel()))
    data.SetPolys(cells)
    return data


def broken_triangle(bad):
    body = meshes.box((0, 0, 0), (2, 2, 2))
    triangles = body.triangles.copy()
    triangles[7, 1] = bad
    return polydata(meshes.mesh(body.points, triangles))


def bad_coordinate(value):
    data = quads()
    vtk_to_numpy(data.GetPoints().GetData())[5, 1] = value
    return data


def turned_face():
    faces = [list(face) for face in CUBE_QUADS]
    faces[3].reverse()
    return polydata(meshes.mesh(CUBE_POINTS, []), faces)


def composite_of_images():
    return grouped(vtkMultiBlockDataSet, [quads(), vtkImageData()])


@pytest.mark.parametrize(
    "bad, status, words",
    [
        (broken_index, 7, ["Tool", "cell 4", "point which does not exist"]),
        (lambda: broken_triangle(99), 7, ["Tool", "cell 7"]),
        (lambda: broken_triangle(-1), 7, ["Tool", "cell 7"]),
        (lambda: bad_coordinate(np.nan), 6, ["Tool", "point 5", "finite"]),
        (lambda: bad_coordinate(-np.inf), 6, ["Tool", "point 5"]),
        (turned_face, 5, ["Tool", "oriented against each other", "Consistency"]),
        (vtkImageData, 20, ["Tool is of type vtkImageData", "Extract Surface"]),
        (vtkTable, 20, ["Tool is of type vtkTable"]),
        (composite_of_images, 20, ["Tool has a block that is of type vtkImageData", "Extract Surface"]),
    ],
)
def test_input_that_cannot_be_used_gets_one_sentence(bad, status, words):
    result = boolean([quads()], [bad()], UNION)
    assert len(result.errors) == 1 and not result.warnings
    assert result.is_empty and result.curves.GetNumberOfCells() == 0
    assert result.status == status
    assert result.message in result.errors[0] and result.message.endswith(".")
    assert "\n" not in result.message and all(word in result.message for word in words)


@pytest.mark.parametrize(
    "operation, inputs, usable",
    [
        (UNION, 1, True),
        (RESOLVE, 1, True),
        (INTERSECTION, 2, True),
        (INTERSECTION, 1, False),
        (DIFFERENCE, 1, False),
        (DIFFERENCE, 2, False),
        (SYMMETRIC_DIFFERENCE, 2, False),
    ],
)
def test_a_missing_tool_is_asked_for_where_it_is_needed(operation, inputs, usable):
    result = boolean([quads(), quads((1, 1, 1))][:inputs], [], operation)
    assert result.is_empty != usable and len(result.errors) == (not usable)
    if not usable:
        assert result.status == 21
        assert "needs a second surface" in result.message and "set Tool" in result.message
    elif operation == INTERSECTION:
        assert result.volume == pytest.approx(1)


@pytest.mark.parametrize(
    "settings, words",
    [
        ({"Operation": 7}, ["Operation is 7", "0 (Union)"]),
        ({"Operation": -1}, ["Operation is -1"]),
        ({"Tolerance": -1.0}, ["Tolerance is -1", "small positive length"]),
        ({"Tolerance": float("nan")}, ["Tolerance is nan"]),
        ({"Tolerance": float("inf")}, ["Tolerance is inf"]),
    ],
)
def test_settings_that_make_no_sense_get_one_sentence(settings, words):
    result = boolean([quads()], [quads((1, 1, 1))], UNION, **settings)
    assert result.status == 10 and result.is_empty and len(result.errors) == 1
    assert all(word in result.message for word in words)


def test_an_empty_operand_is_the_empty_set():
    for empty in (vtkPolyData(), polydata(meshes.EMPTY)):
        for operation, volume in ((UNION, 8), (INTERSECTION, 0), (DIFFERENCE, 8), (SYMMETRIC_DIFFERENCE, 8)):
            result = boolean([quads()], [empty], operation)
            assert result.status == 1 and result.volume == pytest.approx(volume)
            assert len(result.warnings) == 1 and not result.errors
            assert "Tool has no polygon" in result.warnings[0] and "empty set" in result.message
    result = boolean([vtkPolyData()], [quads()], DIFFERENCE)
    assert result.is_empty and result.status == 1


def test_several_operands_are_told_apart_by_number():
    result = boolean([quads(), quads((1, 0, 0))], [quads((5, 5, 5)), bad_coordinate(np.nan)], UNION)
    assert "Tool 2" in result.message and result.status == 6


def test_an_inside_out_operand_is_turned_over():
    faces = [face[::-1] for face in CUBE_QUADS]
    inside_out = polydata(meshes.mesh(CUBE_POINTS, []), faces)
    result = boolean([inside_out], [quads((1, 1, 1))], UNION)
    assert result.status == 4 and "Input" in result.message and len(result.warnings) == 1
    assert result.volume == pytest.approx(15)


def test_stopping_leaves_nothing_half_made():
    tested = vtkPolyDataBooleanOperationFilter()
    tested.SetInputData(quads())
    tested.SetToolData(quads((1, 1, 1)))
    tested.AddObserver("ProgressEvent", lambda *_: tested.SetAbortExecuteAndUpdateTime())
    result = booleans.update(tested)
    assert result.is_empty and result.curves.GetNumberOfCells() == 0 and not result.errors
    assert result.status == 9 and "stopped" in result.message


def test_progress_goes_up_from_start_to_end():
    tested = vtkPolyDataBooleanOperationFilter()
    tested.SetInputData(quads())
    tested.SetToolData(quads((1, 1, 1)))
    seen = []
    tested.AddObserver("ProgressEvent", lambda *_: seen.append(tested.GetProgress()))
    tested.Update()
    assert seen == sorted(seen) and len(seen) > 2 and seen[0] < 0.2 and seen[-1] == 1.0


# ---------------------------------------------------------------------------------------------------------- Tolerance


@pytest.mark.parametrize("gap", [1e-4, -1e-4])
def test_a_tolerance_closes_a_gap_between_two_surfaces(gap):
    left, right = meshes.box((0, 0, 0), (1, 1, 1)), meshes.box((1 + gap, 0, 0), (2, 1, 1))
    assert boolean([left], [right], UNION).volume == pytest.approx(2.0 - max(gap, 0.0), abs=1e-12)
    joined = boolean([left], [right], UNION, Tolerance=0.01)
    assert joined.status == 0
    assert joined.volume == 2.0
    assert joined.area == 10.0
    assert measures.open_edges(joined.body) == 0


def test_a_tolerance_closes_the_cracks_of_one_surface():
    closed = meshes.icosphere(3)
    noise = np.random.default_rng(1).uniform(-1e-7, 1e-7, (3 * len(closed.triangles), 3))
    cracked = meshes.mesh(
        closed.points[closed.triangles.ravel()] + noise, np.arange(len(noise)).reshape(-1, 3)
    )
    tool = meshes.box((0, 0, 0), (2, 2, 2))
    assert boolean([cracked], [tool], UNION).status in (2, 3)
    result = boolean([cracked], [tool], UNION, Tolerance=1e-4)
    assert result.status == 0
    assert measures.open_edges(result.body) == 0
    assert result.volume == pytest.approx(boolean([closed], [tool], UNION).volume, abs=1e-3)


def test_a_tolerance_moves_no_point_farther_than_it_says():
    body = meshes.moved(meshes.icosphere(3), (0.3, 0.2, 0.1))
    far = meshes.moved(body, (5, 0, 0))
    for tolerance in (1e-9, 1e-3, 0.05):
        result = boolean([body], [far], UNION, Tolerance=tolerance)
        source = np.concatenate([body.points, far.points])
        distance = np.linalg.norm(result.body.points - source, axis=1)
        assert 0 < distance.max() <= tolerance
