# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims about long work: one can see how far it is, and stop it."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest
import surfacebooleans as sb

import booleans
import meshes

SECONDS_TO_STOP = 5  # generous: the machine may be busy; it is a few tenths otherwise


@pytest.fixture(scope="module")
def large():
    """Two surfaces that meet nearly everywhere: a second of work or so."""
    body = meshes.icosphere(6)
    return booleans.polydata(body), booleans.polydata(meshes.moved(body, (1e-3, 2e-3, 3e-3)))


def test_progress_goes_up_to_one_and_names_the_stages():
    told = []
    balls = [booleans.polydata(meshes.moved(meshes.icosphere(4), (x, 0, 0))) for x in (0, 0.5)]
    sb.boolean(*balls, progress=lambda share, stage: told.append((share, stage)))
    shares = [share for share, _ in told]
    assert shares == sorted(shares) and shares[-1] == 1
    assert {"Near pairs", "Contacts", "Cuts", "Winding numbers"} <= {stage for _, stage in told}


class Enough(Exception):
    pass


def test_an_exception_of_the_listener_stops_the_filter_and_comes_through(large):
    told = []

    def listen(share, stage):
        told.append(share)
        if stage == "Near pairs":
            raise Enough

    with pytest.raises(Enough):
        sb.boolean(*large, progress=listen)
    assert max(told) < 0.5  # nothing is told, and nothing done, after it


def interrupted_after(seconds, work):
    """Press Ctrl-C meanwhile; how long it took to come through."""
    # Another process presses it: VTK lets no other thread of Python run.
    press = subprocess.Popen(
        ["sh", "-c", f"sleep {seconds}; kill -INT {os.getpid()}; date +%s.%N"], stdout=subprocess.PIPE
    )
    with pytest.raises(KeyboardInterrupt):
        work()
    return time.time() - float(press.communicate()[0])


def test_ctrl_c_stops_a_filter_in_the_midst_of_a_stage(large):
    start = time.time()
    sb.boolean(*large)
    whole = time.time() - start
    waited = interrupted_after(0.3 * whole, lambda: [sb.boolean(*large) for _ in range(20)])
    assert waited < SECONDS_TO_STOP
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert sb.measure(sb.boolean(*large, "difference"))["closed"]  # the next one is not affected


def test_a_handler_of_ones_own_is_left_in_place(large):
    pressed = []
    signal.signal(signal.SIGINT, lambda *_: pressed.append(True))
    try:
        press = subprocess.Popen(["sh", "-c", f"sleep 0.1; kill -INT {os.getpid()}"])
        sb.boolean(*large)
        press.wait()
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    assert pressed == [True]


def test_recipes_work_in_threads():
    box, found = booleans.polydata(meshes.cube()), []
    other = booleans.polydata(meshes.cube(0.5, (0.5, 0, 0)))
    threads = [threading.Thread(target=lambda: found.append(sb.boolean(box, other))) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [sb.measure(surface)["volume"] for surface in found] == [pytest.approx(1.0625)] * 2


def test_without_tqdm_a_bar_is_refused_with_a_hint():
    code = (
        "import sys; sys.modules['tqdm'] = None; import surfacebooleans as sb, numpy as np; "
        "sb.point_set_points(np.eye(3), progress=True)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert "ModuleNotFoundError: progress=True needs tqdm (pip install tqdm)" in done.stderr
