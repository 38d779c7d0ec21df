# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""One contender in measuring distances, in a process of its own: `distance_worker.py CONTENDER CASE_DIRECTORY`.

As worker.py, with the words `first` (an update whose memory is measured; the warm-up), `run` (a timed update) and
`check` (how far the first update's distances are off at the checked points, and how many signs are wrong).
"""

import json
import os
import sys
from pathlib import Path

import numpy as np

from distance_contenders import CONTENDERS
from worker import peak_memory_since, timed


def main():
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what a library prints must not get among the answers

    contender = CONTENDERS[sys.argv[1]]()
    directory = Path(sys.argv[2])
    arrays = {name: np.load(directory / f"{name}.npy") for name in ("points", "triangles", "queries")}
    sample, expected = (np.load(directory / f"{name}.npy") for name in ("sample", "expected"))
    contender.prepare(arrays["points"], arrays["triangles"], arrays["queries"][:1000])
    contender.update()  # loads libraries and starts threads, which are not the case's memory
    contender.prepare(*arrays.values())

    for line in sys.stdin:
        word = line.strip()
        if word == "first":
            result, peak = peak_memory_since(contender.update)
            distances = contender.distances(result[0]) if hasattr(contender, "distances") else result[0]
            found = np.array(distances, dtype=float).ravel()[sample]
            answer = {"version": contender.version, "memory": peak, "signed": contender.signed}
        elif word == "run":
            result, answer = timed(contender.update)
        elif word == "check":
            off = float(np.abs(np.abs(found) - np.abs(expected)).max())
            signs = int(np.count_nonzero(np.sign(found) != np.sign(expected))) if contender.signed else 0
            answer = {"off": off, "signs": signs}
        else:
            raise SystemExit(f"unknown word {word!r}")
        result = None  # destroyed here, outside every clock
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    main()
