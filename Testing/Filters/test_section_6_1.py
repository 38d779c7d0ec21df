# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The source document's pipeline of section 6.1, made of our own parts, gives the same solid as Surface Boolean."""

import pathlib
import subprocess

import pytest
from paraview import simple
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

import meshes
from booleans import polydata
from section_6_1 import KEPT, boolean_of_parts, difference, volume

HERE = pathlib.Path(__file__).resolve().parent


@pytest.fixture(autouse=True)
def clean_session():
    simple.ResetSession()


def source(body):
    """A mesh with normals as a source of the pipeline."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(polydata(body))
    normals.SplittingOn()
    normals.Update()
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(normals.GetOutput())
    return producer


# Not the two cylinders, which have planes in common: there the distance is zero on both sides.
PAIRS = {name: pair for name, pair in meshes.figure_5_pairs().items() if name != "cylinder-cylinder"}
PAIRS["elephant and knot"] = (meshes.cgal_mesh("elephant"), meshes.moved(meshes.cgal_mesh("knot1"), (0.05, 0.02, 0.1)))


@pytest.mark.parametrize("operation", KEPT)
@pytest.mark.parametrize("pair", PAIRS)
def test_the_pipeline_gives_the_solid_of_surface_boolean(pair, operation):
    first, second = (source(body) for body in PAIRS[pair])
    parts = boolean_of_parts(first, second, operation)
    whole = simple.SurfaceBoolean(Input=first, Tool=second, Operation=operation)
    parts.UpdatePipeline()
    whole.UpdatePipeline()
    assert parts.GetDataInformation().GetNumberOfCells() == whole.GetDataInformation().GetNumberOfCells() > 0
    assert volume(parts) == pytest.approx(volume(whole), rel=1e-12)
    assert difference(parts, whole) == 0.0
    closed = simple.SurfaceBoolean(Input=parts, Operation="Resolve")
    closed.UpdatePipeline()
    assert closed.FieldData["Status"].GetRange() == (0, 0), "closed, and turned outwards"


def test_the_saved_state_has_the_pipeline():
    simple.LoadState(str(HERE / "section_6_1.pvsm"))
    parts = simple.FindSource("Section 6.1: result")
    whole = simple.SurfaceBoolean(
        Input=simple.FindSource("Cone"), Tool=simple.FindSource("Cylinder"), Operation="Difference"
    )
    assert volume(parts) == pytest.approx(volume(whole), rel=1e-12) and volume(whole) > 0.1
    assert difference(parts, whole) == 0.0


def test_the_script_runs_in_pvpython():
    done = subprocess.run(
        ["pvpython", str(HERE / "section_6_1.py")], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0 and "ERR|" not in done.stderr + done.stdout, done.stdout + done.stderr
    assert done.stdout.count("in one but not both 0\n") == 3
