# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of "VTK/Closed Surface Clipping" anew: colours, an inner surface, outlines, triangles.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/closed_surface_clipping.py FSAVERAGE5

FSAVERAGE5 is nilearn's folder nilearn/datasets/data/fsaverage5, with the pial and the white surface of a brain.
"""

import pathlib
import sys

import numpy as np
from surfacebooleans.vtk import vtkPolyDataClipClosedSurface
from vtkmodules.vtkFiltersSources import vtkOutlineSource

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "Testing" / "Filters")]

import meshes  # noqa: E402
from booleans import polydata  # noqa: E402
from clips import plane_collection  # noqa: E402
from gifti import read_gifti  # noqa: E402
from offscreen import INK, actor_of, color_cells, look, save, side_by_side, smooth_actor, white_room  # noqa: E402

CELL = 560  # pixels
BASE, CLIP, ACTIVE = (0.36, 0.56, 0.86), (0.95, 0.60, 0.20), (0.98, 0.85, 0.30)


def clipped(data, planes, **settings):
    clip = vtkPolyDataClipClosedSurface()
    clip.SetInputData(data)
    clip.SetClippingPlanes(plane_collection(planes))
    clip.SetScalarModeToColors()
    clip.SetBaseColor(BASE)
    clip.SetClipColor(CLIP)
    clip.SetActivePlaneColor(ACTIVE)
    for name, value in settings.items():
        getattr(clip, "Set" + name)(value)
    clip.Update()
    return clip.GetOutput()


def actor(data, smooth=True):
    """Coloured by the array Colors; shaded smoothly but for creases."""
    result = smooth_actor(data, crease=40) if smooth else actor_of(data)
    color_cells(result, "Colors")
    result.GetProperty().SetAmbient(0.25)
    result.GetProperty().SetDiffuse(0.85)
    result.GetProperty().SetSpecular(0.1)
    result.GetProperty().SetSpecularPower(25)
    return result


def colors():
    """A hollow body cut through: an inner surface that is inside out is a hole."""
    body = meshes.revolved(vase(), 160)
    planes = [((0, 0, 0), (0.5, 0.87, 0)), ((0, 0, 1.0), (0.1, 0.2, -1))]
    inner = meshes.revolved(vase() * [0.86, 0.93] + [0, 0.06], 160)
    data = polydata(meshes.joined(body, meshes.inside_out(inner)))
    return [actor(clipped(data, planes, ActivePlaneId=1))], (1.2, -6.5, 2.6)


def vase():
    heights = np.linspace(-1.5, 1.5, 121)
    radii = (0.75 + 0.28 * np.sin(2.3 * heights + 0.6)) * np.sqrt(np.maximum(0, 1 - (heights / 1.5) ** 8))
    return np.column_stack([radii, heights])


def brain(folder):
    """The surface of a brain, with the white matter's inside it: turned inside out, it is a hole."""
    skin = read_gifti(folder / "pial_left.gii.gz")
    inner = read_gifti(folder / "white_left.gii.gz")
    grey = meshes.joined(meshes.mesh(*skin), meshes.inside_out(meshes.mesh(*inner)))
    planes = [((-32, -20, 18), (0, 0, -1)), ((-32, -14, 0), (0.0, 1, 0))]
    matter = clipped(polydata(grey), planes, BaseColor=(0.83, 0.66, 0.62), ClipColor=(0.72, 0.34, 0.32))
    white = clipped(polydata(meshes.mesh(*inner)), planes, BaseColor=(0.95, 0.94, 0.9), ClipColor=(0.97, 0.96, 0.92))
    return [actor(matter), actor(white)], (-2.2, -1.9, 1.5)


def cube():
    """The outline of a cube, clipped: its own edges and those of the cuts."""
    source = vtkOutlineSource()
    source.SetBounds(-1, 1, -1, 1, -1, 1)
    source.GenerateFacesOn()
    source.Update()
    planes = [((0.5, -0.5, 0.5), (-1, 1, -1)), ((-0.7, 0, 0), (1, 0.2, -0.1))]
    lines = clipped(source.GetOutput(), planes, GenerateFaces=0, GenerateOutline=1, ActivePlaneId=0, ActivePlaneColor=(0.85, 0.2, 0.15))
    result = actor(lines, False)
    result.GetProperty().SetLineWidth(4)
    result.GetProperty().SetLighting(False)
    return [result], (2.0, -3.4, 1.9)


def triangles():
    """The triangles of a cap with holes."""
    gear = meshes.cgal_mesh("rotor")
    data = clipped(polydata(gear), [(tuple(gear.points.mean(axis=0)), (0.2, -0.3, -1))])
    result = actor(data, False)
    result.GetProperty().EdgeVisibilityOn()
    result.GetProperty().SetEdgeColor(INK)
    return [result], (0.5, -0.9, 2.4)


def room(actors, direction):
    result = white_room(actors)
    look(result, direction, zoom=0.97)
    return result


def main():
    pictures = (colors(), brain(pathlib.Path(sys.argv[1])), cube(), triangles())
    rooms = side_by_side([room(*picture) for picture in pictures], columns=2)
    save(HERE / "closed_surface_clipping.png", rooms, (2 * CELL, 2 * CELL))


if __name__ == "__main__":
    main()
