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
GROUPS = {"NURBSReader": "sources"}


def empty_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    return view


def draw(name, folder):
    scene = filter_scenes.SCENES[name](folder)
    result = getattr(simple, name)(**scene.inputs, **scene.settings)
    before, after = empty_view(), empty_view()
    filter_scenes.show_inputs(before, scene)
    filter_scenes.show_result(after, scene, result)
    halves = []
    for view in (before, after):
        if view is after or scene.inputs:
            filter_scenes.look_from(view, scene)
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
