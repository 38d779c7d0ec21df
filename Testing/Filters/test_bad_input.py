# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input gets one plain sentence that says what, where and what to do; nothing is half made."""

import re

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
)

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
    polydata,
    update,
)
from meshes import EMPTY, box, cube

# The numbers of the field array Status, which scripts rely on.
OK, EMPTY_OPERAND, OPEN, NOT_SEPARATING, INSIDE_OUT = range(5)
INCONSISTENT, BAD_COORDINATE, BAD_INDEX = 5, 6, 7
ABORTED, BAD_REQUEST, NOT_A_SURFACE, MISSING_TOOL, ONE_SURFACE = 9, 10, 20, 21, 23

TOOL = cube(1.0, (0.5, 0.5, 0.5))


def assert_one_plain_sentence(text, *parts):
    """One sentence of moderate length that advises, and that says what it must."""
    assert re.search(r"[;,] ?\w", text), "what to do follows what is wrong"
    assert text[0].isupper() and text.endswith(".") and ". " not in text
    assert 20 < len(text) < 300 and "\n" not in text
    for part in parts:
        assert re.search(part, text), (part, text)


def assert_refused(result, status, *parts):
    """An error: heard once, the same words in Message, and nothing in either output."""
    assert result.status == status, result.message
    assert len(result.errors) == 1 and result.message in result.errors[0]
    assert_one_plain_sentence(result.message, *parts)
    assert result.is_empty
    assert result.curves.GetNumberOfCells() == 0 and result.curves.GetNumberOfPoints() == 0


def assert_warned(result, status, *parts):
    """A warning: heard once, and the result is there."""
    assert result.status == status, result.message
    assert not result.errors
    assert len(result.warnings) == 1 and result.message in result.warnings[0]
    assert_one_plain_sentence(result.message, *parts)


# ---- refused -----------------------------------------------------------------------------------


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("port, name", [(0, "Input"), (1, "Tool")])
@pytest.mark.parametrize("operation", SET_OPERATIONS)
def test_a_coordinate_that_is_not_finite_is_refused(value, port, name, operation):
    operands = [cube(1.0), cube(1.0, (0.5, 0.5, 0.5))]
    operands[port].points[5, 1] = value
    result = boolean(operands[:1], operands[1:], operation)
    assert_refused(result, BAD_COORDINATE, f"^{name} ", r"point 5\b", "finite")


@pytest.mark.parametrize("bad", [8, 2**31 - 1, 2**31 + 3, 2**40, -1, -(2**40)])
def test_a_cell_that_names_a_point_which_does_not_exist_is_refused(bad):
    body = cube(1.0)
    ids = body.triangles.astype(np.int64)
    ids[7, 1] = bad
    data = polydata(body, list(ids))
    result = boolean([data], [TOOL], UNION)
    assert_refused(result, BAD_INDEX, "^Input ", r"cell 7\b", "does not exist")
    assert_refused(boolean([TOOL], [data], DIFFERENCE), BAD_INDEX, "^Tool ", r"cell 7\b")


def test_cells_without_any_points_are_refused():
    data = vtkPolyData()
    data.SetPolys(polydata(cube(1.0)).GetPolys())
    assert_refused(boolean([TOOL], [data], UNION), BAD_INDEX, "^Tool ", r"cell 0\b")


def test_a_polygon_that_names_a_missing_point_is_refused():
    quads = [list(quad) for quad in meshes.BOX_QUADS]
    quads[3][2] = 12
    data = polydata(meshes.mesh(meshes.box_corners((0, 0, 0), (1, 1, 1)), []), quads)
    assert_refused(boolean([data], [TOOL], UNION), BAD_INDEX, "^Input ", r"cell 3\b")


def test_neighbours_oriented_against_each_other_are_refused():
    body = cube(1.0)
    body.triangles[4] = body.triangles[4][::-1]
    result = boolean([body], [TOOL], UNION)
    assert_refused(result, INCONSISTENT, "^Input ", r"cell \d+", "oriented against", "Normals")


