# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Intersection of a real scan with 500 random planes: every chord within the bound, every loop found.

Both are looked at from outside. Across each chord the implicit function changes its sign within the bound. Loops are those in
which the plane cuts the mesh of Point Set Surface, which is made by other means: by marching cubes.
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkPlane

import clouds
import sections

OK, TOUCHING = 0, 6
PLANES = 500
PLACES = np.array([0.25, 0.5, 0.75])  # on each chord
STEPS = np.linspace(-1, 1, 5)  # across it, in bounds


def values(surface, points):
    """The cloud's function at many points."""
    found = vtkDoubleArray()
    found.SetNumberOfTuples(len(points))
    surface.EvaluateFunction(numpy_to_vtk(np.ascontiguousarray(points)), found)
    return vtk_to_numpy(found).copy()


def are_near_chords(surface, curves, normal, bound):
    """Of places on each chord, whether the surface is within the bound of them, in the plane and across the chord."""
    starts = np.concatenate([curves.points[line[:-1]] for line in curves.lines])
    along = np.concatenate([np.diff(curves.points[line], axis=0) for line in curves.lines])
    across = np.cross(normal, along)
    across /= np.linalg.norm(across, axis=1)[:, None]
    places = starts[:, None, None] + PLACES[:, None, None] * along[:, None, None]
    places = places + bound * STEPS[:, None] * across[:, None, None]
    inside = values(surface, places.reshape(-1, 3)).reshape(-1, len(STEPS)) < 0
    return inside.any(axis=1) & ~inside.all(axis=1)


def loops_of_mesh(mesh, origin, normal):
    """The loops in which a plane cuts a closed mesh: each an array of places, at the middles of its pieces."""
    height = (mesh.points - origin) @ normal
    above = height[mesh.triangles] >= 0
    crossed = np.flatnonzero(above.any(axis=1) & ~above.all(axis=1))
    triangles = mesh.triangles[crossed]
    edges = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1)
    cut = (height[edges[..., 0]] >= 0) != (height[edges[..., 1]] >= 0)  # two edges of each
    ends = edges[cut].reshape(-1, 2, 2)
    a, b = ends[..., 0], ends[..., 1]
    share = height[a] / (height[a] - height[b])
    places = (mesh.points[a] + share[..., None] * (mesh.points[b] - mesh.points[a])).mean(axis=1)
    return [places[part] for part in parts_of(np.sort(ends, axis=-1))]


def parts_of(ends):
    """Pieces with two ends each, an end an edge, as lists of pieces that hang together."""
    _, names = np.unique(ends.reshape(-1, 2), axis=0, return_inverse=True)
    first, second = names.reshape(-1, 2).T
    label = np.arange(names.max(initial=-1) + 1)
    while True:
        least = np.minimum(label[first], label[second])
        new = label.copy()
        np.minimum.at(new, first, least)
        np.minimum.at(new, second, least)
        new = new[new]
        if np.array_equal(new, label):
            break
        label = new
    return [np.flatnonzero(label[first] == part) for part in np.unique(label)]


def width(points):
    return np.linalg.norm(points.max(axis=0) - points.min(axis=0))


def is_near(loop, points, reach):
    """Whether half of a loop's places have a point within reach."""
    if len(points) == 0:
        return False
    nearest = np.linalg.norm(loop[:, None] - points[None], axis=2).min(axis=1)
    return np.median(nearest) < reach


def test_500_planes_through_a_scanned_cat():
    points, normals = clouds.cgal_cloud("kitten.xyz")
    data = clouds.cloud(points, normals)
    surface = clouds.implicit(points, normals)
    mesh = clouds.surface_of(points, normals, GenerateSurface=True).mesh
    rng = np.random.default_rng(2009)
    tested, plane = sections.filter_of(data, {}), vtkPlane()
    tested.SetPlane(plane)
    loops = used = touches = 0
    smallest = np.inf
    for number in range(PLANES):
        normal = rng.normal(size=3)
        normal /= np.linalg.norm(normal)
        origin = points[rng.integers(len(points))] + 0.05 * rng.normal(size=3)
        plane.SetOrigin(origin)
        plane.SetNormal(normal)
        curves = sections.update(tested)
        spacing = curves.field_data["Spacing"][0]
        bound = 0.1 * spacing
        touches += curves.status == TOUCHING
        assert curves.status in (OK, TOUCHING) and not curves.errors
        assert curves.of_curves["ChordError"].max(initial=0) <= bound
        wanted = [loop for loop in loops_of_mesh(mesh, origin, normal) if width(loop) > 2 * spacing]
        if curves.lines:
            assert are_near_chords(surface, curves, normal, bound * (1 + 1e-6)).all()
        if curves.lines and number % 10 == 0:
            used += np.count_nonzero(~are_near_chords(surface, curves, normal, 0.2 * bound))
        for loop in wanted:
            assert is_near(loop, curves.points, spacing), (origin, normal)
        loops += len(wanted)
        smallest = min([smallest] + [width(loop) / spacing for loop in wanted])
    assert loops > 1.2 * PLANES and smallest < 4  # many at once, and small ones among them
    assert touches < 0.05 * PLANES
    assert used > 1000  # a tighter bound would not hold
