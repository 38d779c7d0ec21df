# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""On every mesh of libcgal-demo, the check says of a surface what Surface Boolean then does with it."""

import numpy as np
import pytest

import measures
import meshes
from booleans import boolean
from checks import check

pytestmark = pytest.mark.skipif(not meshes.CGAL_DATA.exists(), reason="the package libcgal-demo is not installed")

NAMES = sorted(path.stem for path in meshes.cgal_directory().glob("*.off")) if meshes.CGAL_DATA.exists() else []
FAR_BOX = meshes.box((5, 5, 5), (6, 6, 6))
OPEN, INSIDE_OUT, CONTRADICTION = 2, 4, 5
CLEAN = """3torus anchor armadillo bear bear_bis blob-closed bunny00 cheese couplingdown dino fandisk femur hand helmet
homer joint knot1 knot2 pinion pipe refined_elephant retinal rotor spool triceratops turbine""".split()
GENUS = {"3torus": 3, "double-torus-example": 2, "torus_quad": 1, "knot": 1, "octahedron": 0, "pipe": 1, "eight": 2}


def readable(name):
    try:
        body = meshes.cgal_mesh(name)
    except (ValueError, IndexError):
        return None  # not a mesh of triangles
    return body if len(body.triangles) else None


@pytest.mark.parametrize("name", NAMES)
def test_the_verdict_is_what_a_boolean_does(name):
    body = readable(name)
    if body is None:
        pytest.skip("no surface")
    found, result = check(body), boolean([body], [FAR_BOX], "Union")
    assert not found.errors and found.status == 0
    assert found.Fit == (result.status == 0), found.Verdict
    assert bool(result.warnings or result.errors) == (result.status != 0)
    assert (found.InconsistentEdgeCount > 0) == (result.status == CONTRADICTION)
    assert (found.Closed == 0) == (result.status in (OPEN, CONTRADICTION))
    assert (found.Closed == 1 and found.Volume < 0) == (result.status == INSIDE_OUT)
    for condition, words in ((OPEN, "open"), (INSIDE_OUT, "inside out"), (CONTRADICTION, "against each other")):
        assert result.status != condition or words in found.Verdict
    if found.Clean:
        volume = measures.volume(body) + 1.0
        assert result.volume == pytest.approx(volume, rel=1e-12) and len(result.body.triangles) == len(body.triangles) + 12
        assert found.found == {}


def test_clean_bodies_are_clean():
    dirty = {name: found.found for name in CLEAN if not (found := check(meshes.cgal_mesh(name))).Clean}
    assert dirty == {}


@pytest.mark.parametrize("name", sorted(GENUS))
def test_genus(name):
    assert check(meshes.cgal_mesh(name)).Genus == GENUS[name]


@pytest.mark.parametrize("name", ("bones", "man"))
def test_meshes_that_are_known_to_overlap_themselves(name):
    body = meshes.cgal_mesh(name)
    found = check(body)
    assert found.SelfIntersectionCount > 100 and found.Fit == 1 and found.Clean == 0
    rng = np.random.default_rng(8)
    assert measures.winding(body, measures.probes(rng, [body], 2000, 1e-4)).max() > 1


def test_a_mesh_that_is_known_not_to_be_manifold():
    body = meshes.cgal_mesh("diplodocus")
    assert check(body).NonManifoldEdgeCount == measures.non_manifold_edges(body) > 0


def test_open_edges_are_those_of_an_independent_count():
    for name in ("elephant-with-holes", "b9_mesh", "mech-holes-shark", "lion"):
        body = meshes.cgal_mesh(name)
        assert check(body).BoundaryEdgeCount == measures.open_edges(body) > 0
