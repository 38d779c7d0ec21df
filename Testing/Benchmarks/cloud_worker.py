# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""One contender in working on a cloud, in a process of its own: `cloud_worker.py CONTENDER CASE_DIRECTORY`.

As worker.py, with the words `first` (a timed update whose memory is measured), `setup` (a timed update that projects
next to nothing) and `check` (how far the first update's points are off).
"""

import json
import os
import sys
from pathlib import Path

import numpy as np

from cases import mesh_volume
from cloud_cases import from_surface
from cloud_contenders import CONTENDERS
from worker import open_edges, peak_memory_since, timed


def places_on(points, triangles):
    """Of a mesh: the middles of thirds of each triangle, beside each corner, and what area each stands for."""
    corners = points[triangles]
    middle = corners.mean(axis=1, keepdims=True)
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return ((corners + middle) / 2).reshape(-1, 3), np.repeat(area, 3)


def figures(task, result, case):
    """Of points, their distances from the truth; of a mesh, those of its whole surface."""
    points, rest, _ = result
    places, weights = points.astype(np.float64), np.ones(len(points))
    if task in ("mesh", "boolean"):
        places, weights = places_on(places, np.asarray(rest, dtype=np.int64))
    off = from_surface(task, places)
    mean, square = (float(np.average(values, weights=weights)) for values in (off, off**2))
    answer = {"mean": mean, "rms": square**0.5, "queries": len(points)}
    if task == "estimate":
        cosine = np.abs(np.einsum("ij,ij->i", rest, case["normals"]))
        answer["angle"] = float(np.degrees(np.sqrt(np.mean(np.arccos(np.clip(cosine, 0, 1)) ** 2))))
    if task in ("mesh", "boolean"):
        cells = np.asarray(rest, dtype=np.int64)
        answer.update(triangles=len(cells), open=open_edges(points, cells), volume=float(mesh_volume((points, cells))))
    return answer


def main():
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what a library prints must not get among the answers

    contender = CONTENDERS[sys.argv[1]]()
    directory = Path(sys.argv[2])
    task = (directory / "task").read_text()
    names = ("points", "normals", "tool_points", "tool_triangles")
    case = {name: np.load(directory / f"{name}.npy") for name in names}
    contender.prepare({**case, "points": case["points"][:20_000], "normals": case["normals"][:20_000]})
    queries, contender.queries = contender.queries, 1000
    getattr(contender, task)()  # loads libraries and starts threads, which are not the case's memory
    contender.prepare(case)

    for line in sys.stdin:
        word = line.strip()
        if word == "setup":
            contender.queries = 1000
            _, answer = timed(getattr(contender, task))
        elif word == "first":
            contender.queries = queries
            (result, times), peak = peak_memory_since(lambda: timed(getattr(contender, task)))
            answer = {"version": contender.version, "memory": peak, "all": queries is None, **times}
        elif word == "check":
            answer = figures(task, result, case)
            result = None
        else:
            raise SystemExit(f"unknown word {word!r}")
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    main()
