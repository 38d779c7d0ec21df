# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what Surface Check finds on two meshes of libcgal-demo: an elephant with holes, and bones that run into each other.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/surface_check.py
"""

import pathlib
import sys

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (the words)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the renderer)
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "Testing" / "Filters")]

import meshes  # noqa: E402
from checks import BOUNDARY, SELF, TOUCHING, check  # noqa: E402

WIDTH, HEIGHT = 620, 560  # pixels of each half
SKIN, INK = (0.66, 0.76, 0.9), (0.12, 0.14, 0.18)
COLORS = {BOUNDARY: (217, 67, 59), TOUCHING: (20, 20, 24), SELF: (217, 67, 59)}


def surface_actor(found):
    """Cells that meet others are orange."""
    data = found.surface
    cells = np.tile((255 * np.array(SKIN)).astype(np.uint8), (data.GetNumberOfCells(), 1))
    cells[found.cell_data["SelfIntersections"] > 0] = (242, 153, 51)
    colors = numpy_to_vtk(cells, deep=True)
    colors.SetName("Colors")
    data.GetCellData().AddArray(colors)
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.ConsistencyOff()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("Colors")
    mapper.SetColorModeToDirectScalars()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.85)
    return actor


def defect_actor(found):
    kinds = found.defect_data["Defect"]
    colors = numpy_to_vtk(np.array([COLORS.get(kind, (0, 0, 0)) for kind in kinds], dtype=np.uint8), deep=True)
    colors.SetName("Colors")
    found.defects.GetCellData().AddArray(colors)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(found.defects)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("Colors")
    mapper.SetColorModeToDirectScalars()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -3)
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-6)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetLineWidth(4)
    actor.GetProperty().SetPointSize(11)
    actor.GetProperty().SetRenderPointsAsSpheres(True)
    actor.GetProperty().SetLighting(False)
    return actor


def words(text):
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.SetPosition(14, 12)
    actor.GetTextProperty().SetFontSize(17)
    actor.GetTextProperty().SetColor(INK)
    return actor


def half(name, text, direction, up, focus, zoom, place):
    found = check(meshes.cgal_mesh(name))
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in (surface_actor(found), defect_actor(found), words(text(found))):
        renderer.AddActor(actor)
    vtkLightKit().AddLightsToRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(direction)
    camera.SetViewUp(up)
    renderer.ResetCamera()
    camera.SetPosition(np.array(camera.GetPosition()) + focus)
    camera.SetFocalPoint(focus)
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()
    renderer.SetViewport(place / 2, 0, (place + 1) / 2, 1)
    return renderer


def of_holes(found):
    return f"{found.BoundaryLoopCount} loops of boundary edges, {found.NonManifoldPointCount} points where they touch"


def of_crossings(found):
    return f"{found.SelfIntersectionCount} pairs of triangles that cross"


def main():
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(2 * WIDTH, HEIGHT)
    window.AddRenderer(half("elephant-with-holes", of_holes, (0.9, 0.5, 2.4), (0, 1, 0), (0, 0, 0), 1.35, 0))
    window.AddRenderer(half("bones", of_crossings, (0.3, -2.4, 0.4), (0, 0, 1), (0, 0, 0), 1.3, 1))
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(HERE / "surface_check.png"))
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
