# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What must hold of any two closed bodies, over two hundred random pairs.

Closed in, closed out. vol(A|B) + vol(A&B) = vol(A) + vol(B), vol(A-B) = vol(A) - vol(A&B). The same
bytes for one thread and two. Nothing depends on the order of operands, cells or corners, nor on
place or unit. Where an exact answer is known (convex bodies, boxes on a grid), it is asked for too.

A soup of boxes overlaps itself, and only Resolve promises to take all of its inner walls away; the
other operations promise the set of points enclosed at least once, so for soups it is measured.
"""

import functools
import itertools

import numpy as np
import pytest

import measures
import meshes
from booleans import (
    DIFFERENCE,
    INTERSECTION,
    RESOLVE,
    SET_OPERATIONS,
    SYMMETRIC_DIFFERENCE,
    UNION,
    boolean,
)

CONVEX_PAIRS, SOUP_PAIRS, TURNED_PAIRS, BUMPY_PAIRS = range(70), range(70), range(40), range(10)
GRID = 6  # edge of the cube that box soups live in


# ---- the pairs ---------------------------------------------------------------------------------


def convex_pair(seed):
    rng = np.random.default_rng([1, seed])
    first = meshes.random_convex_body(rng, int(rng.integers(5, 30)))
    second = meshes.random_convex_body(rng, int(rng.integers(5, 30)))
    return first, meshes.on_lattice(meshes.moved(second, rng.uniform(-0.4, 0.4, 3)), 20)


def soup_boxes(seed):
    rng = np.random.default_rng([2, seed])
    return [meshes.random_boxes(rng, int(rng.integers(1, 6)), GRID) for _ in range(2)]


def soup_pair(seed):
    return tuple(meshes.box_soup(boxes) for boxes in soup_boxes(seed))


TURNS = (
    {  # name: angles of 90 degrees and others, and some so small that everything is nearly coplanar
        "none": 0.0,
        "1e-15": 1e-15,
        "1e-12": 1e-12,
        "1e-8": 1e-8,
        "1e-4": 1e-4,
        "0.1": 0.1,
        "a facet": 2 * np.pi / 16,
        "half a facet": np.pi / 16,
        "a quarter": np.pi / 2,
        "a half": np.pi,
    }
)
SHAPES_TO_TURN = {
    "cube": meshes.cube(1.0),
    "cylinder": meshes.cylinder(0.5, 1.0, around=16),
    "torus": meshes.torus(0.5, 0.2, 16, 8),
    "icosphere": meshes.icosphere(2, 0.5),
}


def turned_pair(seed):
    """A body on itself, turned about z, about x, or about any axis."""
    name, turn = list(itertools.product(SHAPES_TO_TURN, TURNS))[seed]
    rng = np.random.default_rng([3, seed])
    axis = [(0, 0, 1), (1, 0, 0), rng.normal(size=3)][seed % 3]
    body = SHAPES_TO_TURN[name]
    return body, meshes.turned(body, meshes.rotation(axis, TURNS[turn]))


def bumpy_pair(seed):
    rng = np.random.default_rng([4, seed])
    first, second = meshes.bumpy_sphere(rng), meshes.bumpy_sphere(rng)
    second = meshes.turned(second, meshes.random_rotation(rng))
    return tuple(
        meshes.on_lattice(b, 30) for b in (first, meshes.moved(second, rng.uniform(-0.5, 0.5, 3)))
    )


def touching_pairs():
    """Globes that touch from outside, by what of the one meets what of the other."""
    even, odd = 12, 6
    globe = meshes.lattice_sphere(0.5, around=even, along=7)  # a pole on z, a corner on x
    tall = meshes.lattice_sphere(0.5, around=even, along=odd)  # an edge on x, between two parallels
    flat = meshes.lattice_sphere(
        0.5, around=even, along=odd, first_angle=np.pi / even
    )  # a face on x
    bodies = {"corner": globe, "edge": tall, "face": flat}
    for one, other in itertools.product(bodies, bodies):
        left, right = bodies[one], bodies[other]
        reach = left.points[:, 0].max() - right.points[:, 0].min()
        for shift in ((0.0, 0.0), (0.0, 2.0**-7), (2.0**-6, 2.0**-8)):
            yield f"{one} on {other} {shift}", left, meshes.moved(right, (reach, *shift))
    for name, body in bodies.items():
        yield f"{name} on its mirror image", body, meshes.mirrored(body, 0, body.points[:, 0].max())
    pole = globe.points[:, 2].max()
    yield "pole on pole", globe, meshes.moved(globe, (0, 0, 2 * pole))
    yield "pole on pole, turned", globe, meshes.moved(tall, (0, 0, pole - tall.points[:, 2].min()))


TOUCHING = {name: (a, b) for name, a, b in touching_pairs()}
PAIRS = {
    **{f"convex {seed}": (convex_pair, seed) for seed in CONVEX_PAIRS},
    **{f"boxes {seed}": (soup_pair, seed) for seed in SOUP_PAIRS},
    **{f"turned {seed}": (turned_pair, seed) for seed in TURNED_PAIRS},
    **{f"bumpy {seed}": (bumpy_pair, seed) for seed in BUMPY_PAIRS},
    **{f"touching, {name}": (TOUCHING.get, name) for name in TOUCHING},
}


@functools.lru_cache(maxsize=None)
def pair(name):
    make, argument = PAIRS[name]
    return make(argument)


@functools.lru_cache(maxsize=None)
def plain(name, operation):
    """The result for the pair as it is, which many tests compare with."""
    first, second = pair(name)
    return boolean([first], [second], operation)


CENTERS = np.stack(np.meshgrid(*[np.arange(GRID) + 0.5] * 3, indexing="ij"), axis=-1).reshape(-1, 3)


def enclosed(name, body):
    """The volume of the points that a closed surface encloses at least once.

    For a soup the unit cells whose centres are inside count, by the tests' own winding number.
    """
    if name.startswith("boxes"):
        return int(np.count_nonzero(measures.inside(body, CENTERS)))
    return measures.volume(body)


def scale_of(*bodies):
    return sum(abs(measures.volume(body)) for body in bodies)


def test_there_are_at_least_two_hundred_pairs():
    assert len(PAIRS) + 20 >= 200  # and twenty of real meshes, in test_real_meshes.py


# ---- the identities ----------------------------------------------------------------------------


@pytest.mark.parametrize("name", PAIRS)
def test_closed_in_closed_out_and_the_volumes_add_up(name):
    first, second = pair(name)
    a, b = enclosed(name, first), enclosed(name, second)
    found = {}
    for operation in SET_OPERATIONS:
        result = plain(name, operation)
        assert result.status == 0 and not result.errors, result.message
        assert measures.open_edges(result.body) == 0, operation
        found[operation] = enclosed(name, result.body)
    allowed = 1e-12 * scale_of(first, second)
    assert abs(found[UNION] + found[INTERSECTION] - a - b) <= allowed
    assert abs(found[DIFFERENCE] - a + found[INTERSECTION]) <= allowed
    assert abs(found[SYMMETRIC_DIFFERENCE] - found[UNION] + found[INTERSECTION]) <= allowed


@pytest.mark.parametrize("seed", CONVEX_PAIRS)
def test_the_volumes_of_convex_pairs_are_exact(seed):
    first, second = convex_pair(seed)
    both = measures.convex_intersection_volume(first, second)
    a, b = measures.exact_volume(first), measures.exact_volume(second)
    expected = {UNION: a + b - both, INTERSECTION: both, DIFFERENCE: a - both}
    for operation, volume in expected.items():
        result = boolean([first], [second], operation)
        assert abs(result.volume - float(volume)) <= 1e-12 * float(a + b)
        assert result.is_empty == (volume == 0)


def grid_answer(operation, first, second):
    """The unit cells that belong to the result."""
    a, b = (meshes.voxels(boxes, GRID) >= 1 for boxes in (first, second))
    table = {
        UNION: a | b,
        INTERSECTION: a & b,
        DIFFERENCE: a & ~b,
        SYMMETRIC_DIFFERENCE: a ^ b,
        RESOLVE: a | b,
    }
    return table[operation]


@pytest.mark.parametrize("operation", [*SET_OPERATIONS, RESOLVE])
@pytest.mark.parametrize("seed", SOUP_PAIRS)
def test_soups_of_boxes_enclose_the_right_cells_of_the_grid(seed, operation):
    """Everything is coplanar, and operands overlap themselves."""
    boxes = soup_boxes(seed)
    expected = grid_answer(operation, *boxes)
    result = boolean([meshes.box_soup(boxes[0])], [meshes.box_soup(boxes[1])], operation)
    assert measures.open_edges(result.body) == 0
    assert np.array_equal(measures.inside(result.body, CENTERS), expected.ravel())


def assert_nothing_but_the_boundary(body, cells):
    """An area too large would show a wall left inside."""
    volume, walls = measures.voxel_volume_and_area(cells)
    assert measures.open_edges(body) == 0
    assert measures.volume(body) == pytest.approx(volume, abs=1e-12)
    assert measures.area(body) == pytest.approx(walls, abs=1e-10)


@pytest.mark.parametrize("seed", SOUP_PAIRS)
def test_resolve_leaves_the_boundary_of_the_cells_and_no_wall_inside(seed):
    boxes = soup_boxes(seed)
    soups = [meshes.box_soup(group) for group in boxes]
    result = boolean(soups[:1], soups[1:], RESOLVE)
    assert_nothing_but_the_boundary(result.body, grid_answer(RESOLVE, *boxes))
    for operation in SET_OPERATIONS:
        resolved = boolean([boolean(soups[:1], soups[1:], operation).body], [], RESOLVE)
        assert_nothing_but_the_boundary(resolved.body, grid_answer(operation, *boxes))


@pytest.mark.parametrize("seed", SOUP_PAIRS)
def test_each_box_an_operand_of_its_own_gives_the_same(seed):
    """N operands on either port are united in one arrangement."""
    boxes = soup_boxes(seed)
    inputs, tools = ([meshes.box(*ends) for ends in group] for group in boxes)
    for operation in SET_OPERATIONS:
        result = boolean(inputs, tools, operation)
        assert_nothing_but_the_boundary(result.body, grid_answer(operation, *boxes))
        assert set(np.unique(result.cell_data["SourceId"])) <= set(range(len(inputs) + len(tools)))


@pytest.mark.parametrize("name", TOUCHING)
def test_bodies_that_only_touch_have_nothing_in_common(name):
    first, second = TOUCHING[name]
    assert measures.convex_intersection_volume(first, second) == 0
    assert boolean([first], [second], INTERSECTION).is_empty
    difference = boolean([first], [second], DIFFERENCE)
    assert difference.volume == pytest.approx(measures.volume(first), rel=1e-15)
    assert difference.area == pytest.approx(measures.area(first), rel=1e-14)
    union = boolean([first], [second], UNION)
    assert union.volume == pytest.approx(scale_of(first, second), rel=1e-15)
    walls = measures.area(first) + measures.area(second)
    in_a_face = name.startswith("face on face") or name == "face on its mirror image"
    assert (union.area < walls - 1e-3) == in_a_face
    assert in_a_face or union.area == pytest.approx(walls, rel=1e-14)


@pytest.mark.parametrize("name", PAIRS)
def test_one_thread_and_two_give_the_same_bytes(name):
    first, second = pair(name)
    for operation in SET_OPERATIONS:
        one, two = (boolean([first], [second], operation, threads) for threads in (1, 2))
        assert one.bytes() == two.bytes()


@pytest.mark.parametrize("name", PAIRS)
def test_the_order_of_operands_does_not_matter(name):
    first, second = pair(name)
    allowed = 1e-12 * scale_of(first, second)
    for operation in (UNION, INTERSECTION, SYMMETRIC_DIFFERENCE):
        one, other = plain(name, operation), boolean([second], [first], operation)
        assert measures.open_edges(other.body) == 0
        assert abs(enclosed(name, one.body) - enclosed(name, other.body)) <= allowed
        if not name.startswith("boxes"):
            assert one.area == pytest.approx(other.area, rel=1e-12)


OVERLAPPING = {  # what a group of operands may be made of, beside clean bodies
    "clean": lambda rng: meshes.random_grid_body(rng),
    "overlapping": lambda rng: meshes.random_grid_body(rng, bodies=int(rng.integers(2, 4))),
    "doubled": lambda rng: meshes.joined(*[meshes.random_grid_body(rng)] * 2),
    "hollowed": lambda rng: meshes.joined(
        meshes.random_grid_body(rng, bodies=2), meshes.inside_out(meshes.random_grid_body(rng, 2))
    ),
}


@pytest.mark.parametrize("seed", range(32))
@pytest.mark.parametrize("kind", OVERLAPPING)
def test_bodies_on_a_tiny_grid_enclose_what_their_winding_numbers_say(kind, seed):
    """Several operands on either port, that overlap themselves and have parts turned inside out."""
    rng = np.random.default_rng([8, seed])
    inputs = [OVERLAPPING[kind](rng) for _ in range(int(rng.integers(1, 3)))]
    tools = [OVERLAPPING[kind](rng), meshes.random_grid_body(rng)]
    inputs, tools = ([b for b in group if measures.volume(b) > 0] for group in (inputs, tools))
    if not inputs or not tools:
        inputs, tools = [meshes.cube(3.0)], [meshes.random_grid_body(rng)]
    for operation in (*SET_OPERATIONS, RESOLVE):
        result = boolean(inputs, tools, operation)
        assert result.status == 0 and measures.open_edges(result.body) == 0, operation
        points = measures.probes(rng, [*inputs, *tools, result.body], 150, 1e-4)
        expected = measures.expected_inside(operation, inputs, tools, points)
        assert np.array_equal(measures.inside(result.body, points), expected), operation


@pytest.mark.parametrize("operation", [*SET_OPERATIONS, RESOLVE])
@pytest.mark.parametrize("place", [(5, 0, 0), (5.5, 0.25, 0.125), (5.25, 0, 0), (4, 0, 0)])
def test_a_part_turned_inside_out_encloses_nothing(place, operation):
    """Its winding number is -1; the operand as a whole has a positive volume all the same."""
    first = meshes.joined(meshes.cube(2.0), meshes.inside_out(meshes.cube(1.0, (5, 0, 0))))
    second = meshes.cube(1.0, place)
    result = boolean([first], [second], operation)
    assert result.status == 0 and measures.open_edges(result.body) == 0
    rng = np.random.default_rng(13)
    points = measures.probes(rng, [first, second], 400, 1e-4)
    expected = measures.expected_inside(operation, [first], [second], points)
    assert np.array_equal(measures.inside(result.body, points), expected)


# ---- invariance --------------------------------------------------------------------------------


def moves_exactly(name):
    """Whether a pair stands on a lattice so coarse that moving it by 1e6 rounds nothing."""
    return not name.startswith("turned")


@pytest.mark.parametrize("name", PAIRS)
def test_a_translation_by_1e6_changes_nothing(name):
    first, second = pair(name)
    far = [meshes.moved(body, (1e6, -1e6, 1e6)) for body in (first, second)]
    for operation in SET_OPERATIONS:
        here, there = plain(name, operation), boolean(far[:1], far[1:], operation)
        assert there.status == 0 and measures.open_edges(there.body) == 0
        if moves_exactly(name):
            back = meshes.moved(there.body, (-1e6, 1e6, -1e6))
            assert abs(enclosed(name, here.body) - enclosed(name, back)) <= measures.rounding(*far)
            assert name.startswith("boxes") or here.parents == there.parents


@pytest.mark.parametrize("factor", [1e-6, 1e6])
@pytest.mark.parametrize("name", PAIRS)
def test_a_scaling_changes_nothing(name, factor):
    first, second = pair(name)
    other = [meshes.scaled(body, factor) for body in (first, second)]
    for operation in SET_OPERATIONS:
        here, there = plain(name, operation), boolean(other[:1], other[1:], operation)
        assert there.status == 0 and measures.open_edges(there.body) == 0
        allowed = 1e-12 * scale_of(first, second)
        back = meshes.scaled(there.body, 1 / factor)
        assert abs(enclosed(name, here.body) - enclosed(name, back)) <= allowed


@pytest.mark.parametrize("name", PAIRS)
def test_permuted_cells_and_rotated_corners_change_nothing(name):
    first, second = pair(name)
    rng = np.random.default_rng(5)
    (mixed_first, first_order), (mixed_second, second_order) = (
        meshes.shuffled(body, rng) for body in (first, second)
    )
    orders = (first_order, second_order)
    for operation in SET_OPERATIONS:
        here = plain(name, operation)
        mixed = boolean([mixed_first], [mixed_second], operation)
        assert measures.open_edges(mixed.body) == 0
        allowed = 1e-12 * scale_of(first, second)
        assert abs(enclosed(name, here.body) - enclosed(name, mixed.body)) <= allowed
        if not name.startswith("boxes"):
            assert here.area == pytest.approx(mixed.area, rel=1e-12, abs=1e-15)
        if not has_coplanar_faces(name):
            assert {(s, int(orders[s][cell])) for s, cell in mixed.parents} == here.parents


def has_coplanar_faces(name):
    """Where faces lie on each other, which of them stands for both may depend on their order."""
    return name.startswith(("boxes", "turned", "touching"))