def test_the_wrong_kind_of_data_is_refused():
    image = vtkImageData()
    image.SetDimensions(3, 3, 3)
    assert_refused(boolean([image], [TOOL], UNION), NOT_A_SURFACE, "^Input ", "vtkImageData")
    assert_refused(boolean([TOOL], [image], UNION), NOT_A_SURFACE, "^Tool ", "vtkImageData")
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, image)
    assert_refused(boolean([blocks], [TOOL], UNION), NOT_A_SURFACE, "^Input ", "vtkImageData")


@pytest.mark.parametrize("operation", [INTERSECTION, DIFFERENCE, SYMMETRIC_DIFFERENCE])
def test_a_missing_tool_is_asked_for(operation):
    assert_refused(boolean([cube(1.0)], [], operation), MISSING_TOOL, "Tool")


def test_resolve_does_without_a_tool():
    result = boolean([cube(1.0)], [], RESOLVE)
    assert (result.status, result.errors, result.warnings) == (OK, [], [])
    assert result.volume == 1.0


def test_a_missing_input_is_an_error_of_the_pipeline_and_gives_nothing():
    result = boolean([], [TOOL], UNION)
    assert result.errors and result.is_empty


@pytest.mark.parametrize("tolerance", [-1.0, np.nan, np.inf])
def test_a_senseless_tolerance_is_refused(tolerance):
    result = boolean([cube(1.0)], [TOOL], UNION, Tolerance=tolerance)
    assert_refused(result, BAD_REQUEST, "Tolerance")


def test_an_operation_that_does_not_exist_is_refused():
    assert_refused(boolean([cube(1.0)], [TOOL], UNION, Operation=7), BAD_REQUEST, "Operation is 7")


# ---- accepted with a warning -------------------------------------------------------------------


def test_an_empty_operand_counts_as_the_empty_set():
    unit = cube(1.0)
    expected = {UNION: 1.0, INTERSECTION: 0.0, DIFFERENCE: 1.0, SYMMETRIC_DIFFERENCE: 1.0}
    for operation, volume in expected.items():
        for nothing in (EMPTY, vtkPolyData()):
            result = boolean([unit], [nothing], operation)
            assert_warned(result, EMPTY_OPERAND, "^Tool ", "empty set")
            assert result.volume == volume and measures.is_closed(result.body)
    assert_warned(boolean([EMPTY], [unit], DIFFERENCE), EMPTY_OPERAND, "^Input ")
    assert boolean([EMPTY], [unit], UNION).volume == 1.0


def test_an_operand_without_lids_is_said_to_be_open():
    """A square pipe without ends cuts a cube through: its back is the inside."""
    pipe = box((-0.25, -0.25, -2), (0.25, 0.25, 2))
    sides = pipe.points[pipe.triangles]
    walls = np.ptp(sides[:, :, 2], axis=1) > 0
    result = boolean([cube(1.0)], [meshes.mesh(pipe.points, pipe.triangles[walls])], DIFFERENCE)
    assert_warned(result, OPEN, "^Tool ", r"cell \d+|point \d+", "not closed")
    assert measures.is_closed(result.body)
    assert result.volume == pytest.approx(0.75, rel=1e-14)


def test_a_sheet_that_does_not_cut_through_is_said_to_have_no_inside():
    small = meshes.sheet(lambda x, y: 0.0 * x, [-0.25, 0.25], [-0.25, 0.25])
    result = boolean([cube(1.0)], [small], DIFFERENCE)
    assert not result.errors
    assert result.status == NOT_SEPARATING
    assert_one_plain_sentence(result.message, "^Tool ", "through")


def test_an_operand_turned_inside_out_is_turned_over():
    result = boolean([meshes.inside_out(cube(1.0))], [TOOL], UNION)
    assert_warned(result, INSIDE_OUT, "^Input ", "turned over")
    assert measures.is_closed(result.body)
    assert result.volume == 1.875


# ---- accepted without a word -------------------------------------------------------------------


def with_triangles(body, more):
    return meshes.mesh(body.points, np.vstack([body.triangles, more]))


def with_a_filled_t_junction():
    """A closed cube with an edge split on one side only; a triangle without area fills the gap."""
    body = cube(1.0)
    a, b, c = body.triangles[0]
    points = np.vstack([body.points, (body.points[a] + body.points[b]) / 2])
    return meshes.mesh(points, np.vstack([body.triangles[1:], [[a, 8, c], [8, b, c], [a, b, 8]]]))


