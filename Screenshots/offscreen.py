# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts here draw with: actors, a white room with light, and an offscreen window that becomes a .png."""

import vtkmodules.vtkRenderingFreeType  # noqa: F401  (the fonts)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the renderer)
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkGlyph3D, vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkSphereSource
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

INK = (0.12, 0.14, 0.18)


def connected(consumer, source, port=0):
    """A mapper or filter, of a vtkPolyData or of a filter's output."""
    if source.IsA("vtkDataObject"):
        consumer.SetInputData(source)
    else:
        consumer.SetInputConnection(source.GetOutputPort(port))
    return consumer


def actor_of(source, color=None, port=0):
    """An actor of a vtkPolyData or of a filter's output, in one colour; without one, the mapper is the caller's to set."""
    mapper = connected(vtkPolyDataMapper(), source, port)
    actor = vtkActor()
    actor.SetMapper(mapper)
    if color is not None:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(color)
    return actor


def color_cells(actor, array):
    """By a cell array; one of bytes holds the colours themselves."""
    mapper = actor.GetMapper()
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(array)
    mapper.SetColorModeToDirectScalars()


def color_by_source(actor, colors):
    """One colour for each operand, by the cell array of Surface Boolean; operands beyond the last share its colour."""
    mapper = actor.GetMapper()
    table = mapper.GetLookupTable()
    table.SetNumberOfTableValues(len(colors))
    for i, color in enumerate(colors):
        table.SetTableValue(i, *color)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("SourceId")
    mapper.SetScalarRange(0, len(colors) - 1)


def smooth_actor(source, crease):
    """Shaded smoothly but for creases sharper than that, in degrees."""
    normals = connected(vtkPolyDataNormals(), source)
    normals.SetFeatureAngle(crease)
    return actor_of(normals)


def result_actor(source, colors, crease, specular=0.15):
    """A result of Surface Boolean in the colours of its operands, a little shiny."""
    actor = smooth_actor(source, crease)
    color_by_source(actor, colors)
    actor.GetProperty().SetSpecular(specular)
    actor.GetProperty().SetSpecularPower(25)
    return actor


def crease_actor(source, angle):
    """A surface's creases and borders, as lines of ink."""
    creases = connected(vtkFeatureEdges(), source)
    creases.NonManifoldEdgesOff()
    creases.SetFeatureAngle(angle)
    creases.ColoringOff()
    actor = actor_of(creases, INK)
    actor.GetProperty().SetLineWidth(2)
    actor.GetProperty().LightingOff()
    draw_in_front(actor)
    return actor


def balls(cloud, radius):
    """A ball at each point."""
    ball = vtkSphereSource()
    ball.SetRadius(radius)
    each = vtkGlyph3D()
    each.SetInputData(cloud)
    each.SetSourceConnection(ball.GetOutputPort())
    each.ScalingOff()
    return each


def draw_in_front(actor):
    """Lines and points that lie on a surface, as if they were a little nearer to the eye."""
    mapper = actor.GetMapper()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -6)
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-6)


def text(words, x, y, size=17):
    """Words at a place, in pixels from the lower left corner of their renderer."""
    actor = vtkTextActor()
    actor.SetInput(words)
    actor.SetPosition(x, y)
    actor.GetTextProperty().SetFontSize(size)
    actor.GetTextProperty().SetColor(INK)
    return actor


def white_room(props, key_light=None, contrast=None):
    """A renderer of all that, on white, under a light kit; `contrast` is how much stronger its key light is than the others."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for prop in props:
        renderer.AddViewProp(prop)
    kit = vtkLightKit()
    if key_light is not None:
        kit.SetKeyLightIntensity(key_light)
    if contrast is not None:
        kit.SetKeyToFillRatio(contrast)
        kit.SetKeyToHeadRatio(contrast)
    kit.AddLightsToRenderer(renderer)
    return renderer


def look(renderer, direction, up=(0, 0, 1), zoom=1.0, center=None):
    """From a direction, so that all is in the picture, or what is around a center."""
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(direction)
    camera.SetViewUp(up)
    renderer.ResetCamera()
    if center is not None:
        away = [a - b for a, b in zip(camera.GetPosition(), camera.GetFocalPoint())]
        camera.SetFocalPoint(center)
        camera.SetPosition([a + b for a, b in zip(center, away)])
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()


def look_parallel(renderer, position, center, up, scale):
    """By parallel projection: `scale` is half of the picture's height."""
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(center)
    camera.SetPosition(position)
    camera.SetViewUp(up)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(scale)
    renderer.ResetCameraClippingRange()


def side_by_side(renderers, columns=None):
    """Gives each its part of the window, row by row from the upper left."""
    columns = columns or len(renderers)
    rows = -(-len(renderers) // columns)
    for i, renderer in enumerate(renderers):
        x, y = i % columns, rows - 1 - i // columns
        renderer.SetViewport(x / columns, y / rows, (x + 1) / columns, (y + 1) / rows)
    return renderers


def save(path, renderers, size):
    """Draw them in one window of `size` (width, height in pixels), and write it as a .png."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()
