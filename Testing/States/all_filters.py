# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""One pipeline of all filters on real data, and its two state files, which are kept beside this script.

    . build/env.sh && cd Testing/States && xvfb-run -a -s "-noreset" pvpython all_filters.py save

writes the data (a folder `data`, which the states name relative to where ParaView runs), all_filters.pvsm and
all_filters_state.py. After a change of properties or defaults, do it again; states made before have to load, too.
Meshes and cloud come from Debian's libcgal-demo, the screw from occt-misc; they are not part of this repository.
"""

import pathlib
import shutil
import sys

from paraview import simple, smstate
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "Filters"))

import clouds  # noqa: E402
import meshes  # noqa: E402
from booleans import polydata  # noqa: E402

SCREW = "/usr/share/opencascade/data/step/screw.step"
ACROSS, DOWN, MIDDLE = 1.3, 1.3, (1.95, -1.2)  # from one result to the next in the picture, and its middle


def make_data(folder="data"):
    """The files that the pipeline reads."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name, body in (("elephant", meshes.cgal_mesh("elephant")), ("knot", meshes.cgal_mesh("knot1"))):
        write(polydata(body), folder / f"{name}.vtk")
    points, _ = clouds.cgal_cloud("kitten.xyz")
    write(clouds.cloud(points[::2]), folder / "kitten.vtk")
    shutil.copy(SCREW, folder)


def write(data, path):
    writer = vtkPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    writer.SetFileTypeToBinary()
    writer.Write()


def read(name):
    return simple.LegacyVTKReader(registrationName=f"{name}.vtk", FileNames=[f"data/{name}.vtk"])


def moved(name, source, **transform):
    result = simple.Transform(registrationName=name, Input=source)
    for key, value in transform.items():
        setattr(result.Transform, key, value)
    return result


def make_pipeline():
    """Every filter once, with properties that are not the defaults; shown side by side."""
    elephant, knot, scan = read("elephant"), read("knot"), read("kitten")
    tool = moved("Tool", knot, Translate=[0.05, 0.02, 0.1])
    screw = simple.NURBSReader(registrationName="screw.step", FileName="data/screw.step", ChordError=0.002)
    body = moved("Screw", screw, Rotate=[-90, 0, 0], Scale=[0.0425] * 3, Translate=[0.7607, -0.73, -0.0356])

    drilled = simple.SurfaceBoolean(registrationName="Drilled", Input=elephant, Tool=tool, Operation="Difference")
    seam = simple.SurfaceIntersection(registrationName="Seam", Input=elephant, Tool=tool)
    seam.SplitSecondOutput = 0
    distance = simple.SurfaceDistance(registrationName="Distance", Input=drilled, Tool=tool)
    distance.ComputeSecondDistance, distance.ComputeNearestPoint = 1, 1
    field = simple.SurfaceDistanceField(registrationName="Field", Input=drilled, Dimensions=[24, 20, 28], Margin=0.02)
    check = simple.SurfaceCheck(registrationName="Check", Input=elephant, SelfIntersections=0)
    clip = simple.ClosedSurfaceClip(registrationName="Clipped", Input=drilled, Origin=[0, 0, 0], Normal=[0, 0.2, 1])
    clip.Planes, clip.GenerateOutline = [0.1, 0, 0, 1, 0, 0], 1
    cut = simple.ClosedSurfaceCut(registrationName="Slices", Input=drilled, Origin=[0, 0, 0], Normal=[1, 0, 0])
    cut.Offsets, cut.Triangulate = [-0.1, 0.0, 0.1, 0.2], 0
    middle = simple.ClosedSurfaceCut(registrationName="Outline", Input=drilled, Origin=[0, 0, 0], Triangulate=0)
    filled = simple.ContourTriangulator(registrationName="Filled", Input=middle)
    skin = simple.PointSetSurface(registrationName="Skin", Input=scan, GenerateSurface=1, CellSize=0.03)
    ring = simple.PointSetIntersection(registrationName="Ring", Input=scan, Tool=body, ChordError=0.002)
    knob = simple.PointSetBoolean(registrationName="Knob", Input=scan, Tool=body, CellSize=0.03)

    results = (
        (drilled, 0, ("CELLS", "SourceId")),
        (seam, 1, ("CELLS", "PatchId")),
        (distance, 0, ("POINTS", "Distance")),
        (field, 0, ("POINTS", "Distance")),
        (check, 0, ("CELLS", "ShellId")),
        (clip, 0, ("CELLS", "SourceId")),
        (cut, 0, ("CELLS", "Area")),
        (filled, 0, ("CELLS", "PolygonId")),
        (skin, 1, ("POINTS", "MeanCurvature")),
        (ring, 0, ("POINTS", "Curvature")),
        (knob, 0, ("CELLS", "SourceId")),
        (body, 0, ("CELLS", "FaceId")),
    )
    simple._DisableFirstRenderCameraReset()
    view = simple.CreateView("RenderView")
    simple.AssignViewToLayout(view=view, layout=simple.CreateLayout("All filters"))
    displays = [
        show(simple.OutputPort(proxy, port), view, colour, place)
        for place, (proxy, port, colour) in enumerate(results)
    ]
    simple.Render(view)
    for display in displays:
        display.RescaleTransferFunctionToDataRange(True, True)  # several share one
        display.LookupTable.AutomaticRescaleRangeMode = "Never"  # a Python state would extend it to what was shown first
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    view.CameraPosition, view.CameraFocalPoint = [*MIDDLE, 10], [*MIDDLE, 0]
    view.CameraViewUp, view.CameraParallelScale = [0, 1, 0], 2.15
    simple.Render(view)


def show(output, view, colour, place):
    """In a table of four columns."""
    display = simple.Show(output, view)
    display.Representation = "Slice" if display.Representation == "Outline" else "Surface"
    simple.ColorBy(display, colour)
    display.SetScalarBarVisibility(view, False)
    display.LineWidth = 2
    name = "Position" if "Position" in display.ListProperties() else "Translation"  # from 5.13 on
    setattr(display, name, [ACROSS * (place % 4), -DOWN * (place // 4), 0])
    return display


if __name__ == "__main__":
    make_data()
    make_pipeline()
    if sys.argv[1:] == ["save"]:
        simple.SaveState(str(HERE / "all_filters.pvsm"))
        (HERE / "all_filters_state.py").write_text(smstate.get_state())
    else:
        import outcome

        outcome.note(sys.argv[1])
