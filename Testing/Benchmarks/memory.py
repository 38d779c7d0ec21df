# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What every filter takes of memory where the input has ten million triangles, or points: less than 12 GiB.

    . build/env.sh; /usr/bin/python3 Testing/Benchmarks/memory.py [--triangles N] [words of names ...]

Each case runs in a process of its own, one after another; its peak is all that the process ever held, the
input and the outputs included. The exit status is 1 where a case failed or took more. No other library takes part.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import time

import numpy as np

GIB = 2**30
ALLOWED = 12 * GIB
LIMIT = 18 * GIB  # of address space: a case that goes wrong must not take the machine with it


def bumpy_sphere(triangles, phase=0.0, centre=(0.0, 0.0, 0.0), radius=1.0, bumps=0.05):
    """A closed surface of parallels and meridians: points (float64) and triangles (int64)."""
    around = max(8, int(np.sqrt(triangles)))
    along = triangles // (2 * around)
    angle = np.arange(around) * (2 * np.pi / around)
    height = np.arange(1, along) * (np.pi / along)
    points = np.empty((2 + around * (along - 1), 3))
    ring = points[2:].reshape(along - 1, around, 3)
    ring[..., 0] = np.sin(height)[:, None] * np.cos(angle)
    ring[..., 1] = np.sin(height)[:, None] * np.sin(angle)
    ring[..., 2] = np.cos(height)[:, None]
    points[0], points[1] = (0, 0, 1), (0, 0, -1)
    points *= (1 + bumps * np.prod(np.sin(12 * points + phase), axis=1))[:, None] * radius
    points += centre
    here = np.arange(around)
    after = (here + 1) % around
    cells = np.empty((2 * around * (along - 1), 3), dtype=np.int64)
    cells[:around] = np.stack([0 * here, 2 + here, 2 + after], axis=1)
    last = 2 + around * (along - 2)
    cells[-around:] = np.stack([0 * here + 1, last + after, last + here], axis=1)
    first = 2 + around * np.arange(along - 2)[:, None]
    body = cells[around:-around].reshape(along - 2, around, 2, 3)
    for k, (row, column) in enumerate([(0, here), (1, here), (1, after)]):
        body[:, :, 0, k] = first + row * around + column
    for k, (row, column) in enumerate([(0, here), (1, after), (0, after)]):
        body[:, :, 1, k] = first + row * around + column
    return points, cells


def polydata(points, cells=None):
    """With normals, as most surfaces have them, and an array of the cells."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    normals = numpy_to_vtk((points / np.linalg.norm(points, axis=1)[:, None]).astype(np.float32), deep=True)
    normals.SetName("Normals")
    data.GetPointData().SetNormals(normals)
    if cells is not None:
        polys = vtkCellArray()
        offsets = numpy_to_vtkIdTypeArray(np.arange(0, 3 * len(cells) + 1, 3), deep=True)
        polys.SetData(offsets, numpy_to_vtkIdTypeArray(cells.ravel(), deep=True))
        data.SetPolys(polys)
        part = numpy_to_vtk(np.arange(len(cells), dtype=np.int32), deep=True)
        part.SetName("Part")
        data.GetCellData().AddArray(part)
    return data


def contours(loops, corners):
    """Rings beside each other, all in the plane z = 0, as polylines."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    angle = np.arange(corners) * (2 * np.pi / corners)
    side = int(np.ceil(np.sqrt(loops)))
    middle = np.stack(np.divmod(np.arange(loops), side), axis=1) * 2.5
    points = np.zeros((loops, corners, 3))
    points[..., :2] = middle[:, None] + np.stack([np.cos(angle), np.sin(angle)], axis=1)
    ids = np.arange(loops * corners).reshape(loops, corners)
    ids = np.concatenate([ids, ids[:, :1]], axis=1)
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points.reshape(-1, 3), deep=True))
    lines = vtkCellArray()
    offsets = numpy_to_vtkIdTypeArray(np.arange(0, ids.size + 1, corners + 1), deep=True)
    lines.SetData(offsets, numpy_to_vtkIdTypeArray(ids.ravel(), deep=True))
    data.SetLines(lines)
    return data


