# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What goes into a recipe and comes out of it: VTK data sets, pyvista's meshes, or arrays of numpy.

A *mesh* is a vtkPolyData, a pyvista.PolyData, a composite data set of such (which counts as one surface), any other
data set of VTK (which counts as its boundary surface), or a pair ``(points, faces)``: float array of shape (n, 3), and
int array of shape (m, 3) for triangles, (m, 4) for quads, and so on, each listed counter-clockwise as seen from
outside.

What comes out is of the kind that went in first: pyvista for pyvista, VTK for VTK, arrays for arrays.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkDataObject,
    vtkDataObjectTree,
    vtkDataSet,
    vtkPlane,
    vtkPolyData,
)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter


def as_data(mesh):
    """A mesh or a cloud as VTK data.

    Parameters
    ----------
    mesh : vtkDataObject, (points, faces), or array_like of shape (n, 3)
        Data of VTK and pyvista are taken as they are and not copied. An array alone is a cloud of points, and a pair of
        arrays of the same shape (n, 3), both of floats, a cloud with normals.

    Raises
    ------
    TypeError
        If it is none of these.
    """
    if isinstance(mesh, vtkDataObject):
        return mesh
    if isinstance(mesh, tuple) and len(mesh) == 2 and np.ndim(mesh[0]) == 2:
        points, second = np.asarray(mesh[0]), np.asarray(mesh[1])
        if second.ndim == 2 and np.issubdtype(second.dtype, np.integer):
            return polydata(points, second)
        if second.ndim == 2 and second.shape == points.shape:
            return polydata(points, normals=second)
    elif isinstance(mesh, np.ndarray):
        return polydata(mesh)
    raise TypeError(
        f"a mesh is a vtkPolyData, a pyvista.PolyData or (points, faces) with points of shape (n, 3) and whole numbers "
        f"of shape (m, k) as faces, but this is {_kind(mesh)}"
    )


def as_surface(mesh):
    """A mesh as polygons: as `as_data`, and of grids the boundary."""
    data = as_data(mesh)
    if isinstance(data, vtkDataObjectTree):
        return _surfaces_of_blocks(data)
    if isinstance(data, vtkPolyData) or not isinstance(data, vtkDataSet):
        return data
    boundary = vtkDataSetSurfaceFilter()
    boundary.SetInputData(data)
    boundary.Update()
    return boundary.GetOutput()


def _surfaces_of_blocks(data):
    """The same blocks, with the same names, where those that are grids are their boundaries."""
    surfaces = data.NewInstance()
    surfaces.CopyStructure(data)
    for place in _places_of_blocks(data):
        surfaces.SetDataSet(place, as_surface(place.GetCurrentDataObject()))
    return surfaces


def _places_of_blocks(data):
    """The iterator of VTK, at one block after the other."""
    place = data.NewIterator()
    place.InitTraversal()
    while not place.IsDoneWithTraversal():
        yield place
        place.GoToNextItem()


def merged(mesh):
    """As `as_surface`, and of blocks all as one vtkPolyData."""
    surfaces = as_surface(mesh)
    if not isinstance(surfaces, vtkDataObjectTree):
        return surfaces
    joiner = vtkAppendPolyData()
    for place in _places_of_blocks(surfaces):
        joiner.AddInputData(place.GetCurrentDataObject())
    joiner.Update()
    return joiner.GetOutput()


def as_list(meshes):
    """None, one mesh or a list of meshes, as a list."""
    if meshes is None:
        return []
    return meshes if isinstance(meshes, list) else [meshes]


def as_plane(plane):
    """A plane as ``(origin, normal)``, each three floats; None if it is no plane.

    Parameters
    ----------
    plane : vtkPlane, pair of three numbers each, or six numbers

    Raises
    ------
    ValueError
        If the normal is zero.
    """
    if isinstance(plane, vtkPlane):
        plane = (plane.GetOrigin(), plane.GetNormal())
    try:
        numbers = np.asarray(plane, dtype=float)
    except (TypeError, ValueError):
        return None
    if numbers.shape not in ((2, 3), (6,)):
        return None
    numbers = numbers.reshape(6).tolist()
    if not any(numbers[3:]):
        raise ValueError("the normal of a plane must not be zero")
    return tuple(numbers[:3]), tuple(numbers[3:])


