# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Clip, cut and contour triangulator as paraview.simple and the menus know them, and through state files."""

import pytest
from paraview import simple, smtrace

import states

PROPERTIES = {
    "ClosedSurfaceClip": {
        "Input": None,
        "UsePlane": 1,
        "Origin": None,
        "Normal": [1.0, 0.0, 0.0],
        "Planes": [],
        "UseBox": 0,
        "Box": [-0.5, 0.5, -0.5, 0.5, -0.5, 0.5],
        "InsideOut": 0,
        "GenerateFaces": 1,
        "GenerateOutline": 0,
        "PassPointData": 0,
        "ScalarMode": "None",
        "BaseColor": [1.0, 0.0, 0.0],
        "ClipColor": [1.0, 0.5, 0.0],
        "ActivePlaneColor": [1.0, 1.0, 0.0],
        "ActivePlaneId": -1,
        "Tolerance": 0.0,
        "NumberOfThreads": 0,
    },
    "ClosedSurfaceCut": {
        "Input": None,
        "Origin": None,
        "Normal": [0.0, 0.0, 1.0],
        "Offsets": [0.0],
        "Triangulate": 1,
        "PassPointData": 0,
        "Tolerance": 0.0,
        "NumberOfThreads": 0,
    },
    "ContourTriangulator": {"Input": None},
}
PORTS = {
    "ClosedSurfaceClip": ["Surface", "Outline"],
    "ClosedSurfaceCut": ["Caps"],
    "ContourTriangulator": None,
}
TABLE = [0.0, 0.25, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -0.25, 0.0, 0.0, 1.0]


@pytest.fixture(autouse=True)
def clean_session():
    simple.ResetSession()
    yield


def volume(proxy):
    measure = simple.IntegrateVariables(Input=simple.Delaunay3D(Input=proxy))
    measure.UpdatePipeline()
    return measure.CellData["Volume"].GetRange()[0]


def sources(proxy):
    proxy.UpdatePipeline()
    return proxy.CellData["SourceId"].GetRange()


@pytest.mark.parametrize("name", PROPERTIES)
def test_properties_defaults_help_icon_and_ports(name):
    cube = simple.Box()
    cube.UpdatePipeline()  # as in the window, so that its bounds are known
    proxy = getattr(simple, name)(Input=cube)
    assert set(proxy.ListProperties()) == set(PROPERTIES[name])
    for key, default in PROPERTIES[name].items():
        if default is not None:
            value = proxy.GetPropertyValue(key)
            assert (list(value) if isinstance(default, list) else value) == default, key
        text = proxy.GetProperty(key).SMProperty.GetDocumentation().GetDescription()
        assert len(text.strip()) > 30, key
    documentation = proxy.SMProxy.GetDocumentation()
    assert documentation.GetShortHelp() and documentation.GetLongHelp()
    assert len(documentation.GetDescription()) > 500
    menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
    assert menu.GetAttribute("category") == "Surface Booleans"
    assert menu.GetAttribute("icon").endswith(f"{name}.svg")
    for port, wanted in enumerate(PORTS[name] or []):
        assert proxy.SMProxy.GetOutputPortName(port) == wanted


def test_a_box_the_wrong_way_round_is_refused():
    """As it comes about if the bounds were not known yet."""
    clip = simple.ClosedSurfaceClip(Input=simple.Box(), UseBox=1)
    clip.UpdatePipeline()
    assert clip.FieldData["Status"].GetRange() == (10, 10)
    clip.Box = [-1, 0.25, -1, 1, -1, 1]
    assert sources(clip)[0] == 0 and clip.FieldData["Status"].GetRange() == (0, 0)


def test_the_plane_the_table_and_the_box_clip_together():
    clip = simple.ClosedSurfaceClip(Input=simple.Box())
    assert sources(clip) == (0, 1) and volume(clip) == pytest.approx(0.5)
    clip.Planes = TABLE
    assert sources(clip) == (0, 3) and volume(clip) == pytest.approx(0.5 * 0.75 * 0.75)
    clip.UseBox, clip.Box = 1, [-1, 0.25, -1, 1, -1, 1]
    assert sources(clip) == (0, 5) and volume(clip) == pytest.approx(0.25 * 0.75 * 0.75)
    clip.UsePlane = 0
    assert volume(clip) == pytest.approx(0.75**3)


@pytest.mark.parametrize("kind", states.KINDS)
def test_the_table_of_planes_survives_a_state_file(kind, tmp_path):
    clip = simple.ClosedSurfaceClip(registrationName="Clipped", Input=simple.Box())
    clip.Planes, clip.Normal, clip.ScalarMode = TABLE, [0, 0, -1], "Labels"
    cut = simple.ClosedSurfaceCut(registrationName="Slices", Input=clip, Offsets=[-0.1, 0.0, 0.1])
    expected = (sources(clip), volume(clip), sources(cut))
    states.replay(kind, tmp_path)
    clip, cut = simple.FindSource("Clipped"), simple.FindSource("Slices")
    assert list(clip.Planes) == TABLE and clip.ScalarMode == "Labels"
    assert list(cut.Offsets) == [-0.1, 0.0, 0.1]
    assert (sources(clip), volume(clip), sources(cut)) == expected


def test_the_table_of_planes_survives_a_trace():
    """What is written down when a filter is made and its properties are applied, run as a script."""
    box = simple.Box(registrationName="Body")
    smtrace.start_trace()
    clip = simple.ClosedSurfaceClip(registrationName="Clipped", Input=box)
    applied = smtrace.PropertiesModified(clip)
    clip.Planes = TABLE
    applied.finalize()
    trace = smtrace.stop_trace()
    simple.Delete(clip)
    assert simple.FindSource("Clipped") is None
    exec(compile(trace, "trace", "exec"), {})
    assert list(simple.FindSource("Clipped").Planes) == TABLE


def test_a_series_of_cross_sections_and_their_outlines_filled_again():
    cut = simple.ClosedSurfaceCut(Input=simple.Box(), Offsets=[-0.25, 0.0, 0.25])
    cut.UpdatePipeline()
    assert cut.FieldData["SliceArea"].GetRange() == (1.0, 1.0)
    assert cut.CellData["Area"].GetRange() == (1.0, 1.0)
    outline = simple.ClosedSurfaceCut(Input=simple.Box(), Triangulate=0)
    filled = simple.ContourTriangulator(Input=outline)
    filled.UpdatePipeline()
    assert filled.GetDataInformation().GetNumberOfCells() == 2
    assert filled.FieldData["PolygonCount"].GetRange() == (1.0, 1.0)
