# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The kept state files of a pipeline of all filters, and a trace of the window, replayed in fresh processes of pvpython."""

import json
import os
import pathlib
import re
import subprocess
import xml.etree.ElementTree as XML

import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import outcome

HERE = pathlib.Path(__file__).resolve().parent
STATES = ("all_filters.pvsm", "all_filters_state.py")
SECONDS = 240


def start(*arguments, folder, **environment):
    """A fresh pvpython on a display of its own; relative file names start at the folder."""
    return subprocess.Popen(
        ["xvfb-run", "-a", "-s", "-noreset", "pvpython", *map(str, arguments)],
        cwd=folder,
        env={**os.environ, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def said_by(process):
    said, _ = process.communicate(timeout=SECONDS)
    return said


def finished(process):
    said = said_by(process)
    assert process.returncode == 0 and "ERR|" not in said, said


def outputs(folder):
    return json.loads((folder / "outcome.json").read_text())


def pixels(folder):
    return vtk_to_numpy(outcome.read_picture(folder).GetPointData().GetScalars())


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Where the pipeline was built by its script, and the kept states were replayed, with and without the plugin."""
    place = tmp_path_factory.mktemp("states")
    first = start(HERE / "all_filters.py", "first", folder=place)
    without = {s: start(HERE / "outcome.py", HERE / s, "none", folder=place, PV_PLUGIN_PATH="") for s in STATES}
    finished(first)
    for state, process in without.items():
        (place / f"{state}.said").write_text(said_by(process))
    replays = [start(HERE / "outcome.py", HERE / state, state, folder=place) for state in STATES]
    for replay in replays:
        finished(replay)
    return place


@pytest.mark.parametrize("state", STATES)
def test_the_data_are_equal_to_the_last_byte(folder, state):
    first = outputs(folder / "first")
    assert outputs(folder / state) == first
    assert {name for name, (_, cells) in first.items() if cells == 0} == {"Check 1", "Seam 2", "kitten.vtk 0"}


@pytest.mark.parametrize("state", STATES)
def test_the_pictures_are_equal(folder, state):
    first = pixels(folder / "first")
    assert (pixels(folder / state) == first).all()
    assert len({tuple(pixel) for pixel in first.tolist()}) > 500, "something is to be seen"


@pytest.mark.parametrize("state", STATES)
def test_every_filter_is_in_the_states(state):
    """Every proxy of ours that stands in a pipeline; writers do not."""
    proxies = [proxy.get("name") for file in (HERE.parents[1] / "XML").glob("*.xml") for proxy in XML.parse(file).iter("SourceProxy")]
    assert len(proxies) >= 12
    text = (HERE / state).read_text()
    for proxy in proxies:
        assert re.search(rf'type="{proxy}"|= {proxy}\(', text), proxy


@pytest.mark.parametrize("state", STATES)
def test_files_are_named_relative_to_where_paraview_runs(state):
    text = (HERE / state).read_text()
    names = re.findall(r"""["']([^"'\s]*/[^"'\s]*[.](?:vtk|step))["']""", text)
    assert len(set(names)) == 4 and all(name.startswith("data/") for name in names)


@pytest.mark.parametrize("state", STATES)
def test_without_the_plugin_one_sees_what_the_readme_tells(folder, state):
    """What ParaView says of the missing filters stands in the README word for word, so that a search finds it."""
    said = (folder / f"{state}.said").read_text()
    readme = " ".join((HERE.parents[1] / "README.md").read_text().split())
    wanted = {
        "all_filters.pvsm": "Could not create a proxy of group: filters type: SurfaceBoolean",
        "all_filters_state.py": "NameError: name 'SurfaceBoolean' is not defined",
    }[state]
    assert wanted in said.replace("PointSetSurface", "SurfaceBoolean"), said
    assert wanted in readme
