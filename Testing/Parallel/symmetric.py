# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Run by all processes at once (``pvbatch --symmetric``): what each of them has, and what stopping a filter does."""

import json
import os
import sys

from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter, vtkPolyDataDistance
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
rank, last = controller.GetLocalProcessId(), controller.GetNumberOfProcesses() - 1


def sphere(resolution, x=0.0):
    """A source that makes a piece in each process."""
    source = vtkSphereSource()
    source.SetCenter(x, 0, 0)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    return source


def joined(algorithm, resolution):
    """A filter with two of them."""
    for port, source in enumerate([sphere(resolution), sphere(resolution, 0.3)]):
        algorithm.SetInputConnection(port, source.GetOutputPort())
    return algorithm


def status(algorithm):
    """The number that the filter left behind."""
    return algorithm.GetOutputDataObject(0).GetFieldData().GetArray("Status").GetValue(0)


def update(algorithm, stopper=None):
    """Update in all processes; one of them may ask it to stop as soon as it has begun."""
    algorithm.Modified()
    observer = None
    if rank == stopper:
        observer = algorithm.AddObserver("ProgressEvent", lambda *_: algorithm.SetAbortExecute(1))
    algorithm.UpdatePiece(rank, last + 1, 0)
    if observer:
        algorithm.RemoveObserver(observer)
    algorithm.SetAbortExecute(0)
    return status(algorithm)


def names(attributes):
    """Of all arrays, sorted."""
    return sorted(attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays()))


boolean = joined(vtkPolyDataBooleanOperationFilter(), 64)
update(boolean)
output = boolean.GetOutput()
report = {
    "cells": output.GetNumberOfCells(),
    "arrays": [names(output.GetPointData()), names(output.GetCellData())],
    "fields": names(output.GetFieldData()),
    "status when the first stops": update(boolean, stopper=0),
    "status after it": update(boolean),
    "status when the last stops": update(boolean, stopper=last),
}

distance = joined(vtkPolyDataDistance(), 128)
report["distance when the last stops"] = update(distance, stopper=last)
report["distance after it"] = update(distance)

with open(os.path.join(sys.argv[-1], f"rank{rank}.json"), "w", encoding="utf-8") as file:
    json.dump(report, file)
