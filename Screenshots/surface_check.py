# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what Surface Check finds on two meshes of libcgal-demo: an elephant with holes, and bones that run into each other.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/surface_check.py
"""

import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "Testing" / "Filters")]

import meshes  # noqa: E402
from checks import BOUNDARY, SELF, TOUCHING, check  # noqa: E402
from offscreen import actor_of, color_cells, draw_in_front, look, save, side_by_side, text, white_room  # noqa: E402

WIDTH, HEIGHT = 620, 560  # pixels of each half
SKIN = (0.66, 0.76, 0.9)
COLORS = {BOUNDARY: (217, 67, 59), TOUCHING: (20, 20, 24), SELF: (217, 67, 59)}


def surface_actor(found):
    """Cells that meet others are orange."""
    data = found.surface
    cells = np.tile((255 * np.array(SKIN)).astype(np.uint8), (data.GetNumberOfCells(), 1))
    cells[found.cell_data["SelfIntersections"] > 0] = (242, 153, 51)
    colors = numpy_to_vtk(cells, deep=True)
    colors.SetName("Colors")
    data.GetCellData().AddArray(colors)
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.ConsistencyOff()
    actor = actor_of(normals)
    color_cells(actor, "Colors")
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.85)
    return actor


def defect_actor(found):
    kinds = found.defect_data["Defect"]
    colors = numpy_to_vtk(np.array([COLORS.get(kind, (0, 0, 0)) for kind in kinds], dtype=np.uint8), deep=True)
    colors.SetName("Colors")
    found.defects.GetCellData().AddArray(colors)
    actor = actor_of(found.defects)
    color_cells(actor, "Colors")
    draw_in_front(actor)
    actor.GetProperty().SetLineWidth(4)
    actor.GetProperty().SetPointSize(11)
    actor.GetProperty().SetRenderPointsAsSpheres(True)
    actor.GetProperty().SetLighting(False)
    return actor


def half(name, words, direction, up, zoom):
    found = check(meshes.cgal_mesh(name))
    room = white_room((surface_actor(found), defect_actor(found), text(words(found), 14, 12)))
    look(room, direction, up, zoom, center=(0, 0, 0))
    return room


def of_holes(found):
    return f"{found.BoundaryLoopCount} loops of boundary edges, {found.NonManifoldPointCount} points where they touch"


def of_crossings(found):
    return f"{found.SelfIntersectionCount} pairs of triangles that cross"


def main():
    halves = (
        half("elephant-with-holes", of_holes, (0.9, 0.5, 2.4), (0, 1, 0), 1.35),
        half("bones", of_crossings, (0.3, -2.4, 0.4), (0, 0, 1), 1.1),
    )
    save(HERE / "surface_check.png", side_by_side(halves), (2 * WIDTH, HEIGHT))


if __name__ == "__main__":
    main()
