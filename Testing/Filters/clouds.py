# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds of points: on shapes whose distance is a formula, and CGAL's scans; and runs of the filter on them."""

import tarfile
from dataclasses import dataclass, field

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from booleans import Reported, arrays_of, bytes_of, heard_from, points_of, triangles_of
from meshes import CGAL_DATA


def sphere(count, radius=1.0):
    """Evenly in a spiral; points and unit normals."""
    i = np.arange(count)
    z = 1 - (2 * i + 1) / count
    r = np.sqrt(1 - z * z)
    turn = i * np.pi * (3 - np.sqrt(5))
    normals = np.stack([r * np.cos(turn), r * np.sin(turn), z], axis=1)
    return radius * normals, normals


def torus(count, rng, ring=1.0, tube=0.4):
    """At random, evenly in the area."""
    a, b = rng.uniform(0, 2 * np.pi, (2, 4 * count))
    w = rng.uniform(size=4 * count)
    kept = np.flatnonzero(w < (ring + tube * np.cos(b)) / (ring + tube))[:count]
    a, b = a[kept], b[kept]
    normals = np.stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)], axis=1)
    centers = ring * np.stack([np.cos(a), np.sin(a), 0 * a], axis=1)
    return centers + tube * normals, normals


def distance_to_torus(points, ring=1.0, tube=0.4):
    return np.hypot(np.hypot(points[:, 0], points[:, 1]) - ring, points[:, 2]) - tube


def cylinder(count, rng, radius=0.5, height=2.0):
    """An open tube about z."""
    a = rng.uniform(0, 2 * np.pi, count)
    normals = np.stack([np.cos(a), np.sin(a), 0 * a], axis=1)
    points = radius * normals
    points[:, 2] = rng.uniform(-height / 2, height / 2, count)
    return points, normals


def plane(across):
    """A grid over the unit square."""
    x, y = np.meshgrid(np.linspace(0, 1, across), np.linspace(0, 1, across))
    points = np.stack([x.ravel(), y.ravel(), np.zeros(across * across)], axis=1)
    return points, np.tile([0.0, 0.0, 1.0], (across * across, 1))


def cgal_cloud(name):
    """Points, and normals or None, of a file of data/points_3 in Debian's libcgal-demo."""
    with tarfile.open(CGAL_DATA) as archive:
        text = archive.extractfile(f"data/points_3/{name}").read().decode()
    rows = np.array([[float(w) for w in line.split()] for line in text.splitlines() if line.split()])
    return rows[:, :3], rows[:, 3:6] if rows.shape[1] >= 6 else None


def cloud(points, normals=None):
    """A vtkPolyData of points only."""
    data = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float).reshape(-1, 3), deep=True))
    data.SetPoints(coordinates)
    if normals is not None:
        array = numpy_to_vtk(np.ascontiguousarray(normals, dtype=float), deep=True)
        array.SetName("Normals")
        data.GetPointData().SetNormals(array)
    return data


def cube(count, rng):
    """The surface of a cube of edge one about the origin, at random."""
    face = rng.integers(0, 6, count)
    each, axis, side = np.arange(count), face % 3, np.where(face < 3, -1.0, 1.0)
    points, normals = np.zeros((count, 3)), np.zeros((count, 3))
    normals[each, axis] = side
    points[each, axis] = 0.5 * side
    points[each, (axis + 1) % 3], points[each, (axis + 2) % 3] = rng.uniform(-0.5, 0.5, (2, count))
    return points, normals


@dataclass
class Result(Reported):
    """What came out of the filter, as plain arrays."""

    data: vtkPolyData
    points: np.ndarray
    arrays: dict
    field_data: dict
    mesh_data: vtkPolyData
    mesh: object  # a meshes.Mesh
    mesh_arrays: dict
    errors: list = field(default_factory=list)
    warnings: list = field(default_factory=list)

    @property
    def is_empty(self):
        return all(d.GetNumberOfPoints() == 0 and d.GetNumberOfCells() == 0 for d in (self.data, self.mesh_data))

    def bytes(self):
        return bytes_of(self.data, self.mesh_data)


def surface_of(points, normals=None, **settings):
    """Run the filter on arrays; `settings` go to its setters."""
    return run(cloud(points, normals), **settings)


def run(data, **settings):
    """Run the filter on any data object (None: no input)."""
    from surfacebooleans.vtk import vtkPointSetSurfaceFilter

    tested = vtkPointSetSurfaceFilter()
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    if data is not None:
        tested.SetInputDataObject(0, data)
    return update(tested)


def update(tested):
    errors, warnings = heard_from(tested)
    points, mesh = tested.GetOutputDataObject(0), tested.GetOutputDataObject(1)
    return Result(
        points,
        points_of(points),
        arrays_of(points.GetPointData()),
        arrays_of(points.GetFieldData()),
        mesh,
        triangles_of(mesh)[0],
        arrays_of(mesh.GetPointData()),
        errors,
        warnings,
    )


def implicit(points, normals=None, **settings):
    """The implicit function of a cloud."""
    from surfacebooleans.vtk import vtkMovingLeastSquaresSurface

    surface = vtkMovingLeastSquaresSurface()
    surface.SetInput(cloud(points, normals))
    for name, value in settings.items():
        getattr(surface, "Set" + name)(value)
    return surface
