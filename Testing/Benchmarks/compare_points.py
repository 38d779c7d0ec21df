# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares our filters for clouds of points with the way there by other libraries: part of `make bench`.

As compare.py: a process a contender, the whole update with all the structures that it builds. Ours run on one thread,
and processor seconds of all threads are what is compared; ours-threads has all cores, as the peer always has, and there
elapsed seconds are compared. Every update runs once, since the peer needs minutes.

Projections: ours are all points of the cloud, with everything that prepares them; of MeshLab's APSS, which would need
minutes for them, 50,000 points without what prepares the cloud. Surfaces: ours has its points projected as well; the
peer is screened Poisson reconstruction of depth 8, and manifold3d for the Boolean.

The exit code is 0 if all surfaces were closed and of the right volume, 1 if ours was not, 2 if only a peer's was not.
"""

import json
import shutil
import sys

import numpy as np

from cloud_cases import TUBE, all_cloud_cases, volume_left
from compare import Worker, print_targets, print_versions, read_arguments, selected

VOLUME_TOLERANCE = 0.01
# task, who of ours, figure, the greatest ratio of it to pymeshlab's
TARGETS = (
    ("project", "ours", "cpu a query", 0.05),
    ("project", "ours", "rms", 1.0),
    ("mesh", "ours", "cpu", 0.2),
    ("mesh", "ours-threads", "wall", 0.2),
    ("mesh", "ours", "rms", 1.0),
    ("boolean", "ours", "cpu", 0.2),
    ("boolean", "ours-threads", "wall", 0.2),
    ("boolean", "ours", "rms", 1.0),
)


def write_case(case, directory):
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    (directory / "task").write_text(case.task)
    for name in ("points", "normals"):
        np.save(directory / f"{name}.npy", getattr(case, name))
    for name, array in zip(("tool_points", "tool_triangles"), case.tool):
        np.save(directory / f"{name}.npy", array)


def measure(case, names, environment, directory):
    write_case(case, directory)
    results = {}
    for name in names:
        worker = Worker(name, environment, directory, "cloud_worker.py")
        worker.facts.update(worker.ask("first"))
        worker.facts.update(worker.ask("check"))
        if case.task == "project" and not worker.facts.get("all"):
            worker.facts["setup"] = worker.ask("setup")
        worker.close()
        results[name] = summary(worker, case)
    shutil.rmtree(directory)
    return results


def summary(worker, case):
    if worker.trouble:
        return {"trouble": worker.trouble}
    result = dict(worker.facts)
    for figure in ("rms", "mean"):
        result[figure] /= case.spacing
    if case.task == "project":
        setup = result.get("setup")
        moved = result["queries"] - (1000 if setup else 0)
        result["cpu a query"] = (result["cpu"] - (setup["cpu"] if setup else 0.0)) / moved
    if "volume" in result:
        whole = volume_left() if case.task == "boolean" else 2 * np.pi**2 * TUBE**2
        result["volume off"] = result["volume"] / whole - 1
    result["wrong"] = bool(result.get("open") or abs(result.get("volume off", 0.0)) > VOLUME_TOLERANCE)
    return result


def table(case, results):
    yield f"\n{case.name}"
    yield f"  {'contender':13}{'wall s':>9}{'cpu s':>9}{'MB':>8}{'ours/it cpu':>13}{'rms':>9}{'mean':>9}  of a spacing"
    ours = results.get("ours", {"trouble": True})
    for name, result in results.items():
        if "trouble" in result:
            yield f"  {name:13}FAILED ({result['trouble']})"
            continue
        key = "cpu a query" if case.task == "project" else "cpu"
        ratio = f"{'':13}"
        if not name.startswith("ours") and "trouble" not in ours:
            ratio = f"{ours[key] / result[key]:13.3f}"
        notes = ""
        if "cpu a query" in result:
            notes += f"  {1 / result['cpu a query']:,.0f} projections a cpu second"
        if "angle" in result:
            notes += f"  normals off by {result['angle']:.2f} degrees"
        if "triangles" in result:
            notes += f"  {result['triangles']:,} triangles, volume off {result['volume off']:.1e}"
            notes += f"  OPEN ({result['open']} edges)" * bool(result["open"])
        yield (
            f"  {name:13}{result['wall']:9.2f}{result['cpu']:9.2f}{result['memory'] / 1e6:8.0f}{ratio}"
            f"{result['rms']:9.4f}{result['mean']:9.4f}{notes}{'  WRONG' * result['wrong']}"
        )


def verdicts(cases):
    """(claim, limit, measured) for each target whose two sides were measured."""
    for task, who, figure, limit in TARGETS:
        for case, results in cases:
            sides = [results.get(name, {}).get(figure) for name in (who, "pymeshlab")]
            if case.task == task and all(sides):
                yield f"{case.name}: {figure} of {who} / pymeshlab", limit, sides[0] / sides[1]


def main():
    arguments = read_arguments(__doc__)
    cases = []
    for case in selected(all_cloud_cases(arguments.quick), arguments):
        names = [name for name in case.contenders if not (arguments.without_ours and name.startswith("ours"))]
        results = measure(case, names, arguments.environment, arguments.output.parent / "bench-data")
        cases.append((case, results))
        print("\n".join(table(case, results)), flush=True)
    output = arguments.output.with_name("bench-points.json")
    output.write_text(json.dumps({case.name: results for case, results in cases}, indent=1) + "\n")
    print_targets([] if arguments.quick else list(verdicts(cases)))
    print_versions(results for _, results in cases)
    bad = {name for _, results in cases for name, result in results.items() if result.get("wrong", True)}
    return 1 if any(name.startswith("ours") for name in bad) else 2 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
