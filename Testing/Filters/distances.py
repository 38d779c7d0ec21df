# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the distance filter and the implicit function on meshes."""

from booleans import arrays_of, polydata
from meshes import Mesh, mesh
from surfacebooleans.vtk import vtkImplicitPolyData, vtkPolyDataDistance

arrays = arrays_of


def cloud(points):
    """Points without cells."""
    return polydata(mesh(points, []))


def as_data(body):
    return polydata(body) if isinstance(body, Mesh) else body


def distance_filter(points, tool, **settings):
    """The filter, updated; `settings` go to its setters."""
    tested = vtkPolyDataDistance()
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    tested.SetInputDataObject(0, as_data(points))
    tested.SetInputDataObject(1, as_data(tool))
    tested.Update()
    return tested


def distances(points, tool, **settings):
    """The array Distance of the points."""
    return arrays(distance_filter(points, tool, **settings).GetOutput().GetPointData())["Distance"]


def implicit(tool):
    function = vtkImplicitPolyData()
    function.SetInput(as_data(tool))
    return function
