# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares our distance filter with its peers in one run: part of `make bench`.

As compare.py: a process a contender, turns at every repetition, medians, elapsed and processor seconds of the whole
update with all the structures that it builds. Ours is signed and gives the nearest cells, too. WRONG marks a distance
that is off by more than single precision allows, or a wrong sign.

The exit code is 0 if all were right, 1 if ours was not, 2 if only a peer was not.
"""

import json
import shutil
import sys
from pathlib import Path
from statistics import median

import numpy as np

from compare import Worker, print_targets, print_versions, read_arguments, selected
from distance_cases import all_distance_cases

REPETITIONS = 3
NONCOMMERCIAL = ("meshlib",)
PRECISION = {"ours": 1e-13, "ours-1-thread": 1e-13, "libigl": 1e-12, "vtk": 1e-9, "packaged-vtk": 1e-9}
SINGLE = 1e-5  # of coordinates of size 1
RATIOS = tuple(
    (case, peer, 1.0)
    for case in ("distance near", "distance anywhere", "distance far")
    for peer in ("fcpw", "open3d", "libigl", "pymeshlab", "vtk", "meshlib")
) + (("distance near", "packaged-vtk", 1 / 30),)


def write_case(case, directory):
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    for name in ("points", "triangles", "queries", "sample", "expected"):
        np.save(directory / f"{name}.npy", getattr(case, name))


def measure(case, names, environment, directory):
    write_case(case, directory)
    workers = [Worker(name, environment, directory, "distance_worker.py") for name in names]
    for worker in workers:
        worker.facts.update(worker.ask("first"))
        worker.facts.update(worker.ask("check"))
    for _ in range(REPETITIONS):
        for worker in workers:
            worker.runs.append(worker.ask("run"))
    for worker in workers:
        worker.close()
    shutil.rmtree(directory)
    return {worker.name: summary(worker, case) for worker in workers}


def summary(worker, case):
    if worker.trouble:
        return {"trouble": worker.trouble}
    result = {**worker.facts, "runs": worker.runs}
    for clock in ("wall", "cpu"):
        result[clock] = median(run[clock] for run in worker.runs)
    scale = max(1.0, float(np.abs(case.expected).max()))
    result["wrong"] = bool(result["off"] > PRECISION.get(worker.name, SINGLE) * scale or result["signs"])
    return result


def table(case, results):
    yield f"\n{case.name}: {len(case.queries):,} points, {len(case.triangles):,} triangles"
    yield f"  {'contender':15}{'wall s':>9}{'cpu s':>9}{'MB':>8}{'ours/it wall':>14}{'cpu':>8}{'off':>10}{'signs':>8}"
    ours = results.get("ours", {"trouble": True})
    for name, result in results.items():
        if "trouble" in result:
            yield f"  {name:15}FAILED ({result['trouble']})"
            continue
        ratios = f"{'':22}"
        if name != "ours" and "trouble" not in ours:
            ratios = f"{ours['wall'] / result['wall']:14.3f}{ours['cpu'] / result['cpu']:8.3f}"
        signs = ("right" if result["signs"] == 0 else "WRONG") if result["signed"] else "none"
        yield (
            f"  {name:15}{result['wall']:9.3f}{result['cpu']:9.3f}{result['memory'] / 1e6:8.0f}{ratios}"
            f"{result['off']:10.1e}{signs:>8}{'  WRONG' * result['wrong']}"
        )


def verdicts(results):
    """(claim, limit, measured) for each target whose two sides were measured."""
    for case, peer, limit in RATIOS:
        sides = [results.get(case, {}).get(name, {}).get("wall") for name in ("ours", peer)]
        if all(sides):
            yield f"{case}: ours / {peer}", limit, sides[0] / sides[1]


def exit_code(results):
    bad = {name for case in results.values() for name, result in case.items() if result.get("wrong", True)}
    return 1 if any(name.startswith("ours") for name in bad) else 2 if bad else 0


def main():
    arguments = read_arguments(__doc__)

    def takes_part(name):
        if name.startswith("ours"):
            return not arguments.without_ours
        return arguments.peers == "all" or name not in NONCOMMERCIAL

    results = {}
    for case in selected(all_distance_cases(arguments.quick), arguments):
        names = [name for name in case.contenders if takes_part(name)]
        results[case.name] = measure(case, names, arguments.environment, arguments.output.parent / "bench-data")
        print("\n".join(table(case, results[case.name])), flush=True)
    output = arguments.output.with_name("bench-distances.json")
    output.write_text(json.dumps(results, indent=1) + "\n")
    print_targets([] if arguments.quick else list(verdicts(results)))
    print_versions(results.values())
    return exit_code(results)


if __name__ == "__main__":
    sys.exit(main())
