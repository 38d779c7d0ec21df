# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Surface Distance and Surface Distance Field as paraview.simple and the menus know them."""

import pytest
from paraview import simple

import states

DISTANCE = {
    "Input": None,
    "Tool": None,
    "SignedDistance": 1,
    "SignMethod": "Pseudonormal",
    "NegateDistance": 0,
    "ComputeSecondDistance": 0,
    "MaximumDistance": 0.0,
    "ComputeCellCenterDistance": 0,
    "ComputeNearestPoint": 0,
    "ComputeNearestCellId": 0,
    "ComputeDirection": 0,
    "NumberOfThreads": 0,
}
FIELD = {
    "Input": None,
    "SampleBy": "Dimensions",
    "Dimensions": [64, 64, 64],
    "Spacing": 0.0,
    "Margin": 0.1,
    "NarrowBand": 0.0,
    "SignedDistance": 1,
    "SignMethod": "Pseudonormal",
    "NegateDistance": 0,
    "NumberOfThreads": 0,
}


@pytest.fixture(autouse=True)
def clean_session():
    simple.ResetSession()
    yield


def cube(side):
    return simple.Box(XLength=side, YLength=side, ZLength=side)


def proxies():
    return (
        (simple.SurfaceDistance(Input=cube(1), Tool=cube(2)), DISTANCE, ["Distance", "SecondDistance"]),
        (simple.SurfaceDistanceField(Input=cube(1)), FIELD, ["Field"]),
    )


def test_properties_outputs_help_menu_and_icon():
    for proxy, properties, outputs in proxies():
        assert set(proxy.ListProperties()) == set(properties)
        for name, default in properties.items():
            if default is not None:
                value = proxy.GetPropertyValue(name)
                assert (list(value) if isinstance(default, list) else value) == default
            text = proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription()
            assert len(text.strip()) > 40, name
        assert [proxy.SMProxy.GetOutputPortName(i) for i in range(len(outputs))] == outputs
        documentation = proxy.SMProxy.GetDocumentation()
        assert documentation.GetShortHelp() and documentation.GetLongHelp()
        menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
        assert menu.GetAttribute("category") == "Surface Booleans"
        assert menu.GetAttribute("icon").endswith(".svg")


def test_distances_and_their_summary_reach_the_client():
    proxy = simple.SurfaceDistance(Input=cube(1), Tool=cube(4), ComputeSecondDistance=1)
    proxy.UpdatePipeline()
    assert proxy.PointData["Distance"].GetRange() == pytest.approx((-1.5, -1.5))
    assert proxy.FieldData["HausdorffDistance"].GetRange()[0] == pytest.approx(3**0.5 * 1.5)
    assert proxy.FieldData["DistanceQuantile50"].GetRange()[0] == pytest.approx(-1.5)
    second = simple.OutputPort(proxy, 1)
    second.UpdatePipeline()
    assert second.PointData["Distance"].GetRange()[1] == pytest.approx(3**0.5 * 1.5)


def test_the_field_is_contoured():
    image = simple.SurfaceDistanceField(Input=cube(2), SampleBy="Spacing", Spacing=0.1, Margin=0.3)
    contour = simple.Contour(Input=image, ContourBy=["POINTS", "Distance"], Isosurfaces=[0.25])
    contour.UpdatePipeline()
    bounds = contour.GetDataInformation().GetBounds()
    assert bounds == pytest.approx((-1.25, 1.25) * 3, abs=0.01)


@pytest.mark.parametrize("kind", states.KINDS)
def test_a_state_file_gives_the_same_pipeline(kind, tmp_path):
    simple.SurfaceDistance(
        registrationName="Map", Input=cube(1), Tool=cube(2), NegateDistance=1, SignMethod="Winding Number"
    ).UpdatePipeline()
    simple.SurfaceDistanceField(registrationName="Field", Input=cube(1), Dimensions=[5, 6, 7]).UpdatePipeline()
    states.replay(kind, tmp_path)
    again, field = simple.FindSource("Map"), simple.FindSource("Field")
    again.UpdatePipeline(), field.UpdatePipeline()
    assert again.SignMethod == "Winding Number"
    assert again.PointData["Distance"].GetRange() == pytest.approx((0.5, 0.5))
    assert field.GetDataInformation().GetNumberOfPoints() == 5 * 6 * 7
