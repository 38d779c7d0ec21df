# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The filter as paraview.simple and the menus know it: its name, properties, defaults, and its way through a state file."""

import subprocess

import pytest
from paraview import simple

import states

PROPERTIES = {
    "Input": None,
    "Tool": None,
    "Operation": "Union",
    "ReorientDifferenceCells": 1,
    "Tolerance": 0.0,
    "NumberOfThreads": 0,
}
OPERATIONS = ["Union", "Intersection", "Difference", "Symmetric Difference", "Resolve"]


@pytest.fixture(autouse=True)
def clean_session():
    simple.ResetSession()
    yield


def boxes(*places):
    """Boxes of side 2."""
    return [simple.Box(XLength=2, YLength=2, ZLength=2, Center=place) for place in places]


def volume(proxy):
    proxy.UpdatePipeline()
    return proxy.FieldData["ResultVolume"].GetRange()[0]


def hint(proxy, name):
    return proxy.GetHints().FindNestedElementByName(name)


def test_the_properties_are_those_of_the_interface():
    proxy = simple.SurfaceBoolean(Input=boxes((0, 0, 0)))
    assert set(proxy.ListProperties()) == set(PROPERTIES)
    for name, default in PROPERTIES.items():
        if default is not None:
            assert proxy.GetPropertyValue(name) == default
    assert list(proxy.GetProperty("Operation").Available) == OPERATIONS
    assert proxy.SMProxy.GetOutputPortName(0) == "Surface"
    assert proxy.SMProxy.GetOutputPortName(1) == "Curves"


def test_every_property_tells_what_it_is_for():
    proxy = simple.SurfaceBoolean(Input=boxes((0, 0, 0)))
    documentation = proxy.SMProxy.GetDocumentation()
    assert documentation.GetShortHelp() and documentation.GetLongHelp()
    assert "OriginalCellId" in documentation.GetDescription()
    for name in PROPERTIES:
        text = proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription()
        assert len(text.strip()) > 40, name


def test_the_menu_the_icon_and_the_view_are_set():
    proxy = simple.SurfaceBoolean(Input=boxes((0, 0, 0)))
    assert hint(proxy, "ShowInMenu").GetAttribute("category") == "Surface Booleans"
    assert hint(proxy, "ShowInMenu").GetAttribute("icon").endswith(".svg")
    assert hint(proxy, "Visibility").GetAttribute("replace_input") == "1"
    assert hint(proxy, "View").GetAttribute("port") == "1"


@pytest.mark.parametrize("operation, wanted", zip(OPERATIONS, (15, 1, 7, 14, 15)))
def test_operations_go_by_their_names(operation, wanted):
    first, second = boxes((0, 0, 0), (1, 1, 1))
    proxy = simple.SurfaceBoolean(Input=first, Tool=second, Operation=operation)
    assert volume(proxy) == pytest.approx(wanted)
    assert proxy.FieldData["Status"].GetRange() == (0, 0)
    assert simple.OutputPort(proxy, 1).GetDataInformation().GetNumberOfCells() > 0


def test_the_active_source_is_the_input_and_tool_may_be_empty_or_several():
    first, second, third = boxes((0, 0, 0), (1, 1, 1), (-1, -1, -1))
    simple.SetActiveSource(first)
    proxy = simple.SurfaceBoolean()
    assert volume(proxy) == pytest.approx(8)
    proxy.Tool = [second, third]
    proxy.Operation = "Difference"
    assert volume(proxy) == pytest.approx(6)
    proxy.Tool = second
    assert volume(proxy) == pytest.approx(7)
    proxy.Input = [first, third]
    assert volume(proxy) == pytest.approx(14)
    proxy.Tool = None
    proxy.Operation = "Union"
    assert volume(proxy) == pytest.approx(15)


def test_a_composite_input_is_one_surface():
    group = simple.GroupDatasets(Input=boxes((0, 0, 0), (5, 0, 0)))
    proxy = simple.SurfaceBoolean(Input=group, Tool=boxes((1, 1, 1))[0], Operation="Difference")
    assert volume(proxy) == pytest.approx(15)
    assert proxy.CellData["SourceId"].GetRange() == (0, 1)


@pytest.mark.parametrize("kind", states.KINDS)
def test_a_state_file_gives_the_same_pipeline(kind, tmp_path):
    first, second, third = boxes((0, 0, 0), (1, 1, 1), (-1, -1, -1))
    proxy = simple.SurfaceBoolean(registrationName="Bitten", Input=first, Tool=[second, third], Operation="Difference")
    proxy.NumberOfThreads = 2
    assert volume(proxy) == pytest.approx(6)
    states.replay(kind, tmp_path)
    again = simple.FindSource("Bitten")
    assert again.Operation == "Difference" and again.NumberOfThreads == 2
    assert volume(again) == pytest.approx(6)


def test_pvpython_has_the_filter_and_the_classes():
    script = (
        "from paraview.simple import *\n"
        "from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter\n"
        "f = SurfaceBoolean(Input=Sphere())\n"
        "f.UpdatePipeline()\n"
        "print(type(f.SMProxy.GetClientSideObject()) is vtkPolyDataBooleanOperationFilter)\n"
    )
    done = subprocess.run(["pvpython", "-c", script], capture_output=True, text=True, timeout=120, check=False)
    assert done.stdout.strip().endswith("True"), done.stdout + done.stderr
    assert "ERR|" not in done.stderr + done.stdout
