# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every filter can be stopped at any moment: soon, leaving nothing, and without a trace in the next update."""

import time

import numpy as np
import pytest

from every_filter import ABORTED, FILTERS, content, field_value, is_empty, outputs, run, status

SECONDS_TO_STOP = 2.0  # a few tenths where the machine has nothing else to do
MOMENTS = 4  # a filter and scene


class Stopping:
    """Asks a filter to stop at its n-th word of progress; when that was, and how far the filter had got."""

    def __init__(self, made, at):
        self.made, self.at, self.count, self.asked, self.share = made, at, 0, None, None
        self.observer = made.AddObserver("ProgressEvent", self.listen)

    def listen(self, *_):
        self.count += 1
        if self.count == self.at:
            self.asked, self.share = time.perf_counter(), self.made.GetProgress()
            self.made.SetAbortExecuteAndUpdateTime()

    def let_go(self):
        self.made.RemoveObserver(self.observer)
        self.made.SetAbortExecute(0)
        self.made.Modified()


def undisturbed(name, scene):
    """What the filter gives, and how often it tells of progress."""
    made = FILTERS[name].make(scene)
    heard = Stopping(made, at=None)
    errors, _ = run(made)
    assert not errors
    return content(made), heard.count


@pytest.mark.parametrize("scene", ["bodies", "large"])
@pytest.mark.parametrize("name", FILTERS)
def test_stopping_leaves_nothing_and_the_next_update_is_as_ever(name, scene, record_property):
    expected, words = undisturbed(name, scene)
    rng = np.random.default_rng(20230613)
    made = FILTERS[name].make(scene)
    waits, stopped = [], 0
    for at in sorted({1, *rng.integers(1, words, MOMENTS - 1, endpoint=True).tolist()}):
        stopping = Stopping(made, at)
        errors, warnings = run(made)
        if stopping.asked is not None:  # a second update prepares less, so it may have less to tell
            waits.append(time.perf_counter() - stopping.asked)
        if stopping.asked is not None and stopping.share < 1.0:
            stopped += 1
            assert is_empty(made), f"stopped at {stopping.share}"
            assert not errors and all("stopped" in field_value(data, "Message") for data in outputs(made)[:1])
            assert status(made) == ABORTED
        else:
            assert content(made) == expected
        stopping.let_go()
        errors, _ = run(made)
        assert not errors and content(made) == expected
        made.Modified()
    assert stopped > 0
    record_property("longest wait", max(waits))
    assert max(waits) < SECONDS_TO_STOP
