# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What every test of the filters gets: an end to hangs, and a table of VTK's own answers."""

import faulthandler

import pytest

SECONDS_BEFORE_A_TEST_HANGS = 300
ANSWERS = pytest.StashKey()


def pytest_configure(config):
    config.stash[ANSWERS] = []


@pytest.fixture(autouse=True)
def no_hang():
    """A test that does not come back ends the run, and shows where it was."""
    faulthandler.dump_traceback_later(SECONDS_BEFORE_A_TEST_HANGS, exit=True)
    yield
    faulthandler.cancel_dump_traceback_later()


@pytest.fixture
def beside(request, record_property):
    """Note the filter's answer and VTK's for the table that ends the run."""

    def note(claim, ours, vtk):
        record_property("filter", ours)
        record_property("VTK", vtk)
        request.config.stash[ANSWERS].append((claim, ours, vtk))

    return note


def pytest_terminal_summary(terminalreporter, config):
    if config.stash[ANSWERS]:
        terminalreporter.section("SurfaceBooleans beside vtkBooleanOperationPolyDataFilter")
        for claim, ours, vtk in config.stash[ANSWERS]:
            terminalreporter.write_line(f"{claim}\n    here: {ours}\n    VTK:  {vtk}")
