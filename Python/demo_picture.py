# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The demos' pictures: the operands on the left, the result on the right, coloured by origin."""

from paraview import simple

BLUE, PALE, RED = [0.22, 0.47, 0.86], [0.80, 0.86, 0.94], [0.90, 0.20, 0.15]
INK = [0.08, 0.10, 0.16]
SIZE = [1800, 1200]  # pixels
RIGHT = (0.985, 0.0, -0.172)  # of the camera below, so that both halves look the same
APART = 0.44


def make_view():
    view = simple.CreateView("RenderView", registrationName="Demo")
    layout = simple.CreateLayout("Demo")  # or ParaView would not show the view of the state
    simple.AssignViewToLayout(view=view, layout=layout)
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    view.KeyLightIntensity = 0.95
    view.KeyLightElevation = 45
    view.KeyLightAzimuth = -30
    view.KeyLightWarmth = 0.55
    view.FillLightKFRatio = 3
    view.UseFXAA = 1
    view.UseAmbientOcclusion = 1
    view.UseSSAODefaultPresets = 0
    view.Radius = 0.12  # how far away a surface still casts a soft shadow
    view.KernelSize = 128
    view.Bias = 0.004
    view.Blur = 1
    return view


def aim(view):
    """Last, as the first render looks at everything shown."""
    view.CameraPosition = [0.735, 0.545, 4.0]
    view.CameraFocalPoint = [0.035, -0.105, 0]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.645


def show(source, view, side, color=None):
    display = simple.Show(source, view)
    display.Representation = "Surface"
    move(display, [side * APART * component for component in RIGHT])
    display.Ambient = 0.08
    display.Specular = 0.3
    display.SpecularPower = 40
    if color:
        display.ColorArrayName = ["POINTS", ""]
        display.AmbientColor = display.DiffuseColor = color
    return display


def move(display, place):
    """Draw it elsewhere."""
    name = "Position" if "Position" in display.ListProperties() else "Translation"  # from ParaView 5.13 on
    setattr(display, name, place)


def color_by_source(display, colors):
    """One colour for each operand, by the cell array that Surface Boolean makes."""
    simple.ColorBy(display, ("CELLS", "SourceId"))
    table = simple.GetColorTransferFunction("SourceId")
    table.InterpretValuesAsCategories = 1
    table.Annotations = [text for i in range(len(colors)) for text in (str(i), str(i))]
    table.IndexedColors = [component for color in colors for component in color]


def draw(path, operands, result):
    view = make_view()
    bodies, tools = operands
    colors = [BLUE, *[PALE] * (len(bodies) - 1), *[RED] * len(tools)]
    for operand, color in zip(bodies + tools, colors):
        show(operand, view, -1, color)

    color_by_source(show(result, view, 1), colors)
    curves = simple.Tube(registrationName="Seams", Input=simple.OutputPort(result, 1))
    curves.Radius = 0.0018
    curves.NumberofSides = 12
    show(curves, view, 1, INK)

    simple.Render(view)
    aim(view)
    simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)


def draw_scan(path, scan, body, result):
    """The cloud as points over the designed body; beside it what they are joined to."""
    view = make_view()
    apart = 0.62
    points = show(scan, view, -1, BLUE)
    points.Representation = "Point Gaussian"
    points.GaussianRadius = 0.0062
    smooth = simple.GenerateSurfaceNormals(registrationName="Smooth", Input=result, FeatureAngle=40)
    smooth.ComputeCellNormals = 0
    solid = show(smooth, view, 1)
    color_by_source(solid, [BLUE, PALE])
    designed = show(body, view, -1, PALE)
    seam = simple.Tube(registrationName="Seam", Input=simple.OutputPort(result, 2))
    seam.Radius = 0.006
    seam.NumberofSides = 12
    curve = show(seam, view, 1, RED)
    for display, side in ((points, -1), (designed, -1), (solid, 1), (curve, 1)):
        move(display, [side * apart, 0, 0])
    simple.Render(view)
    view.CameraPosition = [0.9, 0.75, 5.0]
    view.CameraFocalPoint = [0.0, -0.86, 0]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 1.46
    simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)
