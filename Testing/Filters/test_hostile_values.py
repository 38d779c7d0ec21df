# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Python may set any property to anything: every filter takes it or says in one sentence what to set instead."""

import math
import re
import time

import pytest
import surfacebooleans.vtk  # noqa: F401, before the first object on the client's side is asked for
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from every_filter import FILTERS, INPUTS, field_value, heard_from, is_empty, outputs

SECONDS = 20  # for one update; a few hundredths where the machine has nothing else to do
INTEGERS = (-(2**31), -1, 2, 7, 2**31 - 1)
NUMBERS = (math.nan, math.inf, -math.inf, -1.0, 0.0, 5e-324, 1e-300, 1e-12, 1e12, 1e300)
TEXTS = ("", " ", "/", "/no/such/folder/file.step", "\n", "ä" * 5000, "%s%n")
LONGEST = 12  # of a property that takes any number of values


@pytest.fixture(autouse=True)
def own_session():
    simple.ResetSession()


def proxy_of(name):
    """The proxy of a line of the table, with its inputs and settings."""
    entry = FILTERS[name]
    made = getattr(simple, entry.proxy or name)()
    for port, what in enumerate(entry.inputs):
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(INPUTS["shapes"][what]())
        setattr(made, ("Input", "Tool")[port], source)
    for key, value in entry.settings.items():
        if made.GetProperty(key) is not None and not callable(value):
            setattr(made, key, list(value) if isinstance(value, tuple) else value)
    return made


def hostile_values(smproperty):
    """Lists of elements to try."""
    if smproperty.IsA("vtkSMStringVectorProperty"):
        return [[text] for text in TEXTS]
    values = INTEGERS if smproperty.IsA("vtkSMIntVectorProperty") else NUMBERS
    if smproperty.GetRepeatable():
        step = smproperty.GetNumberOfElementsPerCommand()
        return [[], *([value] * (LONGEST * step) for value in values), [0, 1] * step]
    count = smproperty.GetNumberOfElements()
    whole = [[value] * count for value in values]
    one_bad = [[*smproperty_elements(smproperty)[:-1], value] for value in values if count > 1]
    return whole + one_bad


def smproperty_elements(smproperty):
    return [smproperty.GetElement(i) for i in range(smproperty.GetNumberOfElements())]


def vector_properties(made):
    """What holds numbers or texts, of the proxy and of proxies that it holds (a plane)."""
    for key in made.ListProperties():
        smproperty = made.GetProperty(key).SMProperty
        if smproperty.IsA("vtkSMProxyProperty") and not smproperty.IsA("vtkSMInputProperty"):
            for i in range(smproperty.GetNumberOfProxies()):
                held = servermanager._getPyProxy(smproperty.GetProxy(i))
                for own in held.ListProperties():
                    if held.GetProperty(own).SMProperty.IsA("vtkSMVectorProperty"):
                        yield f"{key}.{own}", held, held.GetProperty(own).SMProperty
        elif smproperty.IsA("vtkSMVectorProperty"):
            yield key, made, smproperty


def assert_answer(made, errors, what):
    """A result, or one sentence and nothing; either way the status is there."""
    algorithm = made.GetClientSideObject()
    first = outputs(algorithm)[0]
    message = field_value(first, "Message")
    if errors:
        assert len(errors) == 1, (what, errors)
        assert message in errors[0] and is_empty(algorithm), (what, message)
        assert re.search(r"[;,] ?\w", message) and message.endswith("."), (what, message)
        assert len(message) < 400 or "ä" in message, (what, message)
        return "refused"
    for data in outputs(algorithm):
        if data.GetNumberOfPoints() and data.IsA("vtkPolyData"):
            ids = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
            assert ids.size == 0 or 0 <= ids.min() and ids.max() < data.GetNumberOfPoints(), what
    return "taken"


@pytest.mark.parametrize("name", FILTERS)
def test_no_value_of_a_property_does_harm(name, record_property):
    made = proxy_of(name)
    algorithm = made.GetClientSideObject()
    tried = 0
    for key, holder, smproperty in list(vector_properties(made)):
        before = smproperty_elements(smproperty)
        for values in hostile_values(smproperty):
            smproperty.SetNumberOfElements(len(values))
            for i, value in enumerate(values):
                smproperty.SetElement(i, value)
            holder.SMProxy.UpdateVTKObjects()
            start = time.perf_counter()
            errors, _ = heard_from(algorithm)
            seconds = time.perf_counter() - start
            assert seconds < SECONDS, (key, values)
            record_property(f"{key} = {values}"[:80], assert_answer(made, errors, (key, values)))
            tried += 1
        smproperty.SetNumberOfElements(len(before))
        for i, value in enumerate(before):
            smproperty.SetElement(i, value)
        holder.SMProxy.UpdateVTKObjects()
    errors, _ = heard_from(algorithm)
    assert not errors and not is_empty(algorithm)
    assert tried >= 5 or name == "ContourTriangulator"
