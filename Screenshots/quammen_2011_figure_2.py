# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the paper's Figure 2 anew: a box with three normals a corner, cut by another box.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/quammen_2011_figure_2.py

Gray is the box in front, cut along the curve (green) in which it meets the box in the back (outline). The arrows are
the normals in the result, one a point: gray at the corners, where the box came with three points each; orange where the
curve crosses an edge of the box, and the filter made two points, with the interpolated normal of either side.
"""

import pathlib

import numpy as np
from surfacebooleans.vtk import vtkPolyDataIntersection
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkCubeSource
from offscreen import actor_of, crease_actor, look_parallel, save, white_room

HERE = pathlib.Path(__file__).resolve().parent
GRAY, GREEN, ORANGE = (0.72, 0.74, 0.77), (0.10, 0.62, 0.25), (0.93, 0.49, 0.10)


def box(center):
    source = vtkCubeSource()  # three points, normals and texture coordinates a corner
    source.SetCenter(*center)
    source.SetXLength(1.0), source.SetYLength(1.0), source.SetZLength(1.0)
    source.Update()
    return source.GetOutput()


def arrows(split, chosen, colour):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(vtk_to_numpy(split.GetPoints().GetData())[chosen], deep=True))
    normals = numpy_to_vtk(vtk_to_numpy(split.GetPointData().GetNormals())[chosen], deep=True)
    at = vtkPolyData()
    at.SetPoints(points)
    at.GetPointData().SetNormals(normals)
    arrow = vtkArrowSource()
    arrow.SetTipResolution(32), arrow.SetShaftResolution(32)
    arrow.SetShaftRadius(0.035), arrow.SetTipRadius(0.1), arrow.SetTipLength(0.35)
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(at)
    glyphs.SetSourceConnection(arrow.GetOutputPort())
    glyphs.SetVectorModeToUseNormal()
    glyphs.SetScaleModeToDataScalingOff()
    glyphs.SetScaleFactor(0.26)
    return actor_of(glyphs, colour)


def scene():
    front, back = box((0, 0, 0)), box((0.6, 0.45, -0.4))
    cut = vtkPolyDataIntersection()
    cut.SetInputData(front)
    cut.SetToolData(back)
    cut.Update()
    split = cut.GetSplitInputOutput()
    points = vtk_to_numpy(split.GetPoints().GetData())
    on_curve = vtk_to_numpy(split.GetPointData().GetArray("SeamPoint")) == 1
    _, place, count = np.unique(points, axis=0, return_inverse=True, return_counts=True)
    doubled = count[place.reshape(-1)] > 1

    body = actor_of(split, GRAY)
    body.GetProperty().EdgeVisibilityOn()
    body.GetProperty().SetEdgeColor(0.55, 0.57, 0.60)
    tube = vtkTubeFilter()
    tube.SetInputConnection(cut.GetOutputPort(0))
    tube.SetRadius(0.011)
    tube.SetNumberOfSides(24)
    normals = (arrows(split, doubled & ~on_curve, GRAY), arrows(split, doubled & on_curve, ORANGE))
    outlines = (crease_actor(front, 30), crease_actor(back, 30))
    room = white_room((body, *outlines, actor_of(tube, GREEN), *normals), key_light=0.9)
    look_parallel(room, position=(4.4, 2.96, 3.6), center=(0.25, 0.16, -0.15), up=(0, 1, 0), scale=1.2)
    return room


if __name__ == "__main__":
    save(HERE / "quammen-2011-figure-2.png", [scene()], (1000, 900))
