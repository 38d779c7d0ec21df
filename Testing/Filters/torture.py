# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""`make torture`: thousands of pairs of real meshes, and two judges that share no code with the filter.

The first judge asks at random places, and at places close to the surfaces, whether the result is inside exactly where
the winding numbers of the operands say. The second is manifold3d, which computes the volume anew where both operands
are clean. A pair is its number: `torture.py --first 123 --pairs 1` tries that one again.

The exit code is 0 if nothing was wrong, open, refused or crashed.
"""

import argparse
import functools
import json
import os
import subprocess
import sys
import time
from collections import Counter

import numpy as np

import measures
import meshes
from booleans import DIFFERENCE, INTERSECTION, RESOLVE, UNION, boolean

STEP = 1e-7  # how far from a surface the first judge asks; the meshes are of size 2
COUNT = 150
LARGEST = 12000  # triangles
CHUNK = 25  # pairs a process; a crash ends one of them
VOLUME = 1e-9  # how far volumes may differ, of the sum of the operands'
CAD_PARTS = ("anchor", "couplingdown", "cross", "cube", "fandisk", "handle", "joint", "pinion", "rotor", "spool")


@functools.lru_cache(maxsize=None)
def closed_names():
    """The closed meshes of libcgal-demo that are small enough to ask about many of them."""
    known = meshes.cgal_directory().parent / f"closed-meshes-{LARGEST}.json"
    if not known.exists():
        names = [path.stem for path in sorted(meshes.cgal_directory().glob("*.off")) if is_fit(path)]
        fresh = known.with_suffix(f".{os.getpid()}")
        fresh.write_text(json.dumps(names), encoding="utf-8")
        fresh.replace(known)  # at once: other processes may be looking
    return json.loads(known.read_text(encoding="utf-8"))


def is_fit(path):
    try:
        body = meshes.read_off(path)
    except (ValueError, IndexError):  # not every file of the package is a triangle mesh
        return False
    return 4 <= len(body.triangles) <= LARGEST and measures.is_closed(body) and measures.volume(body) > 0


@functools.lru_cache(maxsize=8)
def mesh_named(name):
    return meshes.cgal_mesh(name)


# ---- pairs -------------------------------------------------------------------------------------


def anyhow(rng):
    """Two meshes at any pose and of any size."""
    bodies = []
    for name in rng.choice(closed_names(), 2):
        body = meshes.scaled(mesh_named(name), rng.uniform(0.3, 1.5))
        bodies.append(meshes.moved(meshes.turned(body, meshes.random_rotation(rng)), rng.uniform(-0.3, 0.3, 3)))
    return bodies


def turned_copy(rng):
    """A mesh, and itself turned by next to nothing."""
    body = mesh_named(rng.choice(closed_names()))
    angle = 10.0 ** rng.uniform(-12, -3)
    return [body, meshes.turned(body, meshes.rotation(rng.normal(size=3), angle), rng.uniform(-0.5, 0.5, 3))]


def nearly_flush(rng):
    """Two machine parts side by side or in each other, their faces nearly or wholly in one plane."""
    fit = [name for name in CAD_PARTS if name in closed_names()]
    first, second = (mesh_named(name) for name in rng.choice(fit, 2))
    axis = int(rng.integers(3))
    quarter = meshes.rotation(np.eye(3)[rng.integers(3)], np.pi / 2 * rng.integers(4))
    second = meshes.turned(second, np.round(quarter))
    side = rng.choice(["beside", "level"])
    by = np.zeros(3)
    by[axis] = first.points[:, axis].max() - (
        second.points[:, axis].min() if side == "beside" else second.points[:, axis].max()
    )
    by += rng.choice([0.0, 1.0]) * 10.0 ** rng.uniform(-14, -6) * rng.normal(size=3)
    second = meshes.moved(second, by)
    if rng.random() < 0.5:
        second = meshes.turned(second, meshes.rotation(rng.normal(size=3), 10.0 ** rng.uniform(-12, -4)), by)
    return [first, second]


FAMILIES = (anyhow, turned_copy, nearly_flush)


def pair(number):
    """The bodies of this pair, and the name of its family."""
    rng = np.random.default_rng([11, number])
    family = FAMILIES[number % len(FAMILIES)]
    return family(rng), family.__name__


# ---- judges ------------------------------------------------------------------------------------


def verdicts(number):
    """What is wrong with the results of this pair: words, none if nothing is. And whether both judges were heard."""
    bodies, _ = pair(number)
    volumes = volumes_of_manifold(bodies)
    allowed = VOLUME * sum(measures.volume(body) for body in bodies)
    wrong = []
    for operation in (UNION, INTERSECTION, DIFFERENCE):
        result = boolean(bodies[:1], bodies[1:], operation)
        if result.errors or result.status != 0:
            wrong.append("refused")
        elif measures.open_edges(result.body) > 0:
            wrong.append("open")
        elif disagreements(operation, bodies, result.body, number) > 0:
            wrong.append("wrong inside")
        elif volumes is not None and abs(volumes[operation] - measures.volume(result.body)) > allowed:
            wrong.append("wrong volume")
    return wrong, volumes is not None


def disagreements(operation, bodies, result, number):
    rng = np.random.default_rng([12, number])
    points = measures.probes(rng, [*bodies, result], COUNT, STEP)
    expected = measures.expected_inside(operation, bodies[:1], bodies[1:], points)
    return int(np.count_nonzero(measures.inside(result, points) != expected))


def volumes_of_manifold(bodies):
    """By operation, what manifold3d says; None if it is not there, does not take these operands, or contradicts itself:
    what is in one or the other, and what is in both, add up to the operands; so do the difference and what is in both to
    the first one. (Between a box and the same box turned by 1e-5 it was seen to lose a tenth of the difference.)
    """
    try:
        import manifold3d
    except ImportError:
        return None
    first, second = (
        manifold3d.Manifold(
            manifold3d.Mesh64(vert_properties=body.points, tri_verts=body.triangles.astype(np.uint64), tolerance=0.0)
        )
        for body in bodies
    )
    if not all(solid.status() == manifold3d.Error.NoError for solid in (first, second)):
        return None
    if not all(is_clean(body) for body in bodies):
        return None
    combined = {UNION: first + second, INTERSECTION: first ^ second, DIFFERENCE: first - second}
    volumes = {operation: solid.volume() for operation, solid in combined.items()}
    first, both = measures.volume(bodies[0]), sum(measures.volume(body) for body in bodies)
    contradictions = (
        volumes[UNION] + volumes[INTERSECTION] - both,
        volumes[DIFFERENCE] + volumes[INTERSECTION] - first,
    )
    return None if max(map(abs, contradictions)) > VOLUME * both else volumes


def is_clean(body):
    """Whether it runs through itself nowhere: manifold3d wants that."""
    resolved = boolean([body], [], RESOLVE)
    return abs(resolved.volume - measures.volume(body)) <= 1e-12 * measures.volume(body)


# ---- running -----------------------------------------------------------------------------------


def try_pairs(first, count):
    """One line of JSON a pair, for the process that started this one."""
    for number in range(first, first + count):
        print(json.dumps([number, pair(number)[1], *verdicts(number)]), flush=True)


def run_chunk(first, count):
    """The lines of a chunk that a process of its own tries, and what it died of."""
    command = [sys.executable, __file__, "--worker", "--first", str(first), "--pairs", str(count)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    lines = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("[")]
    if done.returncode != 0:
        number = first + len(lines)
        print(done.stderr[-2000:], file=sys.stderr)
        lines.append([number, pair(number)[1], ["crashed"], False])
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pairs", type=int, default=3000)
    parser.add_argument("--first", type=int, default=0, help="the number of the first pair")
    parser.add_argument("--seconds", type=float, default=3600.0, help="start no more pairs after this time")
    parser.add_argument("--worker", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.worker:
        try_pairs(arguments.first, arguments.pairs)
        return 0
    return report(arguments)


def report(arguments):
    tried, wrong, judged, start = Counter(), Counter(), 0, time.monotonic()
    number, end = arguments.first, arguments.first + arguments.pairs
    while number < end and time.monotonic() - start < arguments.seconds:
        lines = run_chunk(number, min(CHUNK, end - number))
        for at, family, words, by_both in lines:
            tried[family] += 1
            judged += by_both
            wrong.update(words)
            if words:
                print(f"pair {at} ({family}): {', '.join(words)}", flush=True)
        number = lines[-1][0] + 1
    print(f"{sum(tried.values())} pairs in {time.monotonic() - start:.0f} s:", dict(tried))
    print(f"{judged} of them were judged by manifold3d, too")
    print("found:", dict(wrong) or "nothing wrong, open, refused or crashed")
    return 1 if wrong or not tried else 0


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    sys.exit(main())
