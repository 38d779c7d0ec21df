# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the help pages (F1), Plugin/Help: on the left what goes into a filter, on the right what comes out.

    . build/env.sh && xvfb-run -a -s -noreset pvpython Screenshots/help_pictures.py [FILTER...]    (needs imagemagick)
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from paraview import simple  # noqa: E402

import filter_scenes  # noqa: E402

FOLDER = HERE.parent / "Plugin" / "Help"
SIZE = [340, 300]  # of either half, in pixels
INPUT, TOOL = [0.45, 0.6, 0.85], [0.9, 0.6, 0.35]
NO_COLOUR = ("POINTS", None)
GROUPS = {"NURBSReader": "sources"}


def empty_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    return view


def look_from(view, scene):
    direction, up = scene.view
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = list(direction)
    view.CameraViewUp = list(up)
    if scene.near:
        view.SMProxy.ResetCamera(scene.near)
    else:
        view.CameraParallelProjection = 1
        simple.ResetCamera(view)
        view.CameraParallelScale *= scene.fit


def show_inputs(view, scene, opacity=1):
    for name, source in scene.inputs.items():
        display = simple.Show(source, view)
        simple.ColorBy(display, NO_COLOUR)
        display.DiffuseColor = display.AmbientColor = TOOL if name == "Tool" else INPUT
        display.Opacity = opacity
        display.LineWidth, display.RenderLinesAsTubes = 3, 1
        display.PointSize = 3


def show_result(view, scene, result):
    for port, representation in scene.shown:
        display = simple.Show(simple.OutputPort(result, port), view)
        display.Representation = representation
        display.LineWidth, display.PointSize, display.RenderLinesAsTubes = 4, 3, 1
        colour = scene.colour if port == scene.shown[0][0] else None
        simple.ColorBy(display, colour or NO_COLOUR)
        if colour:
            display.SetScalarBarVisibility(view, False)
        else:
            display.DiffuseColor = display.AmbientColor = [0.75, 0.05, 0.1]
    if scene.context:
        show_inputs(view, scene, opacity=0.2)


def draw(name, folder):
    scene = filter_scenes.SCENES[name](folder)
    result = getattr(simple, name)(**scene.inputs, **scene.settings)
    before, after = empty_view(), empty_view()
    show_inputs(before, scene)
    show_result(after, scene, result)
    halves = []
    for view in (before, after):
        if view is after or scene.inputs:
            look_from(view, scene)
            halves.append(str(folder / f"{len(halves)}.png"))
            simple.SaveScreenshot(halves[-1], view, ImageResolution=SIZE)
    path = FOLDER / f"{GROUPS.get(name, 'filters')}.{name}.png"
    subprocess.check_call(["convert", *halves, "+append", "-strip", "+dither", "-colors", "128", str(path)])


FOLDER.mkdir(exist_ok=True)
with tempfile.TemporaryDirectory() as temporary:
    for wanted in sys.argv[1:] or filter_scenes.SCENES:
        simple.ResetSession()
        draw(wanted, pathlib.Path(temporary))
sys.stdout.flush()
os._exit(0)  # pvpython ends in an error of the X server otherwise
