# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the filter under test on meshes, and VTK's own filter beside it.

VTK's filter may loop for ever or crash, so it runs in a process of its own that has a time limit.
"""

import json
import subprocess
import sys
from dataclasses import dataclass, field

import numpy as np
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import measures
from meshes import Mesh, mesh

UNION, INTERSECTION, DIFFERENCE = "Union", "Intersection", "Difference"
SYMMETRIC_DIFFERENCE, RESOLVE = "SymmetricDifference", "Resolve"
SET_OPERATIONS = (UNION, INTERSECTION, DIFFERENCE, SYMMETRIC_DIFFERENCE)


def polydata(body, polygons=None):
    """A vtkPolyData of a mesh; `polygons` (a list of lists of point ids) replaces the triangles."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(body.points, deep=True))
    if polygons is None:
        sizes, ids = np.full(len(body.triangles), 3), body.triangles.ravel()
    else:
        sizes, ids = np.array([len(p) for p in polygons]), np.concatenate(polygons)
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(ids, dtype=np.int64), deep=True),
    )
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetPolys(cells)
    return result


def cells_of(cell_array):
    """A vtkCellArray as (offsets, point ids)."""
    offsets = vtk_to_numpy(cell_array.GetOffsetsArray()).astype(np.int64)
    return offsets, vtk_to_numpy(cell_array.GetConnectivityArray()).astype(np.int64)


def points_of(data):
    if data.GetNumberOfPoints() == 0:
        return np.zeros((0, 3))
    return vtk_to_numpy(data.GetPoints().GetData()).astype(np.float64)


def triangles_of(data):
    """The polygons as a mesh, each cut into a fan, and the polygon of each triangle."""
    offsets, ids = cells_of(data.GetPolys())
    sizes = np.diff(offsets)
    pieces, owners = [], []
    for size in np.unique(sizes[sizes > 2]):
        polygon = np.flatnonzero(sizes == size)
        corners = ids[offsets[polygon][:, None] + np.arange(size)]
        for k in range(1, size - 1):
            pieces.append(corners[:, [0, k, k + 1]])
            owners.append(polygon)
    if not pieces:
        return mesh(points_of(data), []), np.zeros(0, dtype=int)
    return mesh(points_of(data), np.concatenate(pieces)), np.concatenate(owners)


def arrays_of(attributes):
    """Every array of point, cell or field data by its name; texts as lists."""
    result = {}
    for k in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(k)
        if array.IsNumeric():
            result[array.GetName()] = vtk_to_numpy(array)
        else:
            result[array.GetName()] = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    return result


def bytes_of(*surfaces):
    """Everything of vtkPolyData that must not depend on the number of threads."""
    parts = []
    for data in surfaces:
        parts.append(points_of(data).tobytes())
        for cells in (data.GetPolys(), data.GetLines()):
            parts += [array.tobytes() for array in cells_of(cells)]
        for attributes in (data.GetPointData(), data.GetCellData()):
            for name, array in sorted(arrays_of(attributes).items()):
                parts += [name.encode(), np.asarray(array).tobytes()]
    return b"|".join(parts)


def heard_from(tested):
    """Update a filter; the errors and the warnings that it and its executive tell meanwhile."""
    return heard_from_call(tested, tested.Update)


def heard_from_call(tested, call):
    """The same of another method of the filter."""
    heard = {"ErrorEvent": [], "WarningEvent": []}

    @calldata_type(VTK_STRING)
    def listen(_, event, text):
        heard[event].append(text)

    for watched in (tested, tested.GetExecutive()):
        for event in heard:
            watched.AddObserver(event, listen)
    call()
    return heard["ErrorEvent"], heard["WarningEvent"]


class Reported:
    """Something with the field data in which every filter says how it went."""

    def number(self, name):
        return self.field_data[name][0]

    @property
    def status(self):
        return int(self.number("Status"))

    @property
    def message(self):
        return self.field_data["Message"][0]


