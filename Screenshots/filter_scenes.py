# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""A small case for each filter: its inputs, and the filter on them. The panels' and the help's pictures are made of these.

The elephant and the cat come from Debian's libcgal-demo, the screw from occt-misc.
"""

import pathlib
import sys
import tarfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "Python"))

from demo_elephant import ARCHIVE, write_elephant  # noqa: E402
from demo_scan import SCAN, SCREW, make_body  # noqa: E402

ELEPHANT_VIEW = ((0.55, 0.35, 1), (0, 1, 0))
SLANTED_VIEW = ((0.8, -1, 0.7), (0, 0, 1))
FRONT_VIEW = ((0.25, 0.3, 1), (0, 1, 0))
INPUT, TOOL, SECOND = [0.45, 0.6, 0.85], [0.9, 0.6, 0.35], [0.75, 0.05, 0.1]
NO_COLOUR = ("POINTS", None)
CAT_ON_SCREW = (-0.4, 0.4, -1, 0.4, -0.4, 0.4)  # xmin, xmax, ymin, ymax, zmin, zmax


class Scene:
    """What a case consists of, and how it is looked at.

    inputs : the sources, by the name of the property that takes them
    view : where the eye is, as seen from the middle, and what is up
    colour : the array that the result is coloured by: "POINTS" or "CELLS", and its name
    shown : the outputs that tell most, each with its representation; all but the first are red
    context : whether the inputs are shown with them, faintly
    near : the box to look at, if not everything
    fit : how large everything is in the picture, against the ball around it
    settings : the other properties of the filter
    """

    def __init__(self, inputs, view=FRONT_VIEW, colour=None, shown=((0, "Surface"),), **settings):
        self.inputs = inputs
        self.view = view
        self.colour = colour
        self.shown = shown
        self.context = settings.pop("context", False)
        self.near = settings.pop("near", None)
        self.fit = settings.pop("fit", 0.72)
        self.settings = settings


def elephant(folder):
    mesh = simple.LegacyVTKReader(FileNames=[str(write_elephant(folder / "elephant.vtk"))])
    return simple.GenerateSurfaceNormals(registrationName="Elephant", Input=mesh, Splitting=0)


def placed(source, name, rotate=(0, 0, 0), translate=(0, 0, 0)):
    moved = simple.Transform(registrationName=name, Input=source)
    moved.Transform.Rotate = list(rotate)
    moved.Transform.Translate = list(translate)
    return moved


def drill():
    upright = simple.Cylinder(Radius=0.072, Height=0.8, Resolution=96)
    return placed(upright, "Drill", rotate=(75, 0, -90), translate=(-0.075, -0.17, 0.02))


def surface_boolean(folder):
    inputs = {"Input": elephant(folder), "Tool": drill()}
    return Scene(inputs, ELEPHANT_VIEW, ("CELLS", "SourceId"), Operation="Difference")


def surface_intersection(folder):
    ball = simple.Sphere(registrationName="Ball", Radius=0.3, Center=[0, -0.1, 0.1], ThetaResolution=96, PhiResolution=96)
    outputs = ((1, "Surface"), (0, "Surface"))
    return Scene({"Input": elephant(folder), "Tool": ball}, ELEPHANT_VIEW, ("CELLS", "PatchId"), outputs)


def surface_check(folder):
    ball = simple.Sphere(Radius=0.12, Center=[-0.1, -0.2, 0.2], ThetaResolution=24, PhiResolution=24)
    body = elephant(folder)
    hole = simple.Clip(Input=body, ClipType="Sphere", Invert=0)
    hole.ClipType.Center, hole.ClipType.Radius = [0.05, 0.1, 0.25], 0.12
    both = simple.AppendGeometry(Input=[simple.ExtractSurface(Input=hole), ball])
    return Scene({"Input": simple.Clean(registrationName="Faulty elephant", Input=both)}, ELEPHANT_VIEW, ("CELLS", "Defect"), ((0, "Surface"), (1, "Surface")))


def surface_distance(folder):
    body = elephant(folder)
    thinned = simple.Decimate(Input=simple.Triangulate(Input=body), TargetReduction=0.99, PreserveTopology=1)
    thinned = simple.GenerateSurfaceNormals(registrationName="Simplified elephant", Input=thinned, Splitting=0)
    return Scene({"Input": body, "Tool": thinned}, ELEPHANT_VIEW, ("POINTS", "Distance"))


def surface_distance_field(folder):
    outputs = ((0, "Slice"),)
    settings = {"Dimensions": [96, 96, 96], "context": True, "fit": 0.9}
    return Scene({"Input": elephant(folder)}, ELEPHANT_VIEW, ("POINTS", "Distance"), outputs, **settings)


def closed_surface_clip(folder):
    settings = {"Origin": [0, -0.1, 0], "Normal": [-0.2, 0, -1], "Planes": [0, -0.35, 0, 0, 1, 0.15], "fit": 0.9}
    return Scene({"Input": elephant(folder)}, ELEPHANT_VIEW, ("CELLS", "SourceId"), **settings)


def closed_surface_cut(folder):
    settings = {"Origin": [0, 0, 0], "Normal": [0, 0, 1], "Offsets": list(np.linspace(-0.3, 0.3, 13))}
    return Scene({"Input": elephant(folder)}, ELEPHANT_VIEW, ("CELLS", "Area"), **settings)


def contour_triangulator(folder):
    lines = simple.Slice(registrationName="Contours", Input=elephant(folder), Triangulatetheslice=0)
    lines.SliceType.Origin, lines.SliceType.Normal = [0, 0, 0.08], [0, 0, 1]
    return Scene({"Input": lines}, ((0, 0, 1), (0, 1, 0)), ("CELLS", "PolygonId"), fit=0.95)


def cat(folder):
    """The scanned points, and their normals, as a file."""
    with tarfile.open(ARCHIVE) as archive:
        rows = np.loadtxt(archive.extractfile(SCAN))
    cloud = vtkPolyData()
    cloud.SetPoints(vtkPoints())
    cloud.GetPoints().SetData(numpy_to_vtk(rows[:, :3], deep=True))
    normals = numpy_to_vtk(rows[:, 3:], deep=True)
    normals.SetName("Normals")
    cloud.GetPointData().SetNormals(normals)
    vertices = vtkVertexGlyphFilter()  # without a cell they would not be drawn
    vertices.SetInputData(cloud)
    writer = vtkPolyDataWriter()
    writer.SetFileName(str(folder / "kitten.vtk"))
    writer.SetInputConnection(vertices.GetOutputPort())
    writer.Write()
    return simple.LegacyVTKReader(registrationName="Scan", FileNames=[str(folder / "kitten.vtk")])


def point_set_surface(folder):
    outputs = ((1, "Surface"),)
    return Scene({"Input": cat(folder)}, colour=("POINTS", "MeanCurvature"), shown=outputs, fit=0.8, GenerateSurface=1)


def point_set_intersection(folder):
    return Scene({"Input": cat(folder), "Tool": make_body()}, context=True, near=CAT_ON_SCREW)


def point_set_boolean(folder):
    return Scene({"Input": cat(folder), "Tool": make_body()}, colour=("CELLS", "SourceId"), near=CAT_ON_SCREW)


def nurbs_reader(_folder):
    return Scene({}, SLANTED_VIEW, ("CELLS", "FaceId"), fit=1, FileName=SCREW)


SCENES = {
    "SurfaceBoolean": surface_boolean,
    "SurfaceIntersection": surface_intersection,
    "SurfaceDistance": surface_distance,
    "SurfaceDistanceField": surface_distance_field,
    "SurfaceCheck": surface_check,
    "ClosedSurfaceClip": closed_surface_clip,
    "ClosedSurfaceCut": closed_surface_cut,
    "ContourTriangulator": contour_triangulator,
    "PointSetSurface": point_set_surface,
    "PointSetIntersection": point_set_intersection,
    "PointSetBoolean": point_set_boolean,
    "NURBSReader": nurbs_reader,
}


def look_from(view, scene):
    direction, up = scene.view
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = list(direction)
    view.CameraViewUp = list(up)
    if scene.near:
        view.SMProxy.ResetCamera(scene.near)
    else:
        view.CameraParallelProjection = 1
        simple.ResetCamera(view)
        view.CameraParallelScale *= scene.fit


def show_inputs(view, scene, opacity=1):
    for name, source in scene.inputs.items():
        display = simple.Show(source, view)
        simple.ColorBy(display, NO_COLOUR)
        display.DiffuseColor = display.AmbientColor = TOOL if name == "Tool" else INPUT
        display.Opacity = opacity
        display.LineWidth, display.RenderLinesAsTubes = 3, 1
        display.PointSize = 3


def show_result(view, scene, result):
    for port, representation in scene.shown:
        display = simple.Show(simple.OutputPort(result, port), view)
        display.Representation = representation
        display.LineWidth, display.PointSize, display.RenderLinesAsTubes = 4, 3, 1
        colour = scene.colour if port == scene.shown[0][0] else None
        simple.ColorBy(display, colour or NO_COLOUR)
        if colour:
            display.SetScalarBarVisibility(view, False)
        else:
            display.DiffuseColor = display.AmbientColor = SECOND
    if scene.context:
        show_inputs(view, scene, opacity=0.2)
