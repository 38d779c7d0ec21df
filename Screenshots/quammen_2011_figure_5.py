# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the paper's Figure 5 anew: five pairs of solids, three operations, blue and red by origin.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/quammen_2011_figure_5.py

The solids are those that Testing/Filters/test_figure5.py measures, with facets three times as fine.
"""

import pathlib
import sys

import vtkmodules.vtkRenderingFreeType  # noqa: F401  (the labels' fonts)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the renderer)
from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataNormals
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
sys.path.insert(0, str(HERE.parent / "Testing" / "Filters"))

from booleans import polydata  # noqa: E402
from meshes import figure_5_pairs  # noqa: E402

OPERATIONS = ("Union", "Intersection", "Difference")
BLUE, RED, INK = (0.25, 0.48, 0.88), (0.90, 0.28, 0.23), (0.15, 0.17, 0.20)
CELL, MARGIN = 360, 44  # pixels: one picture, the strip of labels


def result_of(first, second, operation):
    boolean = vtkPolyDataBooleanOperationFilter()
    boolean.SetInputDataObject(0, polydata(first))
    boolean.SetInputDataObject(1, polydata(second))
    getattr(boolean, "SetOperationTo" + operation)()
    return boolean


def surface_actor(source):
    """The result shaded smoothly but for its creases, coloured by SourceId."""
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(source.GetOutputPort(0))
    normals.SetFeatureAngle(25)
    colours = vtkLookupTable()
    colours.SetNumberOfTableValues(2)
    colours.SetTableRange(0, 1)
    colours.SetTableValue(0, *BLUE)
    colours.SetTableValue(1, *RED)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("SourceId")
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetSpecular(0.15)
    actor.GetProperty().SetSpecularPower(30)
    return actor


def line_actor(connection, width):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(connection)
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -6)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(INK)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    return actor


def picture(pair, operation, viewport):
    source = result_of(*pair, operation)
    renderer = vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(surface_actor(source))
    creases = vtkFeatureEdges()
    creases.SetInputConnection(source.GetOutputPort(0))
    creases.BoundaryEdgesOff()
    creases.NonManifoldEdgesOff()
    creases.ManifoldEdgesOff()
    creases.SetFeatureAngle(25)
    renderer.AddActor(line_actor(creases.GetOutputPort(), 2.0))
    kit = vtkLightKit()
    kit.SetKeyLightIntensity(0.88)
    kit.SetKeyToFillRatio(1.6)
    kit.SetKeyToHeadRatio(1.4)
    kit.AddLightsToRenderer(renderer)
    look(renderer, pair)
    return renderer


def look(renderer, pair):
    """The same eye for the three results of a pair, at its union's centre."""
    points = [body.points for body in pair]
    lower = [min(p[:, k].min() for p in points) for k in range(3)]
    upper = [max(p[:, k].max() for p in points) for k in range(3)]
    center = [(a + b) / 2 for a, b in zip(lower, upper)]
    radius = sum((b - a) ** 2 for a, b in zip(lower, upper)) ** 0.5 / 2
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*center)
    camera.SetPosition(center[0] + 2.6, center[1] - 2.1, center[2] + 1.9)
    camera.SetViewUp(0, 0, 1)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(1.02 * radius)
    renderer.ResetCameraClippingRange()


def label(renderer, text, x, y, turned=False):
    actor = vtkTextActor()
    actor.SetInput(text)
    style = actor.GetTextProperty()
    style.SetFontSize(22)
    style.SetColor(INK)
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToCentered()
    style.SetOrientation(90 if turned else 0)
    actor.SetPosition(x, y)
    renderer.AddViewProp(actor)


def main(path):
    pairs = figure_5_pairs(fine=3)
    width, height = MARGIN + CELL * len(pairs), MARGIN + CELL * len(OPERATIONS)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(width, height)
    window.SetNumberOfLayers(2)
    labels = vtkRenderer()
    labels.SetBackground(1, 1, 1)
    window.AddRenderer(labels)
    for row, operation in enumerate(OPERATIONS):
        bottom = CELL * (len(OPERATIONS) - 1 - row)
        label(labels, operation.lower(), MARGIN / 2, bottom + CELL / 2, turned=True)
        for column, pair in enumerate(pairs.values()):
            left = MARGIN + CELL * column
            box = (left / width, bottom / height, (left + CELL) / width, (bottom + CELL) / height)
            window.AddRenderer(picture(pair, operation, box))
    for column, name in enumerate(pairs):
        label(
            labels, name.replace("-", " and "), MARGIN + CELL * (column + 0.5), height - MARGIN / 2
        )
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main(HERE / "quammen-2011-figure-5.png")
