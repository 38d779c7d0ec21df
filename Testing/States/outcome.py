# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a pipeline comes to: a fingerprint of every output of every source, and a picture of the view.

In pvpython, `pvpython outcome.py STATE FOLDER` replays a state file or a trace and notes its outcome; in the window's
Python shell, `note(folder)` does.
"""

import hashlib
import json
import pathlib
import sys
import xml.etree.ElementTree as XML

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

PICTURE_SIZE = [800, 600]
TIMES = {"StageSeconds"}  # what differs from run to run
LEAST_SEEN, EDGES = 10, 0.001  # of 255 a pixel; the share of pixels at edges, which the window smooths otherwise


def fingerprint(data):
    """A hash of all bytes of a data set, its arrays' names and types included."""
    digest = hashlib.sha256(data.GetClassName().encode())
    if data.IsA("vtkPointSet") and data.GetNumberOfPoints():
        _add(digest, data.GetPoints().GetData())
    if data.IsA("vtkPolyData"):
        for cells in (data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()):
            _add(digest, cells.GetOffsetsArray())
            _add(digest, cells.GetConnectivityArray())
    for attributes in (data.GetPointData(), data.GetCellData(), data.GetFieldData()):
        arrays = [attributes.GetAbstractArray(k) for k in range(attributes.GetNumberOfArrays())]
        for array in sorted(arrays, key=lambda array: array.GetName()):
            if array.GetName() not in TIMES:
                _add(digest, array)
    return digest.hexdigest()


def _add(digest, array):
    digest.update(f"|{array.GetName()} {array.GetNumberOfComponents()} {array.GetDataTypeAsString()}|".encode())
    if array.IsNumeric():
        digest.update(vtk_to_numpy(array).tobytes())
    else:
        digest.update(repr([array.GetValue(k) for k in range(array.GetNumberOfValues())]).encode())


def outputs():
    """Of every output of every source: its fingerprint and number of cells."""
    found = {}
    for (name, _), proxy in simple.GetSources().items():
        proxy.UpdatePipeline()
        for port in range(proxy.SMProxy.GetNumberOfOutputPorts()):
            data = servermanager.Fetch(proxy, idx=port)
            found[f"{name} {port}"] = [fingerprint(data), data.GetNumberOfCells()]
    return found


def note(folder):
    """Write outcome.json, and outcome.png if there is a view."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    views = simple.GetRenderViews()
    if views:
        simple.SaveScreenshot(str(folder / "outcome.png"), views[0], ImageResolution=PICTURE_SIZE)
    (folder / "outcome.json").write_text(json.dumps(outputs(), indent=1, sort_keys=True))


def read_picture(folder):
    """The picture's vtkImageData."""
    reader = vtkPNGReader()
    reader.SetFileName(str(pathlib.Path(folder) / "outcome.png"))
    reader.Update()
    return reader.GetOutput()


def difference(first, second):
    """What differs between two noted outcomes; empty if the data are equal, and the pictures but for edges of the window."""
    names = [json.loads((pathlib.Path(folder) / "outcome.json").read_text()) for folder in (first, second)]
    found = [name for name in {**names[0], **names[1]} if names[0].get(name) != names[1].get(name)]
    pictures = [vtk_to_numpy(read_picture(folder).GetPointData().GetScalars()).astype(int) for folder in (first, second)]
    share = (abs(pictures[0] - pictures[1]).max(axis=1) > LEAST_SEEN).mean()
    return found + ([f"{share:.2%} of the picture"] if share > EDGES else [])


def replay(file):
    """Load a .pvsm, or run a Python state or a trace."""
    if file.endswith(".pvsm"):
        simple.LoadState(file)
        _put_back(file)
    else:
        exec(compile(pathlib.Path(file).read_text(), file, "exec"), {})


def _put_back(file):
    """Where things are drawn: ParaView 5.13, where that has a new name, forgets it of a .pvsm of 5.11."""
    state = XML.parse(file)
    names = {item.get("id"): item.get("name") for item in state.iterfind(".//ProxyCollection[@name='representations']/*")}
    manager = servermanager.ProxyManager()
    for proxy in state.iterfind(".//Proxy[@group='representations']"):
        place = proxy.findall("Property[@name='Position']/Element")
        display = manager.GetProxy("representations", names.get(proxy.get("id"), ""))
        if place and display and "Translation" in display.ListProperties():
            display.Translation = [float(element.get("value")) for element in place]


if __name__ == "__main__":
    replay(sys.argv[1])
    note(sys.argv[2])