def polydata(points, faces=None, normals=None):
    """A vtkPolyData of copies of arrays; without faces it is a cloud.

    Parameters
    ----------
    points : array_like of float, shape (n, 3)
    faces : array_like of int, shape (m, k), optional
        Indices of points.
    normals : array_like of float, shape (n, 3), optional
        At the points.

    Returns
    -------
    vtkPolyData

    Raises
    ------
    TypeError
        If the points have another shape.
    """
    points = np.asarray(points)
    if points.ndim != 2 or points.shape[1] != 3:
        raise TypeError(f"points have the shape (n, 3), but these have {points.shape}")
    if points.dtype != np.float32:
        points = points.astype(np.float64)
    result = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    result.SetPoints(coordinates)
    if faces is not None:
        faces = np.ascontiguousarray(faces, dtype=np.int64)
        offsets = np.arange(len(faces) + 1, dtype=np.int64) * faces.shape[1]
        cells = vtkCellArray()
        cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(faces.ravel(), deep=True))
        result.SetPolys(cells)
    if normals is not None:
        array = numpy_to_vtk(np.ascontiguousarray(normals, dtype=np.float64), deep=True)
        array.SetName("Normals")
        result.GetPointData().SetNormals(array)
    return result


def result(data, first_input, lines=False):
    """A copy of a filter's output, free of the filter, of the kind that `first_input` is.

    Arrays stand for a surface, `(points, triangles)`, or, if `lines`, for curves: a list of arrays of shape (k, 3).
    """
    free = data.NewInstance()
    free.ShallowCopy(data)
    pyvista = sys.modules.get("pyvista")
    if pyvista and isinstance(first_input, pyvista.DataObject):
        return pyvista.wrap(free)
    if isinstance(first_input, vtkDataObject) or not isinstance(data, vtkPolyData):
        return free
    return lines_of(free) if lines else faces_of(free)


def points_of(data):
    """The points of a vtkPointSet: float array of shape (n, 3)."""
    return vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else np.zeros((0, 3))


def faces_of(data):
    """The polygons of a vtkPolyData, cut into triangles: ``(points, triangles)``, of shapes (n, 3) and (m, 3)."""
    cutter = vtkTriangleFilter()
    cutter.SetInputData(data)
    cutter.PassLinesOff()
    cutter.PassVertsOff()
    cutter.Update()
    triangles = cutter.GetOutput()
    ids = triangles.GetPolys().GetConnectivityArray()
    return points_of(triangles), vtk_to_numpy(ids).reshape(-1, 3) if ids.GetNumberOfValues() else np.zeros((0, 3), int)


def lines_of(data):
    """The polylines of a vtkPolyData: a list of float arrays of shape (k, 3), one a line."""
    lines = data.GetLines()
    offsets, ids = (vtk_to_numpy(a) for a in (lines.GetOffsetsArray(), lines.GetConnectivityArray()))
    points = points_of(data)
    return [points[ids[begin:end]] for begin, end in zip(offsets[:-1], offsets[1:])]


def fields_of(data):
    """The field data of a result, which say how the filter fared.

    Parameters
    ----------
    data : vtkDataObject
        Of VTK or pyvista.

    Returns
    -------
    dict
        Arrays of numbers, lists of texts; a single value stands for itself. Such as ``Status`` (0: all is well),
        ``Message``, ``ResultVolume`` (unit of the points cubed), ``StageSeconds``.
    """
    fields, result = data.GetFieldData(), {}
    for k in range(fields.GetNumberOfArrays()):
        array = fields.GetAbstractArray(k)
        if array is None or not array.GetName():
            continue
        if array.IsNumeric():
            values = vtk_to_numpy(fields.GetArray(k)) if array.GetNumberOfValues() else np.zeros(0)
        else:
            values = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
        result[array.GetName()] = values[0] if len(values) == 1 and np.ndim(values[0]) == 0 else values
    return result


def _kind(thing):
    if isinstance(thing, (tuple, list)):
        return f"a {type(thing).__name__} of {', '.join(_kind(part) for part in thing[:3]) or 'nothing'}"
    if isinstance(thing, np.ndarray):
        return f"an array of {thing.dtype} of shape {thing.shape}"
    return f"a {type(thing).__name__}"