def halves(count):
    """Two bodies that cross each other all over."""
    return [bumpy_sphere(count // 2), bumpy_sphere(count // 2, phase=1.3)]


def body_and_tool(count):
    return [bumpy_sphere(count), bumpy_sphere(2000, centre=(1.0, 0.1, 0.2), radius=0.2)]


def plane():
    from vtkmodules.vtkCommonDataModel import vtkPlane

    made = vtkPlane()
    made.SetOrigin(0.05, 0.02, 0.01)
    made.SetNormal(0.2, 0.3, 1)
    return made


def cloud(count):
    """As many points on a sphere, with their normals."""
    return bumpy_sphere(2 * count, bumps=0.0)[0]


CLIP = {"UsePlane": 1, "Origin": (0.05, 0.02, 0.01), "Normal": (0.2, 0.3, 1)}
CUT = {"Origin": (0.05, 0.02, 0.01), "Normal": (0.2, 0.3, 1)}
DISTANCES = {"ComputeSecondDistance": 1, "ComputeNearestPoint": 1, "ComputeNearestCellId": 1, "ComputeDirection": 1}


def surfaces(make):
    return lambda count: [polydata(*mesh) for mesh in make(count)]


def one(count):
    return [bumpy_sphere(count)]


def cloud_and(*tool):
    return lambda count: [polydata(cloud(count)), *(polydata(*mesh) for mesh in tool)]


BALL = bumpy_sphere(2000, centre=(1.0, 0.1, 0.2), radius=0.2)

# Name, class, settings, inputs of so many triangles (points of a cloud).
CASES = [
    ("Boolean, union of halves", "vtkPolyDataBooleanOperationFilter", {"Operation": 0}, surfaces(halves)),
    ("Boolean, small tool", "vtkPolyDataBooleanOperationFilter", {"Operation": 2}, surfaces(body_and_tool)),
    ("Boolean, resolve", "vtkPolyDataBooleanOperationFilter", {"Operation": 4}, surfaces(one)),
    ("Intersection of halves", "vtkPolyDataIntersection", {}, surfaces(halves)),
    ("Distance of halves, both", "vtkPolyDataDistance", DISTANCES, surfaces(halves)),
    ("Distance field", "vtkPolyDataDistanceField", {"Dimensions": (64, 64, 64)}, surfaces(one)),
    ("Check", "vtkPolyDataSurfaceCheck", {}, surfaces(one)),
    ("Clip", "vtkPolyDataClipClosedSurface", CLIP, surfaces(one)),
    ("Cut", "vtkPolyDataCutClosedSurface", CUT, surfaces(one)),
    ("Contour triangulator", "vtkPolyDataContourTriangulator", {}, lambda count: [contours(count // 1000, 1002)]),
    ("Point set surface", "vtkPointSetSurfaceFilter", {"GenerateSurface": 0}, cloud_and()),
    ("Point set intersection", "vtkPointSetIntersectionFilter", {"Plane": plane}, cloud_and()),
    ("Point set surface, mesh", "vtkPointSetSurfaceFilter", {"GenerateSurface": 1}, cloud_and()),
    ("Point set Boolean", "vtkPointSetBooleanFilter", {"Operation": 2}, cloud_and(BALL)),
]


def memory(kind):
    """A line of the process's own figures, in bytes."""
    with open("/proc/self/status", encoding="ascii") as lines:
        return next(int(line.split()[1]) * 1024 for line in lines if line.startswith(kind))


def measure(name, count):
    """Run one case in this process."""
    import surfacebooleans.vtk

    resource.setrlimit(resource.RLIMIT_AS, (LIMIT, LIMIT))
    _, class_name, settings, make = next(case for case in CASES if case[0] == name)
    tested = getattr(surfacebooleans.vtk, class_name)()
    for key, value in settings.items():
        value = value() if callable(value) else value
        getattr(tested, "Set" + key)(*(value if isinstance(value, tuple) else (value,)))
    inputs = make(count)
    for port, data in enumerate(inputs):
        tested.SetInputDataObject(port, data)
    before, start = memory("VmRSS"), time.perf_counter()
    tested.Update()
    outputs = [tested.GetOutputDataObject(port) for port in range(tested.GetNumberOfOutputPorts())]
    fields = outputs[0].GetFieldData()
    return {
        "input": before,
        "peak": memory("VmHWM"),
        "seconds": time.perf_counter() - start,
        "cpu": sum(resource.getrusage(resource.RUSAGE_SELF)[:2]),
        "status": int(fields.GetArray("Status").GetValue(0)),
        "message": fields.GetAbstractArray("Message").GetValue(0),
        "cells": [data.GetNumberOfCells() for data in outputs],
    }


def in_process(name, count):
    """The answer of a process of its own; None if it ended otherwise."""
    command = [sys.executable, os.path.abspath(__file__), "--triangles", str(count), "--one", name]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    return json.loads(done.stdout.splitlines()[-1]) if done.returncode == 0 else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("words", nargs="*", help="only cases whose names contain one of them")
    parser.add_argument("--triangles", type=int, default=10**7, help="of the input, or points of a cloud")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.one:
        print(json.dumps(measure(options.one, options.triangles)))
        return 0
    print(f"{'case':28} {'peak':>7} {'input':>7} {'wall s':>7} {'CPU s':>7}  cells of the outputs")
    good = True
    for name, *_ in CASES:
        if options.words and not any(word.lower() in name.lower() for word in options.words):
            continue
        answer = in_process(name, options.triangles)
        if answer is None:
            good = False
            print(f"{name:28} ended without an answer", flush=True)
            continue
        good &= answer["status"] == 0 and answer["peak"] < ALLOWED
        sizes = " ".join(f"{answer[key] / GIB:7.2f}" for key in ("peak", "input"))
        times = f"{answer['seconds']:7.1f} {answer['cpu']:7.1f}"
        print(f"{name:28} {sizes} {times}  {answer['cells']} {answer['message']}", flush=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
