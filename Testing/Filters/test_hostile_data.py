# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever arrays, cells and coordinates the inputs have: every filter gives a result, or one sentence and nothing."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkAbstractArray, vtkDoubleArray, vtkPoints, vtkStringArray, vtkVariant, vtkVariantArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from every_filter import FILTERS, INPUTS, field_value, is_empty, outputs, run, status

WITH_INPUTS = [name for name, entry in FILTERS.items() if entry.inputs]
OF_SURFACES = ("SurfaceBoolean", "SurfaceIntersection", "SurfaceDistance", "SurfaceCheck", "ClosedSurfaceClip")
# These hand the points or cells of the input on with all of its arrays, as they are.
PASSING_ON = ("vtkPolyDataDistance", "vtkPolyDataSurfaceCheck", "vtkPolyDataContourTriangulator", "vtkPointSetSurfaceFilter")
NUMERIC_TYPES = (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 15, 16, 17)  # vtkType.h: bits to unsigned long long


def typed(kind, name, tuples, components=1):
    """An array of a VTK type with some values."""
    array = vtkAbstractArray.CreateArray(kind)
    array.SetName(name)
    array.SetNumberOfComponents(components)
    array.SetNumberOfTuples(tuples)
    for i in range(tuples * components if kind in (1, 13, 20) else 0):
        array.SetValue(i, {1: i % 2, 13: f"tüxt {i}", 20: vtkVariant(i)}[kind])
    if kind not in (1, 13, 20) and tuples:
        array.Fill(1)
    return array


def hostile_arrays(tuples):
    for kind in (*NUMERIC_TYPES, 13, 20):  # and strings and variants
        for components in (1, 3):
            yield typed(kind, f"type {kind}, {components} components", tuples, components)
    for length in (0, 1, tuples - 1, tuples + 1):
        yield typed(11, f"{length - tuples} too many", max(0, length))
    nameless = typed(11, "", tuples)
    nameless.SetName(None)
    yield nameless
    wide = typed(10, "wide", tuples, 70)
    yield wide


def copy_of(data):
    copy = vtkPolyData()
    copy.DeepCopy(data)
    return copy


def made_with(name, change, port=None):
    """The filter on shapes, of which all, or that of one port, are changed."""
    made = FILTERS[name].make("shapes")
    for number, what in enumerate(FILTERS[name].inputs):
        if port in (None, number):
            made.SetInputDataObject(number, change(copy_of(INPUTS["shapes"][what]())))
    return made


def add_arrays(data):
    for attributes, tuples in (
        (data.GetPointData(), data.GetNumberOfPoints()),
        (data.GetCellData(), data.GetNumberOfCells()),
        (data.GetFieldData(), 5),
    ):
        for array in hostile_arrays(tuples):
            attributes.AddArray(array)
    return data


def answer(made, what=""):
    """'taken' or 'refused'."""
    errors, _ = run(made)
    if errors:
        assert len(errors) == 1 and is_empty(made), (what, errors)
        message = field_value(outputs(made)[0], "Message")
        assert message in errors[0] and message.endswith("."), (what, message)
        return "refused"
    assert status(made) >= 0
    for data in outputs(made):
        for attributes, tuples in ((data.GetPointData(), data.GetNumberOfPoints()), (data.GetCellData(), data.GetNumberOfCells())):
            for i in range(attributes.GetNumberOfArrays() if made.GetClassName() not in PASSING_ON else 0):
                array = attributes.GetAbstractArray(i)
                assert array.GetNumberOfTuples() == tuples, (what, array.GetName())
    return "taken"


@pytest.mark.parametrize("name", WITH_INPUTS)
def test_arrays_of_every_type_do_no_harm_and_good_ones_are_kept(name):
    plain = FILTERS[name].make("shapes")
    run(plain)
    made = made_with(name, add_arrays)
    assert answer(made) == "taken"
    for before, after in zip(outputs(plain), outputs(made)):
        assert before.GetNumberOfCells() == after.GetNumberOfCells()
        if before.GetNumberOfPoints() and not name.startswith("ContourTri"):
            assert np.array_equal(np.array(before.GetBounds()), np.array(after.GetBounds()))
    if name in OF_SURFACES:
        first = outputs(made)[0] if name != "SurfaceIntersection" else outputs(made)[1]
        kept = {first.GetCellData().GetArrayName(i) for i in range(first.GetCellData().GetNumberOfArrays())}
        assert {f"type {kind}, {n} components" for kind in (*NUMERIC_TYPES, 13, 20) for n in (1, 3)} <= kept


def of_type(kind):
    def change(data):
        points = vtkPoints()
        points.SetDataType(kind)
        points.DeepCopy(data.GetPoints())
        other = vtkPoints()
        other.SetDataType(kind)
        other.SetNumberOfPoints(points.GetNumberOfPoints())
        for i in range(points.GetNumberOfPoints()):
            other.SetPoint(i, points.GetPoint(i))
        data.SetPoints(other)
        return data

    return change


@pytest.mark.parametrize("kind", (10, 11))
@pytest.mark.parametrize("name", WITH_INPUTS)
def test_surfaces_keep_the_number_type_of_their_points(name, kind):
    made = made_with(name, of_type(kind))
    assert answer(made) == "taken"
    for data in outputs(made):
        if isinstance(data, vtkPolyData) and data.GetNumberOfPoints() and not name.startswith("PointSet"):
            assert data.GetPoints().GetDataType() == kind


@pytest.mark.parametrize("kind", (3, 6, 16))
@pytest.mark.parametrize("name", WITH_INPUTS)
def test_points_of_integers_do_no_harm(name, kind):
    answer(made_with(name, lambda data: of_type(kind)(stretched(100.0)(data))))


