# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a brain cut to an icosahedron: twenty planes in one Closed Surface Clip.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/many_planes.py FSAVERAGE5

FSAVERAGE5 is nilearn's folder nilearn/datasets/data/fsaverage5. Grey and white matter are clipped by the same planes;
the white matter's surface, turned inside out, is a hole in the grey.
"""

import pathlib
import sys

import numpy as np
import surfacebooleans as sb
from gifti import read_gifti
from offscreen import look, result_actor, save, side_by_side, white_room
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkReverseSense
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.util.numpy_support import vtk_to_numpy

HERE = pathlib.Path(__file__).resolve().parent
GREY, GREY_CUT = (0.83, 0.66, 0.62), (0.72, 0.34, 0.32)
WHITE, WHITE_CUT = (0.95, 0.94, 0.90), (0.90, 0.89, 0.85)
CREASE = 40  # degrees: less than between the icosahedron's faces
CENTER, RADIUS = np.array((-44.0, -20.0, 18.0)), 29.0  # mm; of the ball that all planes touch


def planes():
    """Each face of an icosahedron; kept is what their normals point to."""
    source = vtkPlatonicSolidSource()
    source.SetSolidTypeToIcosahedron()
    source.Update()
    solid = source.GetOutput()
    corners = vtk_to_numpy(solid.GetPoints().GetData())
    faces = vtk_to_numpy(solid.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    outward = corners[faces].mean(axis=1)
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    return [(CENTER + RADIUS * normal, -normal) for normal in outward]


def matter(folder):
    """(grey, white) as closed surfaces."""
    pial, inner = (sb.polydata(*read_gifti(folder / f"{name}_left.gii.gz")) for name in ("pial", "white"))
    hole = vtkReverseSense()
    hole.SetInputData(inner)
    both = vtkAppendPolyData()
    both.AddInputData(pial)
    both.AddInputConnection(hole.GetOutputPort())
    both.Update()
    return both.GetOutput(), inner


def main(folder):
    grey, white = matter(folder)
    rooms = []
    for inside_out in (False, True):
        parts = [sb.clip(part, planes(), inside_out=inside_out) for part in (grey, white)]
        actors = [result_actor(parts[0], (GREY, GREY_CUT), CREASE, 0), result_actor(parts[1], (WHITE, WHITE_CUT), CREASE, 0)]
        rooms.append(white_room(actors, contrast=2))
        look(rooms[-1], (-2.2, -1.3, 1.2), zoom=1.2)
    save(HERE / "many_planes.png", side_by_side(rooms), (1240, 560))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
