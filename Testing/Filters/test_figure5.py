# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Figure 5: five pairs of solids, three operations each, against exact volumes."""

import functools
from fractions import Fraction

import numpy as np
import pytest

import measures
import meshes
from booleans import (
    DIFFERENCE,
    INTERSECTION,
    SYMMETRIC_DIFFERENCE,
    UNION,
    answer_of_vtk,
    boolean,
    cells_of,
    points_of,
)

PAIRS = meshes.figure_5_pairs()


@functools.lru_cache(maxsize=None)
def exact_volumes(name):
    """The reference, in whole numbers: the common part by clipping with half-spaces."""
    first, second = PAIRS[name]
    a, b = measures.exact_volume(first), measures.exact_volume(second)
    both = measures.convex_intersection_volume(first, second)
    return {
        UNION: a + b - both,
        INTERSECTION: both,
        DIFFERENCE: a - both,
        SYMMETRIC_DIFFERENCE: a + b - 2 * both,
    }


@pytest.mark.parametrize("name", PAIRS)
def test_the_solids_are_convex_so_that_the_reference_is_exact(name):
    assert all(measures.is_exactly_convex(solid) for solid in PAIRS[name])


@pytest.mark.parametrize("operation", [UNION, INTERSECTION, DIFFERENCE, SYMMETRIC_DIFFERENCE])
@pytest.mark.parametrize("name", PAIRS)
def test_a_result_of_figure_5_is_closed_and_its_volume_right_to_1e_12(name, operation, beside):
    first, second = PAIRS[name]
    result = boolean([first], [second], operation)
    expected = exact_volumes(name)[operation]
    error = abs(measures.exact_volume(result.body) / expected - 1)
    if operation != SYMMETRIC_DIFFERENCE:
        beside(
            f"Figure 5, {name}, {operation}: volume {float(expected):.12g}",
            f"off by {float(error):.1g} relative, {measures.open_edges(result.body)} open edges",
            answer_of_vtk(first, second, operation),
        )
    assert result.status == 0 and not result.errors
    assert measures.open_edges(result.body) == 0
    assert error <= Fraction(1, 10**12)


@pytest.mark.parametrize("operation", [UNION, INTERSECTION, DIFFERENCE])
@pytest.mark.parametrize("name", PAIRS)
def test_each_part_lies_on_the_input_that_it_is_said_to_come_from(name, operation):
    """Blue from the first, red from the second: SourceId and OriginalCellId name a true parent."""
    solids = PAIRS[name]
    result = boolean([solids[0]], [solids[1]], operation)
    sources, cells = result.cell_data["SourceId"], result.cell_data["OriginalCellId"]
    assert set(np.unique(sources)) == {0, 1}
    corners = result.body.points[result.body.triangles]
    for source in (0, 1):
        mine = sources == source
        parents = solids[source].points[solids[source].triangles[cells[mine]]]
        normals = np.cross(parents[:, 1] - parents[:, 0], parents[:, 2] - parents[:, 0])
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        heights = np.einsum("ijk,ik->ij", corners[mine] - parents[:, :1], normals)
        assert np.abs(heights).max() < 1e-14
        facing = np.cross(corners[mine, 1] - corners[mine, 0], corners[mine, 2] - corners[mine, 0])
        same_way = np.einsum("ij,ij->i", facing, normals) > -1e-15
        if operation == DIFFERENCE and source == 1:
            same_way = np.einsum("ij,ij->i", facing, normals) < 1e-15
        assert same_way.all()


@pytest.mark.parametrize("name", PAIRS)
def test_a_difference_keeps_the_tools_cells_as_they_are_when_told_so(name):
    first, second = PAIRS[name]
    turned = boolean([first], [second], DIFFERENCE, ReorientDifferenceCells=1)
    left = boolean([first], [second], DIFFERENCE, ReorientDifferenceCells=0)
    assert measures.is_closed(turned.body)
    assert not measures.is_closed(left.body)
    assert left.area == pytest.approx(turned.area, rel=1e-14)


@pytest.mark.parametrize("name", PAIRS)
def test_the_intersection_curves_are_closed_and_lie_on_both_surfaces(name):
    first, second = PAIRS[name]
    curves = boolean([first], [second], INTERSECTION).curves
    assert curves.GetNumberOfLines() > 0
    offsets, ids = cells_of(curves.GetLines())
    ends = np.concatenate([ids[offsets[:-1]], ids[offsets[1:] - 1]])
    assert (np.bincount(ends)[ends] > 1).all(), "a curve ends where no other begins"
    for solid in (first, second):
        assert distance_to_faces(solid, points_of(curves)).max() < 1e-14


def distance_to_faces(solid, points):
    """How far points are off the nearest face of a convex solid: its highest plane is that face."""
    corners = solid.points[solid.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    heights = np.einsum("ijk,jk->ij", points[:, None] - corners[None, :, 0], normals)
    return np.abs(heights.max(axis=1))
