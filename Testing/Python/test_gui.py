# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims about the recipes for the window that need none: what is refused, and the macros. The rest: GUI/Macros*.xml, GUI/ToolBar*.xml."""

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
        ("check", 2, "Select one source.*the surface to check"),
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


@pytest.mark.parametrize(
    "recipe, sources, words",
    [
        ("boolean", (simple.Sphere, simple.Wavelet), "cannot be the Tool of Surface Boolean, which takes surfaces"),
        ("boolean", (simple.Wavelet, simple.Sphere), "cannot be the Input of Surface Boolean"),
        ("curves", (simple.Wavelet,), "cannot be the Input of Surface Intersection"),
        ("distance_map", (simple.Sphere, simple.Wavelet), "cannot be the Tool of Surface Distance"),
        ("clip", (simple.Wavelet,), "cannot be the Input of Closed Surface Clip"),
        ("check", (simple.Wavelet,), "cannot be the Input of Surface Check"),
        ("point_cloud", (simple.Wavelet,), "cannot be the Input of Point Set Surface"),
        ("live_tool", (simple.Sphere, simple.Wavelet), "cannot be the Tool of Surface Boolean"),
    ],
)
def test_what_is_no_surface_is_told_by_its_name(recipe, sources, words, capfd):
    made = [source() for source in sources]
    before = len(simple.GetSources())
    assert getattr(gui, recipe)(sources=made) is None
    told = capfd.readouterr().err
    assert re.search("Wavelet[0-9]+ " + words, told) and "Extract Surface" in told and "Traceback" not in told
    assert len(simple.GetSources()) == before


def test_only_what_has_blocks_can_be_coloured_by_them(capfd):
    assert gui.blocks(simple.Sphere()) is None
    assert "array BlockId" in capfd.readouterr().err


def test_only_a_filter_with_a_tool_can_show_it(capfd):
    assert gui.show_tool(simple.Sphere()) is None
    assert "Select a filter that has a Tool" in capfd.readouterr().err


def test_sources_are_chosen_by_the_ids_of_their_proxies_and_their_ports():
    sphere = simple.Sphere()
    cut = simple.SurfaceIntersection(Input=sphere, Tool=simple.Box())
    first, second = gui.chosen([(sphere.SMProxy.GetGlobalID(), 0), (cut.SMProxy.GetGlobalID(), 1)])
    assert (first.SMProxy, second.SMProxy) == (sphere.SMProxy, cut.SMProxy)
    assert second.Port == 1


@pytest.mark.parametrize("macro", MACROS, ids=lambda path: path.stem)
def test_a_macro_is_short_and_says_what_it_does_and_what_to_select(macro, capfd):
    text = macro.read_text()
    assert macro.suffix == ".py" and len(text.splitlines()) < 30  # each file of the folder becomes a button
    exec(compile(text, str(macro), "exec"), {"__name__": "__main__"})  # nothing is selected
    assert "in the Pipeline Browser first" in capfd.readouterr().err


def test_there_is_a_macro_for_each_recipe():
    assert len(MACROS) >= 5
    used = "".join(macro.read_text() for macro in MACROS)
    assert all(f"gui.{name}(" in used for name in ("boolean", "curves", "distance_map", "check", "clip", "live_tool", "point_cloud"))
