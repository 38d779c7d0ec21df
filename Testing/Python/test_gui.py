# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims about the recipes for the window that need none: what is refused, and the macros. The rest: GUI/Macros.xml."""

import os
import pathlib
import re

import pytest
from paraview import simple
from surfacebooleans import gui

MACROS = sorted(pathlib.Path(os.environ["PV_MACRO_PATH"].split(":")[0]).iterdir())


@pytest.fixture(autouse=True)
def empty_pipeline():
    yield
    for source in list(simple.GetSources().values()):
        simple.Delete(source)


@pytest.mark.parametrize(
    "recipe, count, words",
    [
        ("boolean", 0, "Select two sources or more in the Pipeline Browser first.*Selected are 0"),
        ("boolean", 1, "Select two sources or more"),
        ("curves", 3, "Select one or two sources"),
        ("distance_map", 1, "Select two sources.*the second one is the surface"),
        ("live_tool", 1, "Select two sources.*can be dragged"),
        ("clip", 2, "Select one source"),
        ("point_cloud", 0, "Select one or two sources"),
    ],
)
def test_a_wrong_number_of_sources_is_told_not_raised(recipe, count, words, capfd):
    sources = [simple.Sphere() for _ in range(count)]
    before = len(simple.GetSources())
    assert getattr(gui, recipe)(sources=sources) is None
    told = capfd.readouterr().err
    assert re.search(words, told) and "Traceback" not in told
    assert len(simple.GetSources()) == before  # nothing is left in the pipeline


def test_the_selected_sources_are_taken(capfd):
    simple.SetActiveSource(simple.Sphere())
    assert gui.boolean("Union") is None
    assert "Selected are 1." in capfd.readouterr().err


def test_an_unknown_operation_is_a_value_error():
    with pytest.raises(ValueError):
        gui.boolean("Onion", [simple.Sphere(), simple.Box()])


@pytest.mark.parametrize("macro", MACROS, ids=lambda path: path.stem)
def test_a_macro_is_short_and_says_what_it_does_and_what_to_select(macro, capfd):
    text = macro.read_text()
    assert macro.suffix == ".py" and len(text.splitlines()) < 30  # each file of the folder becomes a button
    exec(compile(text, str(macro), "exec"), {"__name__": "__main__"})  # nothing is selected
    assert "in the Pipeline Browser first" in capfd.readouterr().err


def test_there_is_a_macro_for_each_recipe():
    assert len(MACROS) >= 5
    used = "".join(macro.read_text() for macro in MACROS)
    assert all(f"gui.{name}(" in used for name in ("boolean", "curves", "distance_map", "clip", "live_tool", "point_cloud"))
