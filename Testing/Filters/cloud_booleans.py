# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs Point Set Boolean, and designed bodies to run it with."""

from dataclasses import dataclass, field

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkSphereSource

import clouds
import measures
from booleans import Reported, arrays_of, cells_of, heard_from, points_of, triangles_of
from meshes import Mesh

UNION, INTERSECTION, DIFFERENCE, REVERSE_DIFFERENCE = range(4)
OPERATIONS = (UNION, INTERSECTION, DIFFERENCE, REVERSE_DIFFERENCE)


@dataclass
class Result(Reported):
    """What came out of the filter, as plain arrays."""

    surface: vtkPolyData
    points: vtkPolyData
    curves: vtkPolyData
    body: Mesh
    point_data: dict
    cell_data: dict
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
        outputs = (self.surface, self.points, self.curves)
        return all(data.GetNumberOfPoints() == 0 and data.GetNumberOfCells() == 0 for data in outputs)

    @property
    def seam(self):
        """The points of the seam."""
        return points_of(self.curves)


def run(cloud, tool, operation=UNION, **settings):
    """Run the filter on data objects (None: no input); `settings` go to its setters."""
    from surfacebooleans.vtk import vtkPointSetBooleanFilter

    tested = vtkPointSetBooleanFilter()
    tested.SetOperation(operation)
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    for port, data in enumerate((cloud, tool)):
        if data is not None:
            tested.SetInputDataObject(port, data)
    return update(tested)


def update(tested):
    errors, warnings = heard_from(tested)
    surface, points, curves = (tested.GetOutputDataObject(port) for port in range(3))
    return Result(
        surface,
        points,
        curves,
        triangles_of(surface)[0],
        arrays_of(surface.GetPointData()),
        arrays_of(surface.GetCellData()),
        arrays_of(surface.GetFieldData()),
        errors,
        warnings,
    )


def made(source):
    source.Update()
    return source.GetOutput()


def box(lower, upper):
    source = vtkCubeSource()
    source.SetBounds(*np.stack([lower, upper], axis=1).ravel())
    source.SetOutputPointsPrecision(1)
    return made(source)


def ball(center, radius, across=200):
    source = vtkSphereSource()
    source.SetCenter(*center)
    source.SetRadius(radius)
    source.SetThetaResolution(across)
    source.SetPhiResolution(across // 2)
    source.SetOutputPointsPrecision(1)
    return made(source)


def rod(radius, height, sides=400):
    """A prism about y."""
    source = vtkCylinderSource()
    source.SetRadius(radius)
    source.SetHeight(height)
    source.SetResolution(sides)
    source.SetOutputPointsPrecision(1)
    return made(source)


def placed(body, at, angle, axis):
    """Turned about the origin by degrees, then moved there."""
    transform = vtkTransform()
    transform.Translate(*at)
    transform.RotateWXYZ(angle, *axis)
    moved = vtkTransformPolyDataFilter()
    moved.SetTransform(transform)
    moved.SetInputData(body)
    moved.SetOutputPointsPrecision(1)
    return made(moved)


def ball_cloud(count, radius=1.0):
    return clouds.cloud(*clouds.sphere(count, radius))


def open_edges_by_id(surface):
    """Edges of the output that are not used as often in one direction as in the other, by ids."""
    _, ids = cells_of(surface.GetPolys())
    corners = ids.reshape(-1, 3)
    edges = np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1).reshape(-1, 2)
    _, number = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True)
    forward = edges[:, 0] < edges[:, 1]
    return int(np.count_nonzero(np.bincount(number, forward) != np.bincount(number, ~forward)))


def facing(result, cells, normals):
    """The cosine between triangles and what their normals should be; those without area left out."""
    corners = result.body.points[result.body.triangles[cells]]
    turn = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(turn, axis=1)
    good = length > 0
    return np.einsum("ij,ij->i", turn[good] / length[good, None], normals[good])
