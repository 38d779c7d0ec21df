# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a planned resection: the surface of a brain, what is taken out of it, and how much that is.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/brain_resection.py FSAVERAGE5

FSAVERAGE5 is nilearn's folder nilearn/datasets/data/fsaverage5, with the pial surface of a hemisphere, in millimetres.
The margin around the tumour and the way in are one body, drawn with a pencil: a ball and a cone.
"""

import pathlib
import sys

import surfacebooleans as sb
from gifti import read_gifti
from offscreen import look, result_actor, save, side_by_side, text, white_room
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkSphereSource

HERE = pathlib.Path(__file__).resolve().parent
TISSUE, CUT = (0.86, 0.70, 0.66), (0.78, 0.16, 0.14)
TUMOUR, ENTRY = (-46, -14, 42), (-68, -24, 66)  # mm
SIDE = (-2.4, -0.9, 1.4)


def margin():
    """Two bodies that run through each other; the filter unites them."""
    ball = vtkSphereSource()
    ball.SetCenter(TUMOUR)
    ball.SetRadius(17)
    ball.SetThetaResolution(96)
    ball.SetPhiResolution(64)
    ball.Update()
    way = vtkConeSource()
    axis = [a - b for a, b in zip(TUMOUR, ENTRY)]
    way.SetCenter(*[(a + b) / 2 for a, b in zip(TUMOUR, ENTRY)])
    way.SetDirection(axis)
    way.SetHeight(sum(x * x for x in axis) ** 0.5)
    way.SetRadius(22)
    way.SetResolution(128)
    way.Update()
    return [ball.GetOutput(), way.GetOutput()]


def room(surface, words):
    volume = surface.GetFieldData().GetArray("ResultVolume").GetValue(0) / 1000
    actor = result_actor(surface, (TISSUE, CUT), crease=50)  # smooth but for the rim
    return white_room((actor, text(f"{words}: {volume:.1f} ml", 16, 14)), contrast=2)


def main(folder):
    pial, tools = read_gifti(folder / "pial_left.gii.gz"), margin()
    brain = sb.polydata(*pial)
    left = room(sb.boolean(brain, tools, "difference"), "What stays")
    right = room(sb.boolean(brain, tools, "intersection"), "What is taken out")
    look(left, SIDE, zoom=1.35)
    look(right, SIDE, zoom=0.85)
    save(HERE / "brain_resection.png", side_by_side([left, right]), (1240, 560))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
