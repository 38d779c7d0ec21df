# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The rules that every panel keeps, read from XML/*.xml: what is said, grouped, hidden and shown at once."""

import contextlib
import os
import pathlib
import re
import sqlite3
import xml.etree.ElementTree as ElementTree
import zlib

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILES = sorted((ROOT / "XML").glob("*.xml"))
PROPERTIES = ("InputProperty", "IntVectorProperty", "DoubleVectorProperty", "StringVectorProperty", "ProxyProperty")
EDITORS = ("IntVectorProperty", "DoubleVectorProperty")


def proxy_of(file):
    """The proxy that the file describes, and its group: filters, sources or writers."""
    group = ElementTree.parse(file).getroot().find("ProxyGroup")
    (proxy,) = group
    return proxy, group.get("name")


def words(element):
    return " ".join((element.text or "").split())


def documentation(property_):
    return words(property_.find("Documentation"))


def properties(proxy):
    return [child for child in proxy if child.tag in PROPERTIES]


def editable(proxy):
    """What the panel has a widget for."""
    return [p for p in properties(proxy) if p.tag != "InputProperty" and p.get("information_only") != "1"]


def is_number(property_):
    return property_.tag in EDITORS and property_.find("BooleanDomain") is None and property_.find("EnumerationDomain") is None


def spaced(name):
    """FooBarId -> Foo Bar Id"""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


CASES = [pytest.param(*proxy_of(file), id=file.stem) for file in FILES]
FILTERS = [case for case in CASES if case.values[1] == "filters"]


def test_all_files_are_here():
    assert len(FILTERS) >= 11 and len(CASES) >= 13


@pytest.mark.parametrize("proxy, group", CASES)
def test_the_label_is_the_spaced_name(proxy, group):
    assert proxy.get("label") == re.sub(r"^NURBS(?=[A-Z])", "NURBS ", spaced(proxy.get("name")))
    for property_ in editable(proxy):
        assert property_.get("label") == spaced(property_.get("name"))


@pytest.mark.parametrize("proxy, group", CASES)
def test_the_help_tells_what_the_filter_is_for(proxy, group):
    text = proxy.find("Documentation")
    assert len(words(text)) > 300 and words(text).startswith("Use this ")
    assert 20 < len(text.get("short_help")) <= 110 and text.get("long_help")


@pytest.mark.parametrize("proxy, group", CASES)
def test_every_property_has_a_tool_tip(proxy, group):
    for property_ in properties(proxy):
        assert len(documentation(property_)) > 30, property_.get("name")


@pytest.mark.parametrize("proxy, group", CASES)
def test_numbers_have_units_and_ranges_that_are_those_of_their_domains(proxy, group):
    for property_ in filter(is_number, editable(proxy)):
        found = re.search(r" Unit: ([^;]+); range: ([^;]+)\.$", documentation(property_))
        assert found, property_.get("name")
        domain = property_.find("DoubleRangeDomain")
        domain = property_.find("IntRangeDomain") if domain is None else domain
        least, most = (set((domain.get(key) or "").split()) for key in ("min", "max")) if domain is not None else ("", "")
        if not least:
            assert found[2].startswith("any"), property_.get("name")
        else:
            wanted = f"{min(least)} to {max(most)}" if most else f"{min(least)} or more"
            assert found[2] == wanted, property_.get("name")


@pytest.mark.parametrize("proxy, group", CASES)
def test_everything_in_the_panel_is_in_a_group(proxy, group):
    grouped = {member.get("name") for part in proxy.findall("PropertyGroup") for member in part.findall("Property")}
    if group != "writers":
        assert {p.get("name") for p in editable(proxy)} <= grouped
    for part in proxy.findall("PropertyGroup"):
        assert part.get("label")


@pytest.mark.parametrize("proxy, group", CASES)
def test_experts_knobs_are_advanced(proxy, group):
    for property_ in editable(proxy):
        if property_.get("name") in ("NumberOfThreads", "Tolerance", "Definition", "NarrowBand", "MaximumDistance"):
            assert property_.get("panel_visibility") == "advanced", property_.get("name")


@pytest.mark.parametrize("proxy, group", CASES)
def test_decorators_name_properties_that_there_are(proxy, group):
    names = {p.get("name") for p in properties(proxy)}
    for decorator in proxy.iter("PropertyWidgetDecorator"):
        assert decorator.get("property") in names and decorator.get("mode") in ("visibility", "enabled_state")


@pytest.mark.parametrize("proxy, group", FILTERS)
def test_the_menu_entry_has_an_icon(proxy, group):
    entry = proxy.find("Hints/ShowInMenu")
    assert entry.get("category") == "Surface Booleans"
    assert entry.get("icon") == f":/SurfaceBooleans/Icons/{proxy.get('name')}.svg"
    assert (ROOT / "Plugin" / "Icons" / f"{proxy.get('name')}.svg").exists()


@pytest.mark.parametrize("proxy, group", FILTERS)
def test_only_the_first_output_is_shown_at_once(proxy, group):
    hidden = {view.get("port") for view in proxy.findall("Hints/View") if view.get("type") == "None"}
    assert hidden == {port.get("index") for port in proxy.findall("OutputPort")} - {"0"}
    assert proxy.find("Hints/Visibility").get("replace_input") in ("0", "1")


@pytest.mark.parametrize("proxy, group", [case for case in CASES if case.values[1] != "writers"])
def test_the_help_page_has_a_picture(proxy, group):
    picture = ROOT / "Plugin" / "Help" / f"{group}.{proxy.get('name')}.png"
    assert picture.stat().st_size < 60_000


def test_all_pages_and_pictures_are_in_the_help_that_is_built():
    """F1 opens pages of a data base within the plugin; the build leaves it beside its pages."""
    plugin = pathlib.Path(os.environ["PV_PLUGIN_PATH"])
    help_file = plugin.parents[3] / "Plugin" / "paraview_help" / "SurfaceBooleans.qch"
    with contextlib.closing(sqlite3.connect(help_file)) as base:
        names = {name for (name,) in base.execute("SELECT Name FROM FileNameTable")}
        pages = base.execute("SELECT Name, Data FROM FileNameTable JOIN FileDataTable ON Id = FileId").fetchall()
    pictures = {file.name for file in (ROOT / "Plugin" / "Help").glob("*.png")}
    assert pictures <= names
    assert {f"{case.values[1]}.{case.values[0].get('name')}.html" for case in CASES} <= names
    for name, data in pages:
        if name in {picture.replace(".png", ".html") for picture in pictures}:
            assert f'<img src="{name[:-5]}.png">' in zlib.decompress(data[4:]).decode()
