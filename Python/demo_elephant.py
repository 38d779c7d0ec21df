# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The elephant that Debian's package libcgal-demo brings, as a file that ParaView can read."""

import sys
import tarfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter

ARCHIVE = "/usr/share/doc/libcgal-dev/data.tar.gz"
MEMBER = "data/meshes/refined_elephant.off"


def read_elephant():
    """Points, shape (n, 3), and triangles, shape (m, 3)."""
    try:
        with tarfile.open(ARCHIVE) as archive:
            words = archive.extractfile(MEMBER).read().split()
    except FileNotFoundError:
        sys.exit(f"{ARCHIVE} is missing; install it: apt-get install libcgal-demo")
    number_of_points, number_of_triangles = int(words[1]), int(words[2])
    points_end = 4 + 3 * number_of_points
    points = np.array(words[4:points_end], dtype=np.float64).reshape(-1, 3)
    faces = np.array(words[points_end : points_end + 4 * number_of_triangles], dtype=np.int64)
    return points, faces.reshape(-1, 4)[:, 1:]  # each line starts with its number of corners, 3


def write_elephant(path):
    """Write the elephant to a .vtk file; returns its path."""
    points, triangles = read_elephant()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    cells = vtkCellArray()
    offsets = np.arange(0, triangles.size + 1, 3)
    cells.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True),
        numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True),
    )
    surface = vtkPolyData()
    surface.SetPoints(vtk_points)
    surface.SetPolys(cells)
    writer = vtkPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetFileTypeToBinary()
    writer.SetInputData(surface)
    writer.Write()
    return path
