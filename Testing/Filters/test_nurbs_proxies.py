# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""CAD files in ParaView: opened and saved by name, patches still there after a state was replayed and on a server."""

import os
import socket
import subprocess
import sys

import numpy as np
import pytest
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import cad
import states

cad.needs_cad()

SCREW = f"{cad.SAMPLES}/step/screw.step"
FIELDS = ("NURBSDegrees", "NURBSCounts", "NURBSKnots", "NURBSPoles")


@pytest.fixture(autouse=True)
def own_session():
    simple.ResetSession()


def test_files_are_opened_by_their_name():
    reader = simple.OpenDataFile(SCREW)
    assert reader.SMProxy.GetXMLName() == "NURBSReader"
    reader.UpdatePipeline()
    assert reader.FieldData["Status"].GetRange() == (0, 0) and reader.FieldData["NumberOfFaces"].GetRange() == (10, 10)
    assert reader.PointData["UV"].GetNumberOfComponents() == 2 and reader.CellData["FaceId"].GetRange() == (0, 9)
    coarse = reader.GetDataInformation().GetNumberOfCells()
    reader.ChordError = 2e-4
    reader.UpdatePipeline()
    assert reader.GetDataInformation().GetNumberOfCells() > 2 * coarse


def test_the_panel_is_documented():
    reader = simple.NURBSReader(FileName=SCREW)
    assert set(reader.ListProperties()) == {"FileName", "ChordError"}
    for name in reader.ListProperties():
        assert len(reader.GetProperty(name).SMProperty.GetDocumentation().GetDescription().strip()) > 40


def patches_after(proxy):
    return cad.Patches({name: vtk_to_numpy(servermanager.Fetch(proxy).GetFieldData().GetArray(name)) for name in FIELDS})


def test_data_are_saved_by_name(tmp_path):
    reader = simple.NURBSReader(FileName=SCREW)
    turned = simple.Transform(Input=reader)
    turned.Transform.Translate = [100, 0, 0]
    name = str(tmp_path / "moved.stp")
    simple.SaveData(name, proxy=turned)
    again = simple.OpenDataFile(name)
    again.UpdatePipeline()
    assert again.FieldData["NumberOfSolids"].GetRange() == (1, 1) and again.FieldData["Closed"].GetRange() == (1, 1)
    before, after = reader.GetDataInformation().GetBounds(), again.GetDataInformation().GetBounds()
    assert np.array(after) == pytest.approx(np.array(before) + [100, 100, 0, 0, 0, 0], abs=0.1)


def test_patches_survive_a_file_of_facets(tmp_path):
    """What was saved as .vtk is still a designed body."""
    simple.SaveData(str(tmp_path / "facets.vtk"), proxy=simple.NURBSReader(FileName=SCREW))
    facets = simple.OpenDataFile(str(tmp_path / "facets.vtk"))
    simple.SaveData(str(tmp_path / "again.step"), proxy=facets)
    again = simple.OpenDataFile(str(tmp_path / "again.step"))
    again.UpdatePipeline()
    assert again.FieldData["NumberOfSolids"].GetRange() == (1, 1)
    assert again.FieldData["NumberOfFaces"].GetRange() == (10, 10)


@pytest.mark.parametrize("kind", states.KINDS)
def test_patches_are_there_after_a_state_was_replayed(tmp_path, kind):
    reader = simple.OpenDataFile(SCREW)
    reader.ChordError = 2e-3
    simple.RenameSource("Screw", reader)
    moved = simple.Transform(Input=reader)
    simple.RenameSource("Moved", moved)
    moved.UpdatePipeline()
    before, points = patches_after(moved), servermanager.Fetch(moved).GetNumberOfPoints()
    states.replay(kind, tmp_path)
    again = simple.FindSource("Moved")
    again.UpdatePipeline()
    after = patches_after(again)
    assert simple.FindSource("Screw").ChordError == 2e-3
    assert servermanager.Fetch(again).GetNumberOfPoints() == points
    assert len(after) == len(before) == 10
    for one, two in zip(before.poles, after.poles):
        assert np.array_equal(one, two)


CLIENT = """
import sys
from paraview import simple, servermanager
simple.Connect("localhost", int(sys.argv[1]))
reader = simple.OpenDataFile(sys.argv[2])
moved = simple.Transform(Input=reader)
moved.Transform.Rotate = [0, 90, 0]
moved.UpdatePipeline()
here = servermanager.Fetch(moved)
poles = here.GetFieldData().GetArray("NURBSPoles")
print(poles.GetNumberOfTuples(), here.GetCellData().GetArray("FaceId").GetRange(), here.GetPointData().GetArray("UV") is not None)
simple.SaveData(sys.argv[3], proxy=moved)
again = simple.OpenDataFile(sys.argv[3])
again.UpdatePipeline()
print(again.FieldData["NumberOfSolids"].GetRange()[0], again.FieldData["NumberOfFaces"].GetRange()[0])
"""


def test_patches_come_from_a_server_and_are_written_there(tmp_path):
    with socket.socket() as free:
        free.bind(("localhost", 0))
        port = free.getsockname()[1]
    server = subprocess.Popen(
        ["pvserver", f"--server-port={port}"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    try:
        for line in server.stdout:
            if "Accepting connection" in line or "Waiting for client" in line:
                break
        done = subprocess.run(
            [sys.executable, "-c", CLIENT, str(port), SCREW, str(tmp_path / "written.step")],
            capture_output=True,
            text=True,
            timeout=100,
            check=False,
        )
    finally:
        server.kill()
        server.wait()
    assert done.returncode == 0, done.stderr[-3000:]
    poles = len(cad.read(SCREW).field_data["NURBSPoles"])
    assert done.stdout.split("\n")[:2] == [f"{poles} (0.0, 9.0) True", "1.0 10.0"]
