# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the window with every filter's panel; panels.sh runs this in ParaView's own Python.

PyQt5 (Debian: python3-pyqt5) reaches the widgets of the window that this runs in.
"""

import os
import pathlib
import subprocess
import sys
import traceback

from paraview import simple
from PyQt5 import QtCore, QtWidgets

import filter_scenes

FOLDER = pathlib.Path(os.environ["SCREENSHOT_FOLDER"])
MESHES = pathlib.Path(os.environ["SCREENSHOT_MESHES"])
PANEL_WIDTH, BROWSER_HEIGHT = 400, 130  # pixels


def main_window():
    return next(w for w in QtWidgets.QApplication.topLevelWidgets() if w.objectName() == "pqClientMainWindow")


def widget(name, parent=None):
    return (parent or main_window()).findChild(QtWidgets.QWidget, name)


def settle():
    """Everything that the window still wants to do: layout, rendering, timers that have run out."""
    for _ in range(20):
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 50)


def create(name, scene):
    """The filter of the menu on the scene's inputs, or its reader, before Apply."""
    if not scene.inputs:
        reader = getattr(simple, name)(registrationName=name, **scene.settings)
        simple.SetActiveSource(reader)
        return reader
    simple.SetActiveSource(scene.inputs["Input"])
    settle()
    if "Tool" in scene.inputs:
        # The dialog that asks for the inputs is left as it comes up; the Tool follows below.
        QtCore.QTimer.singleShot(500, lambda: QtWidgets.QApplication.activeModalWidget().accept())
    menu = main_window().findChild(QtWidgets.QMenu, "menuFilters")
    next(a for a in menu.findChildren(QtWidgets.QAction, name)).trigger()
    settle()
    result = simple.GetActiveSource()
    for property_name, value in {**scene.inputs, **scene.settings}.items():
        setattr(result, property_name, value)
    settle()
    return result


def apply():
    widget("Accept", widget("propertiesPanel")).click()
    settle()


def save_window(path):
    """What the screen shows, in few colours."""
    subprocess.check_call(["import", "-window", "root", "-strip", "+dither", "-colors", "200", f"png8:{path}"])


def picture(name):
    """The user has applied the filter to what the scene has as its inputs."""
    for source in list(simple.GetSources().values()):
        simple.Delete(source)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    simple.HideUnusedScalarBars(view)
    scene = filter_scenes.SCENES[name](MESHES)
    for source in scene.inputs.values():
        simple.Show(source, view)
    filter_scenes.look_from(view, scene)
    result = create(name, scene)
    apply()
    for source in scene.inputs.values():
        simple.Hide(source, view)
    filter_scenes.show_result(view, scene, result)
    simple.HideUnusedScalarBars(view)
    for port in range(result.SMProxy.GetNumberOfOutputPorts()):
        if port not in dict(scene.shown):
            simple.Hide(simple.OutputPort(result, port), view)
    filter_scenes.look_from(view, scene)
    simple.SetActiveSource(result)
    simple.Render(view)
    settle()
    save_window(FOLDER / f"{name}.png")


def main():
    main_window().resizeDocks([widget("propertiesDock")], [PANEL_WIDTH], QtCore.Qt.Horizontal)
    main_window().resizeDocks([widget("pipelineBrowserDock")], [BROWSER_HEIGHT], QtCore.Qt.Vertical)
    for name in os.environ.get("SCREENSHOT_FILTERS", " ".join(filter_scenes.SCENES)).split():
        picture(name)


def fail(*exception):
    """The window swallows exceptions otherwise, and stays open."""
    traceback.print_exception(*exception, file=sys.__stderr__)
    os._exit(1)


sys.excepthook = fail  # that of the timers
try:
    main()
except BaseException:
    fail(*sys.exc_info())
os._exit(0)  # without a question about what is not saved
