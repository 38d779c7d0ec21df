# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a rod from a STEP file (Open CASCADE's, Debian: occt-misc), drilled to be lighter.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/cad_drilling.py

Seven drills are taken out of the rod by one Boolean; red is what they left.
"""

import pathlib

import surfacebooleans as sb
from offscreen import look, result_actor, save, side_by_side, text, white_room
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCylinderSource

HERE = pathlib.Path(__file__).resolve().parent
ROD = "/usr/share/opencascade/data/step/linkrods.step"
STEEL, CUT = (0.62, 0.70, 0.80), (0.80, 0.18, 0.14)


def drill(center, radius):
    """A cylinder along y."""
    source = vtkCylinderSource()
    source.SetRadius(radius)
    source.SetHeight(3)
    source.SetResolution(128)
    placed = vtkTransform()
    placed.Translate(center)
    moved = vtkTransformPolyDataFilter()
    moved.SetInputConnection(source.GetOutputPort())
    moved.SetTransform(placed)
    moved.Update()
    return moved.GetOutput()


def tools():
    """Five holes through the web, each smaller than the one before; an oil hole and a bore across through the eyes."""
    web = [drill((4.78 + 0.47 * i, 3.3, 1.0), 0.19 - 0.02 * i) for i in range(5)]
    return [*web, drill((3.94, 3.3, 1.72), 0.09), drill((7.7, 3.3, 1.72), 0.09)]


def room(surface, words):
    volume = surface.GetFieldData().GetArray("ResultVolume").GetValue(0)
    result = white_room((result_actor(surface, (STEEL, CUT), crease=30, specular=0.25), text(f"{words}: volume {volume:.4f}", 16, 14)), contrast=2)
    look(result, (0.5, -1.6, 0.9), zoom=1.12)
    return result


def main():
    rod, drills = sb.read_nurbs(ROD), tools()
    whole = sb.boolean(rod, operation="resolve")
    drilled = sb.boolean(rod, drills, "difference")
    rooms = [room(whole, "The rod"), room(drilled, f"Without {len(drills)} drills")]
    save(HERE / "cad_drilling.png", side_by_side(rooms), (1240, 560))


if __name__ == "__main__":
    main()
