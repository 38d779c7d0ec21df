# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the curves in which a scanned statue meets a screw: a cloud of points and the exact surfaces of a CAD file.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/point_set_intersection.py

The cloud is CGAL's kitten (Debian: libcgal-demo), the screw a STEP file of Open CASCADE's samples (occt-misc), larger
than it is there. Neither is meshed: the facets of the screw are drawn only.
"""

import pathlib
import tarfile

import numpy as np
from surfacebooleans.vtk import vtkNURBSReader, vtkPointSetIntersectionFilter
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from offscreen import actor_of, balls, look, save, white_room

HERE = pathlib.Path(__file__).resolve().parent
CGAL_DATA = "/usr/share/doc/libcgal-dev/data.tar.gz"
SCREW = "/usr/share/opencascade/data/step/screw.step"
SCAN, BODY, CURVES = (0.35, 0.47, 0.66), (0.86, 0.62, 0.36), (0.75, 0.05, 0.10)


def kitten():
    with tarfile.open(CGAL_DATA) as archive:
        rows = np.loadtxt(archive.extractfile("data/points_3/kitten.xyz"))
    cloud, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(rows[:, :3]), deep=True))
    normals = numpy_to_vtk(np.ascontiguousarray(rows[:, 3:6]), deep=True)
    normals.SetName("Normals")
    cloud.SetPoints(points)
    cloud.GetPointData().SetNormals(normals)
    return cloud


def screw():
    """Through the statue's head from side to side; the exact surfaces follow the facets."""
    reader = vtkNURBSReader()
    reader.SetFileName(SCREW)
    reader.Update()
    low, high = np.array(reader.GetOutputDataObject(0).GetBounds()).reshape(3, 2).T
    placed = vtkTransform()
    placed.Translate(-0.02, 0.13, 0.03)
    placed.RotateZ(-12)
    placed.RotateY(-90)
    placed.Scale(*3 * [0.021])
    placed.Translate(*(-(low + high) / 2))
    moved = vtkTransformPolyDataFilter()
    moved.SetInputConnection(reader.GetOutputPort())
    moved.SetTransform(placed)
    return moved


def scene():
    cloud = kitten()
    body = screw()
    meeting = vtkPointSetIntersectionFilter()
    meeting.SetInputData(cloud)
    meeting.SetToolConnection(body.GetOutputPort())
    meeting.Update()
    curves = meeting.GetOutput()
    print(curves.GetNumberOfLines(), "curves,", curves.GetNumberOfPoints(), "points")
    tube = vtkTubeFilter()
    tube.SetInputConnection(meeting.GetOutputPort())
    tube.SetRadius(0.008 * cloud.GetLength())
    tube.SetNumberOfSides(16)
    scan = actor_of(balls(cloud, 0.006 * cloud.GetLength()), SCAN)
    solid = actor_of(body, BODY)
    solid.GetProperty().SetSpecular(0.3)
    line = actor_of(tube, CURVES)
    line.GetProperty().SetAmbient(0.4)
    room = white_room((scan, solid, line))
    look(room, (0.9, 0.5, 3.0), up=(0, 1, 0), zoom=1.25)
    return room


if __name__ == "__main__":
    save(HERE / "point_set_intersection.png", [scene()], (1000, 900))
