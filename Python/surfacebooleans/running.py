# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a filter as Python expects it: errors are raised, warnings warned, progress shown, and Ctrl-C stops it."""

import contextlib
import os
import re
import signal
import sys
import threading
import warnings

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkObject

from surfacebooleans.errors import SurfaceBooleansError, SurfaceBooleansWarning

PACKAGE_FOLDER = os.path.dirname(os.path.abspath(__file__))


def configure(algorithm, **settings):
    """Call ``Set<Name>(value)`` of a filter for each setting; a tuple, list or array gives several arguments."""
    for name, value in settings.items():
        arguments = [value] if isinstance(value, (bool, int, float, str)) else list(value)
        getattr(algorithm, "Set" + name)(*arguments)
    return algorithm


def update(algorithm, progress=False, work=None):
    """Run a filter, a reader or a writer.

    Parameters
    ----------
    algorithm : vtkAlgorithm
        With its inputs and settings.
    progress : bool or callable, optional
        True draws a bar (this needs tqdm); a callable gets the share that is done, in [0, 1], and the name of the
        stage.
    work : callable, optional
        What to call instead of ``algorithm.Update``, such as a writer's ``Write``.

    Raises
    ------
    SurfaceBooleansError
        With the filter's sentence.
    KeyboardInterrupt
        If Ctrl-C was pressed meanwhile; the filter has then given up its work in an orderly way. So has it after an
        exception of the callable `progress`, which is raised again.

    Warns
    -----
    SurfaceBooleansWarning
        With each warning of the filter.
    """
    heard = {"ErrorEvent": [], "WarningEvent": []}

    @calldata_type(VTK_STRING)
    def listen(_, event, text):
        heard[event].append(_sentence(text))

    if hasattr(algorithm, "SetController"):
        algorithm.SetController(None)  # a script in one process of several does not wait for the others
    for watched in (algorithm, algorithm.GetExecutive()):
        for event in heard:
            watched.AddObserver(event, listen)
    with _warnings_enabled(), _interruptible(algorithm), _progress_shown(algorithm, progress):
        (work or algorithm.Update)()
    for sentence in heard["WarningEvent"]:
        warnings.warn(sentence, SurfaceBooleansWarning, stacklevel=_level_of_caller())
    if heard["ErrorEvent"]:
        raise SurfaceBooleansError(heard["ErrorEvent"][0], _status(algorithm))


def _sentence(text):
    """A message of VTK without its first line, which names a place in the source, and without the object's address."""
    sentence = re.sub(r"\A\w+: In .*, line \d+\n\w+ \(\w+\): ", "", text).strip()
    silent = re.match(r"Algorithm (\w+) \(\w+\) returned failure", sentence)
    return f"{silent.group(1)} gave up and does not say why; what it was given may be damaged" if silent else sentence


def _status(algorithm):
    output = algorithm.GetOutputDataObject(0) if algorithm.GetNumberOfOutputPorts() else None
    array = output.GetFieldData().GetArray("Status") if output else None
    return int(array.GetValue(0)) if array and array.GetNumberOfValues() else -1


def _level_of_caller():
    """For ``warnings.warn``: how far up the first line is that is not of this package."""
    frame, level = sys._getframe(1), 1
    while frame.f_back and os.path.dirname(os.path.abspath(frame.f_code.co_filename)) == PACKAGE_FOLDER:
        frame, level = frame.f_back, level + 1
    return level


@contextlib.contextmanager
def _warnings_enabled():
    """Filters are silent, also towards observers, where somebody has turned VTK's messages off."""
    before = vtkObject.GetGlobalWarningDisplay()
    vtkObject.SetGlobalWarningDisplay(1)
    try:
        yield
    finally:
        vtkObject.SetGlobalWarningDisplay(before)


@contextlib.contextmanager
def _interruptible(algorithm):
    """Ctrl-C asks the filter to stop, and is raised when it has.

    Python's own way would not do: VTK ends the whole program where a callback is interrupted. Signals reach the main
    thread alone, and a program that handles or ignores Ctrl-C in its own way keeps doing so.
    """
    usual = signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if not usual or threading.current_thread() is not threading.main_thread():
        yield
        return
    pressed = []

    def stop(*_):
        pressed.append(True)
        algorithm.SetAbortExecuteAndUpdateTime()

    signal.signal(signal.SIGINT, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        if pressed:
            raise KeyboardInterrupt


@contextlib.contextmanager
def _progress_shown(algorithm, progress):
    """Hand progress on; without anybody to show it to, still listen, because signals are looked at on that occasion."""
    bar = _bar() if progress is True else contextlib.nullcontext(progress or None)
    failure = []
    with bar as show:

        def listen(*_):
            try:
                if show and not failure:
                    show(min(max(algorithm.GetProgress(), 0.0), 1.0), algorithm.GetProgressText() or "")
            except BaseException as error:  # it must not reach VTK, which would print it and go on
                failure.append(error)
                algorithm.SetAbortExecuteAndUpdateTime()

        observer = algorithm.AddObserver("ProgressEvent", listen)
        try:
            yield
        finally:
            algorithm.RemoveObserver(observer)
    if failure:
        raise failure[0]


@contextlib.contextmanager
def _bar():
    """A function that shows the share done and the stage as a bar on the terminal."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        raise ModuleNotFoundError("progress=True needs tqdm (pip install tqdm)", name="tqdm") from None
    with tqdm(total=100, bar_format="{desc:<20} {percentage:3.0f}% |{bar}| {elapsed}", leave=False) as bar:

        def show(share, stage):
            bar.set_description_str(stage, refresh=False)
            bar.n = round(100 * share)
            bar.refresh()

        yield show