def stretched(factor, offset=0.0, rows=slice(None)):
    def change(data):
        places = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        with np.errstate(all="ignore"):
            places[rows] = places[rows] * factor + offset
        points = vtkPoints()
        points.SetData(numpy_to_vtk(places, deep=True))
        data.SetPoints(points)
        return data

    return change


COORDINATES = {
    "1e-300": stretched(1e-300),
    "1e300": stretched(1e300),
    "denormal": stretched(1e-320),
    "overflowing": stretched(3e308),
    "beside 1e300": stretched(1.0, 1e300, slice(0, 1)),
    "beside 1e-300": stretched(1e-300, 0.0, slice(0, 3)),
    "all at one place": stretched(0.0),
    "all at one place far away": stretched(0.0, 1e300),
    "a plane": lambda data: stretched(np.array([1.0, 1.0, 0.0]))(data),
    "a line": lambda data: stretched(np.array([1.0, 0.0, 0.0]))(data),
    "far away": stretched(1.0, 1e15),
    "NaN": stretched(1.0, np.nan, slice(0, 1)),
    "all NaN": stretched(np.nan),
    "infinite": stretched(1.0, np.inf, slice(0, 2)),
}


@pytest.mark.parametrize("what", COORDINATES)
@pytest.mark.parametrize("name", WITH_INPUTS)
def test_coordinates_of_any_size_give_a_result_or_a_sentence(name, what):
    for port in (None, *range(len(FILTERS[name].inputs))):
        answer(made_with(name, COORDINATES[what], port), (what, port))


@pytest.mark.parametrize("what", ("1e-300", "1e300"))
@pytest.mark.parametrize("name", ("SurfaceBoolean", "SurfaceIntersection", "SurfaceDistance", "SurfaceCheck"))
def test_very_small_and_very_large_surfaces_are_surfaces(name, what):
    plain = FILTERS[name].make("shapes")
    run(plain)
    made = made_with(name, COORDINATES[what])
    assert answer(made) == "taken"
    assert [d.GetNumberOfCells() for d in outputs(made)] == [d.GetNumberOfCells() for d in outputs(plain)]


def with_ids(bad):
    def change(data):
        for cells in (data.GetPolys(), data.GetLines()):
            ids = vtk_to_numpy(cells.GetConnectivityArray())
            if len(ids):
                ids[len(ids) // 2] = bad
        data.Modified()
        return data

    return change


@pytest.mark.parametrize("bad", (-1, 2**31 - 1, 2**33 + 1))
@pytest.mark.parametrize("name", WITH_INPUTS)
def test_ids_of_points_that_do_not_exist_do_no_harm(name, bad):
    answer(made_with(name, with_ids(bad)))


def with_offsets(bad):
    def change(data):
        for get, set_ in ((data.GetPolys, data.SetPolys), (data.GetLines, data.SetLines)):
            offsets = vtk_to_numpy(get().GetOffsetsArray()).astype(np.int64)
            if len(offsets) > 1:
                offsets[len(offsets) // 2] = bad
                cells = vtkCellArray()
                ids = vtk_to_numpy(get().GetConnectivityArray()).astype(np.int64)
                cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(ids, deep=True))
                set_(cells)
        return data

    return change


@pytest.mark.parametrize("bad", (-1, 10**6, 2**40))
@pytest.mark.parametrize("name", WITH_INPUTS)
def test_cells_that_begin_outside_of_the_list_of_ids_are_told(name, bad):
    """Where only the points of a cloud are used, there are no such cells."""
    made = made_with(name, lambda data: with_offsets(bad)(with_ids(-(2**61))(data)))
    assert answer(made) == ("taken" if "cloud" == "".join(FILTERS[name].inputs) else "refused")
    if status(made) > 0:
        assert "damaged" in field_value(outputs(made)[0], "Message")


def with_other_cells(data):
    """Vertices, lines and strips beside the polygons."""
    count = data.GetNumberOfPoints()
    for kind, size in (("Verts", 1), ("Lines", 2), ("Strips", 5)):
        if kind == "Lines" and data.GetLines().GetNumberOfCells():
            continue
        cells = vtkCellArray()
        for first in range(0, min(count - size, 20), 3):
            cells.InsertNextCell(size)
            for i in range(size):
                cells.InsertCellPoint(first + i)
        getattr(data, "Set" + kind)(cells)
    cells_after = data.GetNumberOfCells()
    data.GetCellData().Initialize()
    number = vtkDoubleArray()
    number.SetName("Number")
    number.SetNumberOfTuples(cells_after)
    number.Fill(7)
    data.GetCellData().AddArray(number)
    return data


@pytest.mark.parametrize("name", WITH_INPUTS)
def test_vertices_lines_and_strips_beside_the_polygons_do_no_harm(name):
    answer(made_with(name, with_other_cells))


NOTHING = {
    "an empty data set": lambda data: vtkPolyData(),
    "points without cells": lambda data: without_cells(data),
    "cells without points": lambda data: data.SetPoints(vtkPoints()) or data,
    "one point": lambda data: one_point(),
}


def without_cells(data):
    empty = vtkPolyData()
    empty.SetPoints(data.GetPoints())
    return empty


def one_point():
    made = vtkPolyData()
    made.SetPoints(vtkPoints())
    made.GetPoints().InsertNextPoint(1, 2, 3)
    return made


@pytest.mark.parametrize("what", NOTHING)
@pytest.mark.parametrize("name", WITH_INPUTS)
def test_inputs_with_nothing_in_them_do_no_harm(name, what):
    for port in (None, *range(len(FILTERS[name].inputs))):
        answer(made_with(name, NOTHING[what], port), port)
