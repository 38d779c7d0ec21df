# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Run by all processes at once (``pvbatch --symmetric``): how updates end for which one of them has too little memory."""

import json
import os
import pathlib
import resource
import sys

import surfacebooleans.vtk
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
rank, last = controller.GetLocalProcessId(), controller.GetNumberOfProcesses() - 1

RESOLUTION = 160  # a piece is a few megabytes
ALLOWED = 1 << 20  # bytes beyond what the process has when the filter starts
FILTERS = {
    "vtkPolyDataBooleanOperationFilter": 2,
    "vtkPolyDataIntersection": 2,
    "vtkPolyDataDistance": 2,
    "vtkPolyDataDistanceField": 1,
    "vtkPolyDataSurfaceCheck": 1,
    "vtkPolyDataClipClosedSurface": 1,
    "vtkPointSetIntersectionFilter": 1,
}


def limit(allowed):
    """Of this process's addresses, so that more memory is refused to it as by a machine that has no more."""
    if allowed is not None:
        pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        allowed += pages * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (allowed or resource.RLIM_INFINITY, resource.RLIM_INFINITY))


def made(name, inputs):
    """A filter with sources that make a piece in each process."""
    algorithm = getattr(surfacebooleans.vtk, name)()
    if name == "vtkPointSetIntersectionFilter":
        algorithm.SetPlane(vtkPlane())
    for port in range(inputs):
        source = vtkSphereSource()
        source.SetCenter(0.3 * port, 0, 0)
        source.SetThetaResolution(RESOLUTION)
        source.SetPhiResolution(RESOLUTION)
        algorithm.SetInputConnection(port, source.GetOutputPort())
    return algorithm


def update(algorithm, poor):
    """The status in this process, of an update for which that one is poor; whether there are points."""
    algorithm.Modified()
    observer = algorithm.AddObserver("StartEvent", lambda *_: limit(ALLOWED if rank == poor else None))
    algorithm.UpdatePiece(rank, last + 1, 0)
    limit(None)
    algorithm.RemoveObserver(observer)
    output = algorithm.GetOutputDataObject(0)
    return int(output.GetFieldData().GetArray("Status").GetValue(0)), output.GetNumberOfPoints() > 0


report = {}
for name, inputs in FILTERS.items():
    algorithm = made(name, inputs)
    report[name] = {
        "first is poor": update(algorithm, 0),
        "none is poor": update(algorithm, None),
    }
    algorithm = made(name, inputs)
    report[name] |= {
        "last is poor": update(algorithm, last),
        "none is poor again": update(algorithm, None),
    }

with open(os.path.join(sys.argv[-1], f"memory{rank}.json"), "w", encoding="utf-8") as file:
    json.dump(report, file)