@dataclass
class Result(Reported):
    """What came out of the filter, as plain arrays."""

    surface: vtkPolyData
    curves: vtkPolyData
    body: Mesh  # the surface's polygons as triangles
    cell_data: dict
    point_data: dict
    field_data: dict
    errors: list = field(default_factory=list)
    warnings: list = field(default_factory=list)

    @property
    def volume(self):
        return measures.volume(self.body)

    @property
    def area(self):
        return measures.area(self.body)

    @property
    def is_empty(self):
        return self.surface.GetNumberOfCells() == 0 and self.surface.GetNumberOfPoints() == 0

    @property
    def parents(self):
        """The input cells that the surface is made of: a set of (operand, cell)."""
        source, cell = self.cell_data.get("SourceId", []), self.cell_data.get("OriginalCellId", [])
        return set(zip(np.asarray(source).tolist(), np.asarray(cell).tolist()))

    def bytes(self):
        """Everything that must not depend on the number of threads."""
        return bytes_of(self.surface, self.curves)


def boolean(inputs, tools, operation, number_of_threads=None, **settings):
    """Run the filter; operands are meshes or vtkPolyData, `settings` go to its setters."""
    from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter

    tested = vtkPolyDataBooleanOperationFilter()
    getattr(tested, "SetOperationTo" + operation)()
    if number_of_threads is not None:
        tested.SetNumberOfThreads(number_of_threads)
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    for port, operands in enumerate((inputs, tools)):
        for operand in operands:
            data = polydata(operand) if isinstance(operand, Mesh) else operand
            tested.AddInputDataObject(port, data)
    return update(tested)


def update(tested):
    """Update a filter and collect what it gives and says."""
    errors, warnings = heard_from(tested)
    surface, curves = tested.GetOutputDataObject(0), tested.GetOutputDataObject(1)
    return Result(
        surface,
        curves,
        triangles_of(surface)[0],
        arrays_of(surface.GetCellData()),
        arrays_of(surface.GetPointData()),
        arrays_of(surface.GetFieldData()),
        errors,
        warnings,
    )


# ---- VTK's own filter --------------------------------------------------------------------------

VTK_OPERATIONS = {UNION: 0, INTERSECTION: 1, DIFFERENCE: 2}


def answer_of_vtk(first, second, operation, seconds=10):
    """One line on what vtkBooleanOperationPolyDataFilter makes of the same operands."""
    if operation not in VTK_OPERATIONS:
        return "has no such operation"
    task = {
        "operation": VTK_OPERATIONS[operation],
        "operands": [[b.points.tolist(), b.triangles.tolist()] for b in (first, second)],
    }
    try:
        done = subprocess.run(
            [sys.executable, __file__],
            input=json.dumps(task),
            capture_output=True,
            text=True,
            timeout=seconds,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return f"no answer in {seconds} s"
    if done.returncode != 0:
        return f"crashes (return code {done.returncode})"
    return done.stdout.strip()


def run_vtk_filter():
    """The other process: reads the task from standard input, prints the answer."""
    from vtkmodules.vtkCommonCore import vtkObject
    from vtkmodules.vtkFiltersGeneral import vtkBooleanOperationPolyDataFilter

    vtkObject.GlobalWarningDisplayOff()
    task = json.load(sys.stdin)
    peer = vtkBooleanOperationPolyDataFilter()
    peer.SetOperation(task["operation"])
    for port, operand in enumerate(task["operands"]):
        peer.SetInputDataObject(port, polydata(mesh(*operand)))
    peer.Update()
    body, _ = triangles_of(peer.GetOutput())
    print(
        f"volume {measures.volume(body):.12g}, {len(body.triangles)} triangles, "
        f"{measures.open_edges(body)} open, {measures.non_manifold_edges(body)} non-manifold edges"
    )


if __name__ == "__main__":
    run_vtk_filter()
