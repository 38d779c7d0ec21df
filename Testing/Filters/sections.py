# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs Point Set Intersection, and gives its curves as plain arrays."""

from dataclasses import dataclass, field

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData

import meshes
from booleans import Reported, arrays_of, bytes_of, cells_of, heard_from, points_of, polydata


@dataclass
class Curves(Reported):
    data: vtkPolyData
    points: np.ndarray
    lines: list  # of arrays of point ids
    of_points: dict
    of_curves: dict
    field_data: dict
    errors: list = field(default_factory=list)
    warnings: list = field(default_factory=list)

    def bytes(self):
        return bytes_of(self.data)


def plane_section(data, origin=(0, 0, 0), normal=(0, 0, 1), **settings):
    """The filter on a plane; without a normal, on none."""
    tested = filter_of(data, settings)
    if normal is not None:
        plane = vtkPlane()
        plane.SetOrigin(origin)
        plane.SetNormal(normal)
        tested.SetPlane(plane)
    return update(tested)


def curves_of(data, tool, **settings):
    """The filter on any data objects; a meshes.Mesh is made a vtkPolyData, None is no data."""
    tested = filter_of(data, settings)
    tested.SetToolData(polydata(tool) if isinstance(tool, meshes.Mesh) else tool)
    return update(tested)


def filter_of(data, settings):
    """`settings` go to its setters; None: no connection."""
    from surfacebooleans.vtk import vtkPointSetIntersectionFilter

    tested = vtkPointSetIntersectionFilter()
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    if data is not None:
        tested.SetInputDataObject(0, data)
    return tested


def update(tested):
    errors, warnings = heard_from(tested)
    data = tested.GetOutput()
    starts, ids = cells_of(data.GetLines())
    return Curves(
        data,
        points_of(data),
        [ids[a:b] for a, b in zip(starts[:-1], starts[1:])],
        arrays_of(data.GetPointData()),
        arrays_of(data.GetCellData()),
        arrays_of(data.GetFieldData()),
        errors,
        warnings,
    )


def values_at(data, points):
    """The cloud's function, by the implicit function; NaN where the scan ends."""
    from surfacebooleans.vtk import vtkMovingLeastSquaresSurface

    surface = vtkMovingLeastSquaresSurface()
    surface.SetInput(data)
    return np.array([surface.EvaluateFunction(p) if surface.IsDefined(p) else np.nan for p in points])
