# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the paper's Figure 5 anew: five pairs of solids, three operations, blue and red by origin.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/quammen_2011_figure_5.py

The solids are those that Testing/Filters/test_figure5.py measures, with facets three times as fine.
"""

import pathlib
import sys

import numpy as np
from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "Testing" / "Filters")]

from booleans import polydata  # noqa: E402
from meshes import figure_5_pairs  # noqa: E402
from offscreen import crease_actor, look_parallel, result_actor, save, text, white_room  # noqa: E402

OPERATIONS = ("Union", "Intersection", "Difference")
BLUE, RED = (0.25, 0.48, 0.88), (0.90, 0.28, 0.23)
CREASE = 25  # degrees
CELL, MARGIN = 360, 44  # pixels: one picture, the strip of labels


def result_of(first, second, operation):
    boolean = vtkPolyDataBooleanOperationFilter()
    boolean.SetInputDataObject(0, polydata(first))
    boolean.SetInputDataObject(1, polydata(second))
    getattr(boolean, "SetOperationTo" + operation)()
    return boolean


def picture(pair, operation, viewport):
    source = result_of(*pair, operation)
    actors = (result_actor(source, (BLUE, RED), CREASE), crease_actor(source, CREASE))
    room = white_room(actors, key_light=0.88, contrast=1.5)
    room.SetViewport(*viewport)
    aim(room, pair)
    return room


def aim(room, pair):
    """The same eye for the three results of a pair, at its union's centre."""
    points = np.concatenate([body.points for body in pair])
    lower, upper = points.min(axis=0), points.max(axis=0)
    center = (lower + upper) / 2
    radius = np.linalg.norm(upper - lower) / 2
    look_parallel(room, center + [2.6, -2.1, 1.9], center, up=(0, 0, 1), scale=1.02 * radius)


def label(words, x, y, turned=False):
    actor = text(words, x, y, size=22)
    style = actor.GetTextProperty()
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToCentered()
    style.SetOrientation(90 if turned else 0)
    return actor


def main(path):
    pairs = figure_5_pairs(fine=3)
    width, height = MARGIN + CELL * len(pairs), MARGIN + CELL * len(OPERATIONS)
    labels, pictures = [], []
    for row, operation in enumerate(OPERATIONS):
        bottom = CELL * (len(OPERATIONS) - 1 - row)
        labels.append(label(operation.lower(), MARGIN / 2, bottom + CELL / 2, turned=True))
        for column, pair in enumerate(pairs.values()):
            left = MARGIN + CELL * column
            box = (left / width, bottom / height, (left + CELL) / width, (bottom + CELL) / height)
            pictures.append(picture(pair, operation, box))
    for column, name in enumerate(pairs):
        labels.append(label(name.replace("-", " and "), MARGIN + CELL * (column + 0.5), height - MARGIN / 2))
    save(path, [white_room(labels), *pictures], (width, height))


if __name__ == "__main__":
    main(HERE / "quammen-2011-figure-5.png")
