# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView asks for the ranges of all arrays after each update; the filters leave them where VTK looks before it computes them."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkAbstractArray, vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkPointSet

import meshes
from booleans import DIFFERENCE, boolean, polydata
from every_filter import FILTERS, named, outputs


def arrays_of(data):
    """The arrays on points and cells, and the points' own."""
    for attributes in (data.GetPointData(), data.GetCellData()):
        yield from filter(None, map(attributes.GetArray, range(attributes.GetNumberOfArrays())))
    if isinstance(data, vtkPointSet) and data.GetPoints():
        yield data.GetPoints().GetData()


def has_ranges(array):
    return bool(array.GetInformation().Has(vtkAbstractArray.PER_COMPONENT()))


def ranges(array):
    """Those of the components and of the magnitude; and without infinite values."""
    places = range(-1, array.GetNumberOfComponents())
    return [find(place) for place in places for find in (array.GetRange, array.GetFiniteRange)]


def has_ranges_as_vtk_finds_them(array):
    return np.array_equal(ranges(array), ranges(numpy_to_vtk(vtk_to_numpy(array), deep=True)), equal_nan=True)


@pytest.mark.parametrize("name", FILTERS)
def test_outputs_come_with_the_ranges_that_vtk_finds(name):
    made = FILTERS[name].make("shapes")
    made.Update()
    inputs = [made.GetInputDataObject(port, 0) for port in range(len(FILTERS[name].inputs))]
    shared = [array for data in inputs for array in arrays_of(data)]
    filled = [array for data in outputs(made) for array in arrays_of(data) if array.GetNumberOfTuples()]
    own = [array for array in filled if array not in shared]
    assert own
    for array in own:
        assert has_ranges(array) or np.all(np.isnan(vtk_to_numpy(array))), array.GetName()
        assert has_ranges_as_vtk_finds_them(array), array.GetName()


def test_infinite_values_and_nan_count_as_vtk_counts_them():
    body, tool = polydata(meshes.sphere(1.0)), polydata(meshes.cube(1.0, (0.9, 0.0, 0.0)))
    some = np.random.default_rng(1).normal(size=(body.GetNumberOfCells(), 3))
    some[::5, 0], some[::7, 1], some[::11, 2] = np.inf, np.nan, -np.inf
    for name, values in {"Some": some, "Nothing": np.full_like(some, np.nan)}.items():
        body.GetCellData().AddArray(named(name, values))
    result = boolean([body], [tool], DIFFERENCE).surface
    for name in ("Some", "Nothing"):
        array = result.GetCellData().GetArray(name)
        assert has_ranges_as_vtk_finds_them(array), name


def test_a_changed_array_has_ranges_of_its_new_values():
    made = FILTERS["SurfaceBoolean"].make("shapes")
    made.Update()
    array = made.GetOutput().GetCellData().GetArray("SourceId")
    vtk_to_numpy(array)[:] += 5
    array.Modified()
    assert array.GetRange() == (5.0, 6.0)
    assert not array.GetInformation().Has(vtkDataArray.L2_NORM_RANGE())


def test_arrays_of_the_inputs_are_left_alone():
    """Another thread may look at them."""
    made = FILTERS["SurfaceDistance"].make("shapes")
    before = [has_ranges(array) for array in arrays_of(made.GetInputDataObject(0, 0))]
    made.Update()
    assert [has_ranges(array) for array in arrays_of(made.GetInputDataObject(0, 0))] == before
