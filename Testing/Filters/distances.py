# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the distance filter and the implicit function on meshes."""

from booleans import arrays_of, heard_from, polydata
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
    tested = prepared(vtkPolyDataDistance(), settings, points, tool)
    tested.Update()
    return tested


def prepared(tested, settings, *inputs):
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    for port, data in enumerate(inputs):
        if data is not None:
            tested.SetInputDataObject(port, as_data(data))
    return tested


def quietly(points, tool, **settings):
    """As distance_filter, with what it says in `heard` and not on the screen."""
    return listened_to(prepared(vtkPolyDataDistance(), settings, points, tool))


def listened_to(tested):
    errors, warnings = heard_from(tested)
    tested.heard = {"ErrorEvent": errors, "WarningEvent": warnings}
    return tested


def distances(points, tool, **settings):
    """The array Distance of the points."""
    return arrays(distance_filter(points, tool, **settings).GetOutput().GetPointData())["Distance"]


def implicit(tool):
    function = vtkImplicitPolyData()
    function.SetInput(as_data(tool))
    return function
