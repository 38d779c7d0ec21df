# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Twenty pairs of real meshes from libcgal-demo at random poses, some of them in a sorry state.

The result must be what the winding numbers of the operands say, at points all over space and at
points close to either side of every surface, where a missing piece shows.
"""

import functools

import numpy as np
import pytest

import measures
import meshes
from booleans import (
    DIFFERENCE,
    INTERSECTION,
    RESOLVE,
    SYMMETRIC_DIFFERENCE,
    UNION,
    boolean,
)

pytestmark = pytest.mark.skipif(
    not meshes.CGAL_DATA.exists(), reason="the package libcgal-demo is not installed"
)

PAIRS = [  # closed meshes; bones, man overlap themselves, diplodocus is not manifold
    ("elephant", "cow"),
    ("camel", "dino"),
    ("bones", "hand"),
    ("bones", "man"),
    ("man", "elk"),
    ("diplodocus", "triceratops"),
    ("diplodocus", "bones"),
    ("armadillo", "fandisk"),
    ("knot1", "knot2"),
    ("rotor", "anchor"),
    ("spool", "pinion"),
    ("couplingdown", "joint"),
    ("fandisk", "anchor_dense"),
    ("bull", "cactus"),
    ("helmet", "homer"),
    ("turbine", "pipe"),
    ("femur", "retinal"),
    ("bear", "eight"),
    ("cheese", "handle"),
    ("elk", "elk"),
]
NAMES = [f"{first} and {second}" for first, second in PAIRS]
STEP = 1e-6  # how far from a surface points are asked about; the meshes are of size 2
COUNT = 1000


@functools.lru_cache(maxsize=None)
def posed(number):
    rng = np.random.default_rng([6, number])
    bodies = [meshes.cgal_mesh(name) for name in PAIRS[number]]
    pose = meshes.random_rotation(rng)
    return bodies[0], meshes.moved(meshes.turned(bodies[1], pose), rng.uniform(-0.15, 0.15, 3))


def disagreements(operation, inputs, tools, result):
    """Of the points asked about, those where the result is not what the definition says."""
    rng = np.random.default_rng(7)
    points = measures.probes(rng, [*inputs, *tools, result], COUNT, STEP)
    expected = measures.expected_inside(operation, inputs, tools, points)
    return points[measures.inside(result, points) != expected]


@pytest.mark.parametrize("number", range(len(PAIRS)), ids=NAMES)
def test_the_meshes_are_closed(number):
    assert all(measures.is_closed(body) for body in posed(number))


def test_some_of_the_meshes_overlap_themselves_and_one_is_not_manifold():
    rng = np.random.default_rng(8)
    for name in ("bones", "man"):
        body = meshes.cgal_mesh(name)
        assert measures.winding(body, measures.probes(rng, [body], 2000, 1e-4)).max() > 1
    assert measures.non_manifold_edges(meshes.cgal_mesh("diplodocus")) > 0


@pytest.mark.parametrize("number", range(len(PAIRS)), ids=NAMES)
def test_the_result_is_what_the_winding_numbers_say(number):
    first, second = posed(number)
    volume = {}
    for operation in (UNION, INTERSECTION, DIFFERENCE, SYMMETRIC_DIFFERENCE):
        result = boolean([first], [second], operation)
        assert result.status == 0 and not result.errors, result.message
        assert measures.open_edges(result.body) == 0
        assert len(disagreements(operation, [first], [second], result.body)) == 0
        if operation != SYMMETRIC_DIFFERENCE:
            volume[operation] = resolved_volume(result.body)
    assert volume[INTERSECTION] > 0, "a pair that does not meet tests nothing"
    resolved = [resolved_volume(body) for body in (first, second)]
    allowed = 1e-12 * sum(resolved)
    assert abs(volume[UNION] + volume[INTERSECTION] - sum(resolved)) <= allowed
    assert abs(volume[DIFFERENCE] - resolved[0] + volume[INTERSECTION]) <= allowed


def resolved_volume(body):
    """The volume of what is enclosed at least once: many of these overlap themselves a little."""
    result = boolean([body], [], RESOLVE)
    assert result.status == 0 and measures.open_edges(result.body) == 0
    return result.volume


@pytest.mark.parametrize("number", range(len(PAIRS)), ids=NAMES)
def test_one_thread_and_two_give_the_same_bytes(number):
    first, second = posed(number)
    one, two = (boolean([first], [second], DIFFERENCE, threads) for threads in (1, 2))
    assert one.bytes() == two.bytes()


@pytest.mark.parametrize("name", ["bones", "man", "diplodocus", "elephant"])
def test_resolve_leaves_what_is_enclosed_at_least_once(name):
    body = meshes.cgal_mesh(name)
    result = boolean([body], [], RESOLVE)
    assert result.status == 0 and measures.open_edges(result.body) == 0
    assert len(disagreements(RESOLVE, [body], [], result.body)) == 0
    rng = np.random.default_rng(9)
    points = measures.probes(rng, [result.body], COUNT, STEP)
    assert set(np.unique(measures.winding(result.body, points))) <= {0, 1}


def test_a_mesh_that_is_inside_out_is_turned_over_and_said_to_be():
    """ellipe0.003 of libcgal-demo has its normals inwards."""
    body = meshes.cgal_mesh("ellipe0.003")
    assert measures.volume(body) < 0
    other = meshes.cgal_mesh("cow")
    result = boolean([body], [other], UNION)
    assert result.status == 4 and result.message
    assert not result.errors and len(result.warnings) == 1
    assert measures.open_edges(result.body) == 0
    turned = meshes.inside_out(body)
    assert len(disagreements(UNION, [turned], [other], result.body)) == 0
