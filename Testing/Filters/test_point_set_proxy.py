# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Surface as paraview.simple and the menus know it, and through a state file."""

import pytest
from paraview import simple

import states

PROPERTIES = {
    "Input": None,
    "Definition": "Unbiased",
    "Width": 0.0,
    "FlipNormals": 0,
    "ProjectPoints": 1,
    "ComputeCurvatures": 1,
    "GenerateSurface": 0,
    "CellSize": 0.0,
    "NumberOfThreads": 0,
}


@pytest.fixture(autouse=True)
def clean_session():
    simple.ResetSession()
    yield


def ball():
    return simple.Sphere(ThetaResolution=40, PhiResolution=40, Radius=2)


def test_the_properties_are_those_of_the_interface():
    proxy = simple.PointSetSurface(Input=ball())
    assert set(proxy.ListProperties()) == set(PROPERTIES)
    for name, default in PROPERTIES.items():
        if default is not None:
            assert proxy.GetPropertyValue(name) == default
    assert list(proxy.GetProperty("Definition").Available) == ["Unbiased", "Amenta-Kil"]
    assert proxy.SMProxy.GetOutputPortName(0) == "Points"
    assert proxy.SMProxy.GetOutputPortName(1) == "Surface"


def test_every_property_tells_what_it_is_for():
    proxy = simple.PointSetSurface(Input=ball())
    documentation = proxy.SMProxy.GetDocumentation()
    assert documentation.GetShortHelp() and documentation.GetLongHelp()
    assert "Validity" in documentation.GetDescription()
    for name in PROPERTIES:
        text = proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription()
        assert len(text.strip()) > 40, name
    hints = proxy.GetHints()
    assert hints.FindNestedElementByName("ShowInMenu").GetAttribute("category") == "Surface Booleans"
    assert hints.FindNestedElementByName("ShowInMenu").GetAttribute("icon").endswith("PointSetSurface.svg")


@pytest.mark.parametrize("kind", states.KINDS)
def test_a_state_file_gives_the_same_surface(kind, tmp_path):
    proxy = simple.PointSetSurface(registrationName="Skin", Input=ball(), GenerateSurface=1, Definition="Amenta-Kil")
    proxy.CellSize = 0.5

    def triangles(of):
        of.UpdatePipeline()
        assert of.FieldData["Status"].GetRange() == (0, 0)
        assert of.FieldData["NumberOfBorderEdges"].GetRange() == (0, 0)
        return simple.OutputPort(of, 1).GetDataInformation().GetNumberOfCells()

    wanted = triangles(proxy)
    assert wanted > 100
    states.replay(kind, tmp_path)
    again = simple.FindSource("Skin")
    assert again.Definition == "Amenta-Kil" and again.CellSize == 0.5
    assert triangles(again) == wanted
