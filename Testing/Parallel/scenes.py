# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs every filter on data that are spread over the processes of a server, and writes down what came out.

    pvbatch scenes.py facts.json [host port]

What a source delivers in pieces, a file in the first process, and pieces with ghost cells all occur. Outputs are looked
at as they are and after Clean, which asks for them in another way. With a host and a port the filters run on that server,
without Clean. Facts are such that they do not depend on how data are spread: cells as the sorted
coordinates of their corners, the names and types of arrays, and numbers of the field data.
"""

import hashlib
import json
import os
import sys

import numpy as np
from paraview import simple, servermanager
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import vtk_to_numpy

CAD_FILE = "/usr/share/opencascade/data/step/screw.step"
TIMES = {"StageNames", "StageSeconds"}
# Clean takes no images, contours of them stay where they are, as does what Force Time hands on, and Merge Blocks and Clean
# wait for ever by themselves where there are several processes.
NOT_CLEANED = {
    *(f"Distance at {time}" for time in (0.0, 0.25, 0.5)),
    "Distance field by dimensions",
    "Distance field by spacing",
    "Distance of an image",
    "Contour triangulator of blocks",
}

# Pieces of a sphere, each with the cells around it as ghosts: what a parallel simulation has.
GHOSTS = """
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkCommonCore import vtkIdList, vtkUnsignedCharArray
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
request = self.GetOutputInformation(0)
piece, pieces = request.Get(Pipeline.UPDATE_PIECE_NUMBER()), request.Get(Pipeline.UPDATE_NUMBER_OF_PIECES()) or 1
sphere = vtkSphereSource()
sphere.SetThetaResolution(24)
sphere.SetPhiResolution(16)
sphere.Update()
whole = sphere.GetOutput()
count = whole.GetNumberOfCells()
own = range(count * piece // pieces, count * (piece + 1) // pieces)
points = {whole.GetCell(i).GetPointId(k) for i in own for k in range(3)}
marks = vtkUnsignedCharArray()
marks.SetName("vtkGhostType")
output.SetPoints(whole.GetPoints())
output.GetPointData().ShallowCopy(whole.GetPointData())
output.AllocateEstimate(count, 3)
for i in range(count):
    ids = [whole.GetCell(i).GetPointId(k) for k in range(3)]
    if i in own or points.intersection(ids):
        output.InsertNextCell(5, 3, ids)
        marks.InsertNextValue(0 if i in own else vtkDataSetAttributes.DUPLICATECELL)
output.GetCellData().AddArray(marks)
"""
HANDLES_PIECES = """
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
self.GetOutputInformation(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
"""

# A sphere that moves with time, in pieces.
MOVING = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersSources import vtkSphereSource
request = self.GetOutputInformation(0)
time = request.Get(Pipeline.UPDATE_TIME_STEP()) if request.Has(Pipeline.UPDATE_TIME_STEP()) else 0.0
sphere = vtkSphereSource()
sphere.SetCenter(0.3 + time, 0.1, 0.05)
sphere.SetThetaResolution(24)
sphere.SetPhiResolution(16)
sphere.UpdatePiece(request.Get(Pipeline.UPDATE_PIECE_NUMBER()), request.Get(Pipeline.UPDATE_NUMBER_OF_PIECES()) or 1, 0)
output.ShallowCopy(sphere.GetOutput())
"""
HAS_TIMES = (
    HANDLES_PIECES
    + """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
self.GetOutputInformation(0).Set(Pipeline.TIME_STEPS(), [0.0, 0.25, 0.5], 3)
self.GetOutputInformation(0).Set(Pipeline.TIME_RANGE(), [0.0, 0.5], 2)
"""
)


def arrays_of(attributes):
    """Name, type and components of each array, sorted."""
    arrays = [attributes.GetAbstractArray(i) for i in range(attributes.GetNumberOfArrays())]
    facts = [[array.GetName() or "", array.GetDataType(), array.GetNumberOfComponents()] for array in arrays]
    return sorted(fact for fact in facts if fact[0] != "vtkGhostType")  # one process has nobody to share with


def fields_of(data):
    """Numbers to nine digits, texts as they are; without times."""
    facts = {}
    fields = data.GetFieldData()
    for i in range(fields.GetNumberOfArrays()):
        array = fields.GetAbstractArray(i)
        if array.GetName() in TIMES:
            continue
        values = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
        if "CellId" in array.GetName():  # processes count their cells one after another
            values = [len(values)]
        facts[array.GetName()] = [v if isinstance(v, str) else float(f"{v:.9g}") for v in values]
    return facts


def shape_of(data):
    """Counts, and a digest of the cells that depends neither on their order nor on that of their points."""
    points = data.GetNumberOfPoints()
    facts = {"points": points, "cells": data.GetNumberOfCells()}
    if data.IsA("vtkImageData"):
        return facts | {"bounds": [float(f"{bound:.4g}") for bound in data.GetBounds()]}
    if not points:
        return facts
    places = np.round(dataset_adapter.WrapDataObject(data).Points, 5) + 0.0
    cells = []
    for i in range(data.GetNumberOfCells()):
        ids = data.GetCell(i).GetPointIds()
        cells.append(sorted(tuple(places[ids.GetId(k)]) for k in range(ids.GetNumberOfIds())))
    if not cells:
        cells = [[tuple(place)] for place in places]
    facts["digest"] = hashlib.sha256(repr(sorted(cells)).encode()).hexdigest()
    return facts


def values_of(data, name):
    """An array's values, sorted, so that two runs can be compared."""
    array = data.GetPointData().GetArray(name)
    return sorted(float(f"{value:.6g}") for value in vtk_to_numpy(array).ravel()) if array else []


def facts_of(proxy, port=0, values=(), spread=False):
    """Everything that is compared about one output; of one that stays spread, borders are in two pieces."""
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy, idx=port)
    facts = shape_of(data) | {"fields": fields_of(data)}
    if facts["points"]:  # what Fetch makes of nothing but empty pieces has no arrays
        facts["point arrays"] = arrays_of(data.GetPointData())
        facts["cell arrays"] = arrays_of(data.GetCellData())
    if spread:
        del facts["points"]
        return facts
    for name in values:
        facts[name] = hashlib.sha256(repr(values_of(data, name)).encode()).hexdigest()
    return facts


def sphere(**settings):
    """A source that delivers a piece to each process."""
    return simple.Sphere(**({"ThetaResolution": 24, "PhiResolution": 16} | settings))


def from_file(folder):
    """A torus that only the first process has: readers of such files do not divide them."""
    path = os.path.join(folder, "tool.stl")
    torus = simple.Superquadric(Toroidal=1, Center=[0.25, 0.1, 0.0], ThetaResolution=16, PhiResolution=16, Size=0.5)
    simple.SaveData(path, proxy=simple.Clean(Input=simple.Triangulate(Input=torus)))
    return simple.STLReader(FileNames=[path])


def with_ghosts():
    """Pieces that overlap."""
    source = simple.ProgrammableSource(Script=GHOSTS, ScriptRequestInformation=HANDLES_PIECES)
    source.OutputDataSetType = "vtkPolyData"
    return source


def surface_scenes(folder):
    """Name, filter, number of outputs and arrays whose values count, for each scene with surfaces."""
    tool = from_file(folder)
    for operation in ("Union", "Difference"):
        body = simple.SurfaceBoolean(Input=sphere(), Tool=sphere(Center=[0.3, 0.1, 0.05]), Operation=operation)
        yield "Boolean of pieces, " + operation, body, 2, ()
    yield "Boolean with a file", simple.SurfaceBoolean(Input=sphere(), Tool=tool, Operation="Difference"), 2, ()
    ghosts = simple.SurfaceBoolean(Input=with_ghosts(), Tool=sphere(Radius=0.3, Center=[0.4, 0, 0]))
    yield "Boolean with ghosts", ghosts, 2, ()
    blocks = simple.GroupDatasets(Input=[sphere(), sphere(Center=[0.6, 0, 0])])
    yield "Boolean of blocks", simple.SurfaceBoolean(Input=blocks, Tool=tool, Operation="Difference"), 2, ()
    chained = simple.SurfaceBoolean(Input=sphere(), Tool=tool, Operation="Difference")
    chained = simple.SurfaceBoolean(Input=chained, Tool=sphere(Center=[0, 0.4, 0]), Operation="Difference")
    yield "Boolean of a Boolean", chained, 2, ()
    yield "Boolean without Tool", simple.SurfaceBoolean(Input=sphere(), Operation="Difference"), 2, ()
    yield "Intersection", simple.SurfaceIntersection(Input=sphere(), Tool=tool), 3, ()
    yield "Check", simple.SurfaceCheck(Input=sphere()), 2, ()
    yield "Check with ghosts", simple.SurfaceCheck(Input=with_ghosts()), 2, ()
    plane = {"Origin": [0.05, 0.02, 0.01], "Normal": [1, 0.2, 0.1]}
    yield "Clip", simple.ClosedSurfaceClip(Input=sphere(), **plane), 2, ()
    yield "Cut", simple.ClosedSurfaceCut(Input=sphere(), **plane), 1, ()
    cut = simple.Slice(Input=sphere())
    cut.SliceType.Origin, cut.SliceType.Normal = plane.values()
    yield "Contour triangulator", simple.ContourTriangulator(Input=cut), 1, ()
    other = simple.Slice(Input=tool)
    other.SliceType.Origin, other.SliceType.Normal = [0.25, 0.1, 0.02], [0, 0.1, 1]
    cut = simple.GroupDatasets(Input=[cut, other])
    filled = simple.MergeBlocks(Input=simple.ContourTriangulator(Input=cut), OutputDataSetType="Polygonal Mesh")
    yield "Contour triangulator of blocks", filled, 1, ()


def time_scenes():
    """As surface_scenes: filters whose Tool moves, at several times."""
    moving = simple.ProgrammableSource(Script=MOVING, ScriptRequestInformation=HAS_TIMES)
    moving.OutputDataSetType = "vtkPolyData"
    filters = {
        "Boolean": simple.SurfaceBoolean(Input=sphere(), Tool=moving, Operation="Difference"),
        "Distance": simple.SurfaceDistance(Input=sphere(), Tool=moving),
    }
    for what, made in filters.items():
        for time in (0.0, 0.25, 0.5):
            yield f"{what} at {time}", simple.ForceTime(Input=made, IgnorePipelineTime=1, ForcedTime=time), 1, ["Distance"]


def distance_scenes(folder):
    """As surface_scenes."""
    tool = from_file(folder)
    distances = {"ComputeSecondDistance": 1, "ComputeNearestPoint": 1, "ComputeCellCenterDistance": 1}
    yield "Distance to a file", simple.SurfaceDistance(Input=sphere(), Tool=tool, **distances), 2, ["Distance"]
    pieces = simple.SurfaceDistance(Input=tool, Tool=sphere(), **distances)
    yield "Distance to pieces", pieces, 2, ["Distance"]
    image = simple.SurfaceDistance(Input=simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3]), Tool=sphere())
    image.ComputeSecondDistance = 1
    contour = simple.Contour(Input=image, ContourBy=["POINTS", "Distance"], Isosurfaces=[1.5])
    yield "Distance of an image", contour, 1, ()
    yield "Distance without Tool", simple.SurfaceDistance(Input=sphere()), 2, ()
    for name, settings in {"dimensions": {"Dimensions": [9, 8, 7]}, "spacing": {"Spacing": 0.13}}.items():
        settings["SampleBy"] = name.capitalize()
        yield "Distance field by " + name, simple.SurfaceDistanceField(Input=sphere(), **settings), 1, ["Distance"]


