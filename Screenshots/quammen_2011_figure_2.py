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
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the renderer)
from surfacebooleans.vtk import vtkPolyDataIntersection
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkGlyph3D, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkCubeSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

HERE = pathlib.Path(__file__).resolve().parent
GRAY, GREEN, ORANGE, INK = (0.72, 0.74, 0.77), (0.10, 0.62, 0.25), (0.93, 0.49, 0.10), (0.15, 0.17, 0.20)


def box(center):
    source = vtkCubeSource()  # three points, normals and texture coordinates a corner
    source.SetCenter(*center)
    source.SetXLength(1.0), source.SetYLength(1.0), source.SetZLength(1.0)
    source.Update()
    return source.GetOutput()


def actor(connection, colour, lit=True, width=1.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(connection)
    mapper.ScalarVisibilityOff()
    drawn = vtkActor()
    drawn.SetMapper(mapper)
    drawn.GetProperty().SetColor(colour)
    drawn.GetProperty().SetLineWidth(width)
    drawn.GetProperty().SetLighting(lit)
    return drawn


def outline(surface, width):
    creases = vtkFeatureEdges()
    creases.SetInputData(surface)
    creases.SetFeatureAngle(30)
    creases.ColoringOff()
    drawn = actor(creases.GetOutputPort(), INK, False, width)
    drawn.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()
    drawn.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(0, -6)
    return drawn


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
    return actor(glyphs.GetOutputPort(), colour)


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

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    surface = vtkPolyDataMapper()
    surface.SetInputData(split)
    surface.ScalarVisibilityOff()
    body = vtkActor()
    body.SetMapper(surface)
    body.GetProperty().SetColor(GRAY)
    body.GetProperty().EdgeVisibilityOn()
    body.GetProperty().SetEdgeColor(0.55, 0.57, 0.60)
    renderer.AddActor(body)
    renderer.AddActor(outline(front, 2.0))
    renderer.AddActor(outline(back, 2.0))
    tube = vtkTubeFilter()
    tube.SetInputConnection(cut.GetOutputPort(0))
    tube.SetRadius(0.011)
    tube.SetNumberOfSides(24)
    renderer.AddActor(actor(tube.GetOutputPort(), GREEN))
    renderer.AddActor(arrows(split, doubled & ~on_curve, GRAY))
    renderer.AddActor(arrows(split, doubled & on_curve, ORANGE))
    kit = vtkLightKit()
    kit.SetKeyLightIntensity(0.9)
    kit.AddLightsToRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0.25, 0.16, -0.15)
    camera.SetPosition(4.4, 2.96, 3.6)
    camera.SetViewUp(0, 1, 0)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(1.2)
    renderer.ResetCameraClippingRange()
    return renderer


def main(path):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(1000, 900)
    window.AddRenderer(scene())
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main(HERE / "quammen-2011-figure-2.png")
