# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of every filter's panel, and of the window with it; panels.sh runs this in ParaView's own Python.

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
PANEL_WIDTH = 430  # pixels


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


def show_advanced(wanted):
    button = widget("AdvancedButton", widget("propertiesPanel"))
    if button.isChecked() != wanted:
        button.click()
    settle()


def save_window(path, part=None):
    """What the screen shows, or the part of it that a widget fills."""
    command = ["import", "-window", "root"]
    if part:
        corner = part.mapToGlobal(QtCore.QPoint(0, 0))
        command += ["-crop", f"{part.width()}x{part.height()}+{corner.x()}+{corner.y()}", "+repage"]
    subprocess.check_call(command + [str(path)])


def save_panel(path):
    save_window(path, widget("PropertiesFrame", widget("propertiesPanel")))


def look_from(view, direction, up):
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = list(direction)
    view.CameraViewUp = list(up)
    simple.ResetCamera(view)


def picture(name):
    """The user has applied the filter to what the scene has as its inputs."""
    for source in list(simple.GetSources().values()):
        simple.Delete(source)
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.HideUnusedScalarBars(view)
    scene = filter_scenes.SCENES[name](MESHES)
    for source in scene.inputs.values():
        simple.Show(source, view)
    look_from(view, *scene.view)
    result = create(name, scene)
    apply()
    simple.SetActiveSource(result)
    settle()
    show_advanced(False)
    save_panel(FOLDER / f"{name}.png")
    save_window(FOLDER / f"{name}-window.png")
    show_advanced(True)
    save_panel(FOLDER / f"{name}-advanced.png")


def main():
    main_window().resizeDocks([widget("propertiesDock")], [PANEL_WIDTH], QtCore.Qt.Horizontal)
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