def cloud_scenes():
    """As surface_scenes."""
    cloud = sphere(ThetaResolution=48, PhiResolution=32)
    yield "Cloud's surface", simple.PointSetSurface(Input=cloud), 2, ()
    cut = simple.PointSetIntersection(Input=cloud)
    yield "Cloud's section", cut, 1, ()
    box = simple.Box(XLength=0.6, YLength=0.6, ZLength=2.0, Center=[0.3, 0.2, 0.1])
    box = simple.Triangulate(Input=box)
    yield "Cloud's Boolean", simple.PointSetBoolean(Input=cloud, Tool=box, Operation="Difference"), 3, ()


def designed_scenes(folder):
    """As surface_scenes; only where the plugin reads CAD files and there is one."""
    if hasattr(simple, "NURBSReader") and os.path.exists(CAD_FILE):
        part = simple.NURBSReader(FileName=CAD_FILE)
        yield "CAD part", part, 1, ()
        cut = simple.ClosedSurfaceClip(Input=part, Origin=[-15, 0, 5], Normal=[1, 0, 0], PassPointData=1)
        yield "CAD part, cut", cut, 2, ()
        path = os.path.join(folder, "cut.step")
        simple.SaveData(path, proxy=cut)
        yield "CAD part, cut, written and read", simple.NURBSReader(FileName=path), 1, ()
        small = simple.Transform(Input=part)
        small.Transform.Scale = [0.02, 0.02, 0.02]
        cloud = sphere(ThetaResolution=48, PhiResolution=32)
        yield "Cloud's section with exact faces", simple.PointSetIntersection(Input=cloud, Tool=small), 1, ()
        joined = simple.PointSetBoolean(Input=cloud, Tool=small, Operation="Union")
        yield "Cloud's Boolean with exact faces", joined, 3, ()
        path = os.path.join(folder, "joined.step")
        simple.SaveData(path, proxy=joined)
        yield "Cloud's Boolean, written and read", simple.NURBSReader(FileName=path), 1, ()


def main(target, *server):
    """All facts as one file."""
    if server:
        simple.Connect(server[0], int(server[1]))
    facts = {}
    folder = os.path.dirname(os.path.abspath(target))
    scenes = [*surface_scenes(folder), *distance_scenes(folder), *time_scenes(), *cloud_scenes(), *designed_scenes(folder)]
    for name, proxy, outputs, values in scenes:
        spread = name.startswith("Distance ") and "field" not in name
        for port in range(outputs):
            facts[f"{name}, output {port}"] = facts_of(proxy, port, values, spread)
        if name == "Contour triangulator of blocks":  # which one process alone keeps apart, arrays and all
            facts[name + ", output 0"] = {kind: facts[name + ", output 0"][kind] for kind in ("cells", "digest")}
        if not server and name not in NOT_CLEANED:
            for port in range(outputs if spread else 1):
                clean = simple.Clean(Input=servermanager.OutputPort(proxy, port))
                facts[f"{name}, output {port}, cleaned"] = facts_of(clean, values=values)
    with open(target, "w", encoding="utf-8") as file:
        json.dump(facts, file, indent=1)


if __name__ == "__main__":
    main(*sys.argv[1:])
