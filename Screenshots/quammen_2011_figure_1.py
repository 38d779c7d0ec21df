# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the paper's Figure 1 anew: why a distance field cannot tell where two surfaces meet.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/quammen_2011_figure_1.py

Black is where the distance to the cylinder, computed at the cone's points and taken as linear between them, is zero;
white is the intersection of the two surfaces. Thin lines are the cone's triangles.
"""

import pathlib

from surfacebooleans.vtk import vtkPolyDataDistance, vtkPolyDataIntersection
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkStripper, vtkTriangleFilter, vtkTubeFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCylinderSource
from offscreen import actor_of, look_parallel, save, white_room

HERE = pathlib.Path(__file__).resolve().parent
BODY, OTHER, BLACK, WHITE = (0.42, 0.58, 0.80), (0.85, 0.45, 0.35), (0.05, 0.05, 0.05), (1.0, 1.0, 1.0)


def cone():
    source = vtkConeSource()
    source.SetRadius(0.5), source.SetHeight(1.125), source.SetResolution(16), source.SetDirection(0, 0, 1)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    finer = vtkLinearSubdivisionFilter()
    finer.SetInputConnection(triangles.GetOutputPort())
    finer.SetNumberOfSubdivisions(2)
    return finer


def cylinder():
    source = vtkCylinderSource()
    source.SetRadius(0.2), source.SetHeight(1.4), source.SetResolution(64)
    placed = vtkTransform()
    placed.Translate(0.02, 0, -0.2)
    placed.RotateZ(-25)
    moved = vtkTransformPolyDataFilter()
    moved.SetInputConnection(source.GetOutputPort())
    moved.SetTransform(placed)
    return moved


def line(source, colour):
    joined = vtkStripper()
    joined.SetInputConnection(source.GetOutputPort())
    tube = vtkTubeFilter()
    tube.SetInputConnection(joined.GetOutputPort())
    tube.SetRadius(0.007)
    tube.SetNumberOfSides(24)
    drawn = actor_of(tube, colour)
    drawn.GetProperty().SetAmbient(0.6)
    return drawn


def scene():
    first, second = cone(), cylinder()
    distance = vtkPolyDataDistance()
    distance.SetInputConnection(0, first.GetOutputPort())
    distance.SetInputConnection(1, second.GetOutputPort())
    zero = vtkContourFilter()
    zero.SetInputConnection(distance.GetOutputPort())
    zero.SetInputArrayToProcess(0, 0, 0, 0, "Distance")
    zero.SetValue(0, 0.0)
    meeting = vtkPolyDataIntersection()
    meeting.SetInputConnection(0, first.GetOutputPort())
    meeting.SetInputConnection(1, second.GetOutputPort())

    body = actor_of(first, BODY)
    body.GetProperty().EdgeVisibilityOn()
    body.GetProperty().SetEdgeColor(0.66, 0.77, 0.92)
    tool = actor_of(second, OTHER)
    tool.GetProperty().SetOpacity(0.25)
    room = white_room((body, tool, line(zero, BLACK), line(meeting, WHITE)), key_light=0.8)
    look_parallel(room, position=(0.5, -4.0, 1.3), center=(0.06, 0, -0.12), up=(0, 0, 1), scale=0.66)
    return room


if __name__ == "__main__":
    save(HERE / "quammen-2011-figure-1.png", [scene()], (1000, 900))