UNTIDY = {
    "a cell with a point twice": with_triangles(cube(1.0), [[0, 0, 5], [3, 3, 3]]),
    "a cell without area": with_a_filled_t_junction(),
    "each cell twice": with_triangles(cube(1.0), cube(1.0).triangles),
    "a wall seen from both sides": meshes.joined(
        cube(1.0),
        meshes.mesh([[0, -0.5, -0.5], [0, 0.5, -0.5], [0, 0, 0.5]], [[0, 1, 2], [2, 1, 0]]),
    ),
    "no two cells share a point": meshes.mesh(
        cube(1.0).points[cube(1.0).triangles].reshape(-1, 3), np.arange(36)
    ),
    "points that no cell uses": meshes.mesh(
        np.vstack([cube(1.0).points, [[9, 9, 9]] * 5]), cube().triangles
    ),
}


@pytest.mark.parametrize("name", UNTIDY)
def test_an_untidy_cube_is_still_a_cube(name):
    body = UNTIDY[name]
    expected = {UNION: 1.875, INTERSECTION: 0.125, DIFFERENCE: 0.875, SYMMETRIC_DIFFERENCE: 1.75}
    for operation, volume in expected.items():
        for inputs, tools in (([body], [TOOL]), ([TOOL], [body])):
            result = boolean(inputs, tools, operation)
            assert result.status == OK and not result.errors and not result.warnings, result.message
            assert measures.is_closed(result.body)
            assert result.volume == pytest.approx(volume, rel=1e-14)
    clean = boolean([cube(1.0)], [TOOL], UNION)
    assert boolean([body], [TOOL], UNION).area == pytest.approx(clean.area, rel=1e-14)


def test_cubes_that_share_an_edge_and_a_corner_are_cut_as_what_they_are():
    """Not manifold: an edge with four cells, a point where two parts meet."""
    parts = [((0, 0, 0), (1, 1, 1)), ((1, 1, 0), (2, 2, 1)), ((2, 2, 1), (3, 3, 2))]
    body = meshes.box_soup(parts)
    result = boolean([body], [box((0.5, 0.5, 0.5), (2.5, 2.5, 1.5))], DIFFERENCE)
    assert result.status == OK and measures.is_closed(result.body)
    assert result.volume == pytest.approx(3 - 0.125 - 0.5 - 0.125, rel=1e-14)


def test_lines_points_and_cells_of_two_corners_are_passed_over():
    data = polydata(cube(1.0), [*cube(1.0).triangles.tolist(), [0, 1], [4]])
    lines = vtkCellArray()
    lines.SetData(
        numpy_to_vtkIdTypeArray(np.array([0, 2]), deep=True),
        numpy_to_vtkIdTypeArray(np.array([0, 7]), deep=True),
    )
    data.SetLines(lines)
    result = boolean([data], [TOOL], DIFFERENCE)
    assert result.status == OK and measures.is_closed(result.body)
    assert result.volume == 0.875
    # the one line comes first in a vtkPolyData's count of cells, so the first triangle is cell 1
    assert result.parents <= {(0, k) for k in range(1, 13)} | {(1, k) for k in range(12)}


@pytest.mark.parametrize("exponent", [-300, -150, -30, 30, 150, 300])
def test_huge_and_tiny_coordinates_give_the_same_surface(exponent):
    factor = 2.0 ** exponent if abs(exponent) < 100 else 10.0**exponent
    for operation, volume in ((UNION, 1.875), (INTERSECTION, 0.125), (DIFFERENCE, 0.875)):
        operands = [meshes.scaled(body, factor) for body in (cube(1.0), TOOL)]
        result = boolean(operands[:1], operands[1:], operation)
        assert result.status == OK and not result.errors
        assert measures.is_closed(result.body)
        unit = meshes.scaled(result.body, 1.0 / factor)
        assert measures.volume(unit) == pytest.approx(volume, rel=1e-12)


def test_a_far_speck_does_not_spoil_a_near_body():
    speck = meshes.moved(cube(1024.0), (2.0**40, 0.0, 0.0))
    result = boolean([cube(1.0), speck], [TOOL], DIFFERENCE)
    assert result.status == OK and measures.is_closed(result.body)
    near = result.body.points[result.body.triangles][:, :, 0].max(axis=1) < 10
    part = meshes.mesh(result.body.points, result.body.triangles[near])
    assert measures.volume(part) == pytest.approx(0.875, rel=1e-3)


