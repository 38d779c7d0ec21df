# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares our Boolean, intersection, clip and check filters with their peers in one run: `make bench`, or `make bench PEERS=all`.

Every contender goes from raw numpy arrays to raw arrays (the whole update, with all the structures it builds) in a
process of its own. Contenders take turns at every repetition, so that a machine that slows down slows all of them. Told
are medians of five: elapsed seconds and processor seconds of all threads; and by how much the first update made the
process grow at the worst moment. A ratio is ours divided by the peer's: below one, ours is the faster.

Each result's volume is compared with the expected one of `cases.py`, and its edges are counted that are not used as
often one way as the other; WRONG marks a volume that is off, OPEN a surface with such edges.

The exit code is 0 if all contenders gave closed surfaces of the right volumes, 1 if ours did not, 2 if only a peer did
not. Targets that are missed are told and change no exit code: a busy machine is no defect.
"""

import argparse
import json
import os
import platform
import select
import shutil
import subprocess
import sys
from pathlib import Path
from statistics import median

import numpy as np

from cases import CURVES, all_cases

HERE = Path(__file__).resolve().parent
PERMISSIVE = ("ours", "manifold3d", "trimesh", "vtk", "vtk-packaged", "pymeshlab")
REPETITIONS = 5
PATIENCE = 600  # seconds for one update, after which a contender is out

# What we hold ourselves to: case, peer and the greatest ratio of elapsed seconds.
SPHERES = ("spheres union", "spheres intersection", "spheres difference")
CLIPS = tuple(f"clip {size}, {planes}" for size in ("500k", "2M") for planes in ("1 plane", "3 planes"))
TIME_TARGETS = (
    *((case, "manifold3d", 0.35) for case in SPHERES),
    *((case, peer, 1.0) for case in SPHERES for peer in ("trueform", "trueform-float")),
    *(("bumpy union", peer, 1.0) for peer in ("manifold3d", "trueform", "trueform-float", "meshlib")),
    *(("small tool", peer, 0.3) for peer in ("trueform", "trueform-float")),
    ("small tool", "manifold3d", 0.1),
    ("plate - 1000", "manifold3d", 1.0),
    *(("bumpy curves", peer, 1.0) for peer in ("trueform", "trueform-float")),
    *((case, "vtk", 0.05) for case in CURVES),
    *((case, peer, 0.5) for case in CLIPS for peer in ("vtk", "manifold3d", "trimesh", "meshlib", "trueform")),
    *((case, "vtk-packaged", 0.2) for case in CLIPS),
    *(("bumpy check", peer, 1.0) for peer in ("pymeshlab", "meshlib")),
)
MEMORY_TARGETS = tuple((case, "trueform", 1.0) for case in (*SPHERES, "bumpy union", "small tool", "plate - 1000"))
MOVED_TARGETS = tuple((case, 0.5) for case in (*SPHERES, "bumpy union", "small tool"))
DOUBLINGS = (("plate - 250", "plate - 500"), ("plate - 500", "plate - 1000"), ("union of 25", "union of 50"))
DOUBLING_LIMIT = 2.3
CHECK_LIMIT = 1.0  # of a Boolean of the same triangles


class Worker:
    """One contender at one case: its process, its measurements, or why it is out."""

    def __init__(self, name, environment, directory, script="worker.py"):
        command = [sys.executable]
        # Debian's Python sees ParaView's VTK, which must not meet the peer's VTK.
        if name.startswith("ours") or "packaged" in name:
            command = ["sh", "-c", '. "$0" && exec /usr/bin/python3 "$@"', str(environment.resolve())]
        self.name, self.log = name, directory / f"{name}.log"
        self.facts, self.runs, self.moved, self.trouble = {}, [], [], None
        with open(self.log, "w") as log:
            self.process = subprocess.Popen(
                [*command, str(HERE / script), name, str(directory)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
            )

    def ask(self, word):
        """The worker's answer to a word; empty if it is out."""
        if self.trouble:
            return {}
        try:
            self.process.stdin.write(word + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass  # it has died, which the missing answer tells
        if not select.select([self.process.stdout], [], [], PATIENCE)[0]:
            self.process.kill()
            self.trouble = f"took longer than {PATIENCE} s"
            return {}
        line = self.process.stdout.readline()
        if not line:
            words = [text.strip() for text in self.log.read_text().splitlines() if text.strip()]
            self.trouble = f"exit {self.process.wait()}" + (f": {words[-1]}" if words else "")
            return {}
        return json.loads(line)

    def close(self):
        self.process.communicate()


def write_case(case, directory):
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    sides = {"input": case.input, "tool": case.tool}
    for side, meshes in sides.items():
        for k, (points, triangles) in enumerate(meshes):
            np.save(directory / f"{side}{k}-points.npy", points)
            np.save(directory / f"{side}{k}-triangles.npy", triangles)
    facts = {"operation": case.operation, "planes": case.planes, **{side: len(meshes) for side, meshes in sides.items()}}
    (directory / "case.json").write_text(json.dumps(facts))


def measure(case, names, environment, directory):
    """All contenders at one case, taking turns."""
    write_case(case, directory)
    workers = [Worker(name, environment, directory) for name in names]
    for worker in workers:
        worker.facts.update(worker.ask("first"))
        worker.facts.update(worker.ask("check"))
    for _ in range(REPETITIONS):
        for worker in workers:
            worker.runs.append(worker.ask("run"))
            if worker.name == "ours" and case.tool:
                worker.moved.append(worker.ask("moved"))
    for worker in workers:
        worker.close()
    shutil.rmtree(directory)
    return {worker.name: summary(worker, case) for worker in workers}


def summary(worker, case):
    if worker.trouble:
        return {"trouble": worker.trouble}
    result = {**worker.facts, "runs": worker.runs, "moved": worker.moved}
    for clock in ("wall", "cpu"):
        result[clock] = median(run[clock] for run in worker.runs)
        if worker.moved:
            result[f"moved {clock}"] = median(run[clock] for run in worker.moved)
    result["off"] = (result["volume"] - case.volume) / case.volume
    result["wrong"] = bool(abs(result["volume"] - case.volume) > case.tolerance)
    return result


def case_table(case, results):
    """What a reader sees of one case."""
    yield f"\n{case.name}: {case.operation} of {case.triangles:,} triangles"
    yield (
        f"  {'contender':15}{'wall s':>9}{'cpu s':>9}{'MB':>8}{'ours/it wall':>14}{'cpu':>8}"
        f"{'triangles':>11}{'volume off':>12}"
    )
    ours = results.get("ours", {"trouble": True})
    for name, result in results.items():
        if "trouble" in result:
            yield f"  {name:15}FAILED ({result['trouble']})"
            continue
        ratios = f"{'':22}"
        if name != "ours" and "trouble" not in ours:
            ratios = f"{ours['wall'] / result['wall']:14.3f}{ours['cpu'] / result['cpu']:8.3f}"
        marks = "  WRONG" * result["wrong"] + f"  OPEN ({result['open']} edges)" * bool(result["open"])
        yield (
            f"  {name:15}{result['wall']:9.3f}{result['cpu']:9.3f}{result['memory'] / 1e6:8.0f}{ratios}"
            f"{result['triangles']:11,}{result['off']:12.1e}{marks}"
        )
        if "moved wall" in result:
            yield f"  {'  tool moved':15}{result['moved wall']:9.3f}{result['moved cpu']:9.3f}"


def verdicts(results):
    """(claim, limit, measured) for each target whose two sides were measured."""

    def figure(case, name, what):
        return results.get(case, {}).get(name, {}).get(what)

    def ratio(claim, limit, ours, other):
        if ours is not None and other:
            yield claim, limit, ours / other

    for case, peer, limit in TIME_TARGETS:
        yield from ratio(f"{case}: ours / {peer}", limit, figure(case, "ours", "wall"), figure(case, peer, "wall"))
    for case, peer, limit in MEMORY_TARGETS:
        ours, other = figure(case, "ours", "memory"), figure(case, peer, "memory")
        yield from ratio(f"{case}: memory of ours / {peer}", limit, ours, other)
    for case, limit in MOVED_TARGETS:
        moved, first = figure(case, "ours", "moved wall"), figure(case, "ours", "wall")
        yield from ratio(f"{case}: tool moved / first update", limit, moved, first)
    check, union = (figure(case, "ours", "wall") for case in ("bumpy check", "bumpy union"))
    yield from ratio("bumpy check / bumpy union, ours", CHECK_LIMIT, check, union)
    for half, whole in DOUBLINGS:
        one, two = figure(half, "ours", "wall"), figure(whole, "ours", "wall")
        yield from ratio(f"{half} -> {whole}: growth of ours", DOUBLING_LIMIT, two, one)


def exit_code(results):
    def failed(result):
        return "trouble" in result or result["wrong"] or result["open"] > 0

    bad = {name for case in results.values() for name, result in case.items() if failed(result)}
    return 1 if "ours" in bad else 2 if bad else 0


def read_arguments(description):
    """What run.sh passes on to every comparison."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="small inputs, to try the harness")
    parser.add_argument("--peers", choices=("permissive", "all"), default="permissive", help="who takes part")
    parser.add_argument("--only", nargs="+", metavar="TEXT", help="cases whose name contains one of these texts")
    parser.add_argument("--without-ours", action="store_true", help="peers alone; needs no build of ours")
    parser.add_argument("--environment", type=Path, default=Path("build/env.sh"), help="made by `make build`")
    parser.add_argument("--output", type=Path, default=Path("build/bench.json"), help="all measurements")
    return parser.parse_args()


def selected(cases, arguments):
    """Those that `--only` names."""
    return [case for case in cases if not arguments.only or any(text in case.name for text in arguments.only)]


def print_targets(claims):
    """What `verdicts` yields, and whether it is met."""
    if claims:
        print(f"\n{'target':58}{'at most':>9}{'measured':>10}")
    for claim, limit, measured in claims:
        print(f"{claim:58}{limit:9.3f}{measured:10.3f}  {'met' if measured <= limit else 'MISSED'}")


def print_versions(cases):
    """Of all contenders; `cases` are dictionaries of results by contender."""
    versions = {name: result.get("version") for case in cases for name, result in case.items()}
    print("\n" + "; ".join(f"{name} {version}" for name, version in versions.items() if version))


def main():
    arguments = read_arguments(__doc__)

    def takes_part(name):
        if name == "ours":
            return not arguments.without_ours
        return arguments.peers == "all" or name in PERMISSIVE

    results = {}
    for case in selected(all_cases(arguments.quick), arguments):
        names = [name for name in case.contenders if takes_part(name)]
        directory = arguments.output.parent / "bench-data"
        results[case.name] = measure(case, names, arguments.environment, directory)
        print("\n".join(case_table(case, results[case.name])), flush=True)

    machine = {"processor": platform.machine(), "cores": os.cpu_count(), "load": os.getloadavg()}
    arguments.output.write_text(json.dumps({"machine": machine, "cases": results}, indent=1) + "\n")
    print_targets([] if arguments.quick else list(verdicts(results)))
    print_versions(results.values())
    print(f"{machine['cores']} cores, load {machine['load'][0]:.1f}; all measurements: {arguments.output}")
    return exit_code(results)


if __name__ == "__main__":
    sys.exit(main())
