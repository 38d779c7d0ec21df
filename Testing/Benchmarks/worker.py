# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""One contender in a process of its own, so that each has its own VTK, allocator, threads and memory.

Started as `worker.py CONTENDER CASE_DIRECTORY`. It obeys one word a line on standard input and answers with one line of
JSON: `first` (an update whose memory is measured; the warm-up), `run` (a timed update), `moved` (a timed update of
what `run` left after the tool alone was moved), `check` (`figures` of the first update's result).
"""

import gc
import json
import os
import resource
import sys
import time
from pathlib import Path

import numpy as np

from cases import box, mesh_volume
from clippers import CLIPPERS
from contenders import CHECKERS, CONTENDERS


def peak_memory_since(action):
    """Result of the action, and by how many bytes the process outgrew its size before it at the worst moment."""
    try:
        Path("/proc/self/clear_refs").write_text("5")  # lets VmHWM start anew
    except OSError:
        pass  # the peak since the start of the process is then the best there is
    before = memory("VmRSS")
    result = action()
    return result, memory("VmHWM") - before


def memory(field):
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(field):
            return int(line.split()[1]) * 1024
    raise RuntimeError(f"no {field} in /proc/self/status")


def timed(action):
    gc.collect()
    gc.disable()
    wall, cpu = time.perf_counter(), processor_seconds()
    result = action()
    times = {"wall": time.perf_counter() - wall, "cpu": processor_seconds() - cpu}
    gc.enable()
    return result, times


def processor_seconds():
    """Of all threads, in user and in system mode."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def open_edges(points, triangles):
    """Edges not used as often one way as the other, after coincident points were joined: 0 for a closed surface."""
    raw = np.ascontiguousarray(points + 0.0, dtype=np.float64).view("V24").ravel()
    _, welded = np.unique(raw, return_inverse=True)
    triangles = welded.reshape(-1)[triangles.astype(np.int64)]
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    edge = np.minimum(start, end) * np.int64(len(points)) + np.maximum(start, end)
    edges, index = np.unique(edge, return_inverse=True)
    balance = np.bincount(index.reshape(-1), weights=np.sign(end - start), minlength=len(edges))
    return int(np.count_nonzero(balance))


def segments(polylines):
    """Pairs of point ids; of polygons given as arrays of corners, nothing is changed."""
    if not isinstance(polylines, tuple):
        return np.array(polylines)
    offsets, ids = (np.asarray(part, dtype=np.int64) for part in polylines)
    inner = np.ones(len(ids), dtype=bool)
    inner[offsets[1:] - 1] = False
    first = np.flatnonzero(inner)
    return np.stack([ids[first], ids[first + 1]], axis=1)


def figures(points, cells):
    """The volume and the open edges of a surface; of curves, the length and the places where they end."""
    if cells.shape[1] == 3:
        return {"volume": mesh_volume((points, cells)) if len(cells) else 0.0, "open": open_edges(points, cells)}
    length = np.linalg.norm(np.diff(points[cells].astype(np.float64), axis=1), axis=-1).sum()
    raw = np.ascontiguousarray(points[cells.ravel()] + 0.0, dtype=np.float64).view("V24").ravel()
    return {"volume": float(length), "open": int(np.count_nonzero(np.unique(raw, return_counts=True)[1] % 2))}


def load(directory):
    case = json.loads((directory / "case.json").read_text())
    sides = []
    for side in ("input", "tool"):
        meshes = []
        for k in range(case[side]):
            meshes.append(tuple(np.load(directory / f"{side}{k}-{part}.npy") for part in ("points", "triangles")))
        sides.append(meshes)
    return case["operation"], *sides, case["planes"]


def main():
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what a library prints must not get among the answers

    case = load(Path(sys.argv[2]))
    if case[0] == "clip":
        contender = CLIPPERS[sys.argv[1]]()
        contender.prepare("clip", [box((0, 0, 0), (1, 1, 1))], [], [((0.5, 0.5, 0.5), (1, 2, 3))])
    elif case[0] == "check":
        contender = CHECKERS[sys.argv[1]]()
        contender.prepare("check", [box((0, 0, 0), (1, 1, 1))], [])
    else:
        contender = CONTENDERS[sys.argv[1]]()
        contender.prepare("union", [box((0, 0, 0), (1, 1, 1))], [box((0.5, 0.4, 0.3), (2, 2, 2))])
    contender.update()  # loads libraries and starts threads, which are not the case's memory
    contender.prepare(*case)

    moves = 0
    result = None
    for line in sys.stdin:
        word = line.strip()
        if word != "moved":
            result = None  # destroyed here, outside every clock
        if word == "first":
            result, peak = peak_memory_since(contender.update)
            checked = np.array(result[0]), segments(result[1])
            answer = {"version": contender.version, "memory": peak, "triangles": len(checked[1])}
        elif word == "run":
            result, answer = timed(contender.update)
        elif word == "moved":
            moves += 1
            keep = result[2]
            contender.move_tool(keep, 1e-3 * moves)
            result, answer = timed(lambda: contender.update_again(keep))
        elif word == "check":
            answer = figures(*checked)
        else:
            raise SystemExit(f"unknown word {word!r}")
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    main()