def array(values, name):
    made = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
    made.SetName(name)
    return made


def test_arrays_of_one_name_and_of_different_shape_do_no_harm():
    first, second = polydata(cube(1.0)), polydata(TOOL)
    first.GetPointData().AddArray(array(np.arange(8), "a"))
    second.GetPointData().AddArray(array(np.ones((8, 3)), "a"))
    second.GetCellData().AddArray(array(np.arange(12), "only here"))
    result = boolean([first], [second], UNION)
    assert not result.errors and measures.is_closed(result.body)
    assert result.volume == pytest.approx(1.875, rel=1e-14)
    assert result.status == OK
    assert all("array 'a'" in text for text in result.warnings) and result.warnings
    number_of_cells = result.surface.GetNumberOfCells()
    assert len(result.cell_data["only here"]) == number_of_cells
    from_second = result.cell_data["SourceId"] == 1
    assert np.array_equal(
        result.cell_data["only here"][from_second], result.cell_data["OriginalCellId"][from_second]
    )
    assert np.isnan(result.cell_data["only here"][~from_second]).all()
    assert len(result.point_data["a"]) == result.surface.GetNumberOfPoints()


@pytest.mark.parametrize("length", [0, 3, 7, 9, 100])
def test_arrays_of_the_wrong_length_are_left_out_with_a_word(length):
    data = polydata(cube(1.0))
    data.GetPointData().AddArray(array(np.arange(length), "short"))
    data.GetCellData().AddArray(array(np.arange(length), "few"))
    result = boolean([data], [TOOL], UNION)
    assert not result.errors and measures.is_closed(result.body)
    assert result.volume == pytest.approx(1.875, rel=1e-14)
    for text in result.warnings:
        assert re.search("short|few", text) and "Input" in text
    assert len(result.warnings) == 2


# ---- stopping, and going on --------------------------------------------------------------------


def test_stopping_the_filter_leaves_nothing_and_it_can_run_again():
    from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter

    ball = meshes.icosphere(5)
    tested = vtkPolyDataBooleanOperationFilter()
    tested.AddInputDataObject(0, polydata(ball))
    tested.AddInputDataObject(1, polydata(meshes.moved(ball, (0.3, 0.2, 0.1))))
    stop = tested.AddObserver("ProgressEvent", lambda *_: tested.SetAbortExecuteAndUpdateTime())
    result = update(tested)
    assert result.is_empty and not result.errors
    # VTK itself may clear the output of a stopped filter, field data and all.
    assert result.field_data.get("Status", [ABORTED])[0] == ABORTED
    tested.RemoveObserver(stop)
    tested.SetAbortExecute(0)
    tested.Modified()
    result = update(tested)
    assert result.status == OK and measures.is_closed(result.body)


def test_after_a_refusal_good_input_gives_a_good_result():
    from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter

    tested = vtkPolyDataBooleanOperationFilter()
    bad = cube(1.0)
    bad.points[0, 0] = np.nan
    tested.SetInputDataObject(0, polydata(bad))
    tested.SetInputDataObject(1, polydata(TOOL))
    assert_refused(update(tested), BAD_COORDINATE)
    tested.SetInputDataObject(0, polydata(cube(1.0)))
    result = update(tested)
    assert result.status == OK and result.volume == 1.875 and not result.errors


def test_the_same_object_on_both_ports_is_fine():
    data = polydata(cube(1.0))
    assert boolean([data], [data], INTERSECTION).volume == 1.0
    assert boolean([data], [data], DIFFERENCE).is_empty
    assert boolean([data, data], [], UNION).volume == 1.0


def test_a_union_of_one_surface_is_that_surface_with_a_hint():
    result = boolean([cube(1.0)], [], UNION)
    assert result.status == ONE_SURFACE and len(result.warnings) == 1 and "Resolve" in result.message
    assert result.volume == pytest.approx(1.0, rel=1e-15) and not result.errors


def test_without_any_surface_the_sentence_names_input():
    result = boolean([], [], UNION)
    assert_refused(result, BAD_REQUEST, "Input")
