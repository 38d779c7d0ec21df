# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exact rational patches (quadrics of revolution and planes), evaluated here, and bodies of them as the reader hands
them out: facets with UV and FaceId, and the patches as field data."""

from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk

import meshes
from booleans import polydata
from cad import basis

ROOT = np.sqrt(0.5)
CIRCLE = [(1, 0, 1), (1, 1, ROOT), (0, 1, 1), (-1, 1, ROOT), (-1, 0, 1), (-1, -1, ROOT), (0, -1, 1), (1, -1, ROOT)]
CIRCLE += CIRCLE[:1]


@dataclass
class Patch:
    degrees: tuple
    knots: tuple  # of u, of v
    poles: np.ndarray  # (along u, along v, 4): x, y, z and weight

    def __call__(self, u, v):
        """Points at arrays of u and v."""
        along_u, along_v = (
            basis(np.asarray(k, dtype=float), d, np.asarray(t)) for k, d, t in zip(self.knots, self.degrees, (u, v))
        )
        weights = self.poles[..., 3]
        weighted = self.poles[..., :3] * weights[..., None]
        above = np.einsum("ni,nj,ijk->nk", along_u, along_v, weighted)
        return above / np.einsum("ni,nj,ij->n", along_u, along_v, weights)[:, None]


def arc_knots(arcs):
    inner = [k / arcs for k in range(1, arcs) for _ in range(2)]
    return [0, 0, 0] + inner + [1, 1, 1]


def revolution(profile, degree, knots):
    """A profile of (r, z, weight) turned about z: u around, v along it; its normal points outwards if it goes up."""
    poles = np.array([[(x * r, y * r, z, a * w) for r, z, w in profile] for x, y, a in CIRCLE], dtype=float)
    return Patch((2, degree), (arc_knots(4), knots), poles)


def sphere(r):
    return revolution([(0, -r, 1), (r, -r, ROOT), (r, 0, 1), (r, r, ROOT), (0, r, 1)], 2, arc_knots(2))


def wall(r, low, high):
    return revolution([(r, low, 1), (r, high, 1)], 1, [0, 0, 1, 1])


def disc(r, z, faces_up):
    """Bent around its centre, where all u are one point."""
    ends = [(r, z, 1), (0, z, 1)] if faces_up else [(0, z, 1), (r, z, 1)]
    return revolution(ends, 1, [0, 0, 1, 1])


def torus(ring, tube):
    profile = [(ring + tube * x, tube * y, w) for x, y, w in CIRCLE]
    return revolution(profile, 2, arc_knots(4))


def body(patches, across=(24, 12)):
    """A vtkPolyData of a grid of facets for each patch, with all arrays."""
    points, triangles, uv, face = [], [], [], []
    count_u, count_v = across
    for number, patch in enumerate(patches):
        along_u, along_v = np.arange(count_u + 1) / count_u, np.arange(count_v + 1) / count_v
        u, v = (a.ravel() for a in np.meshgrid(along_u, along_v, indexing="ij"))
        x = np.round(patch(u, v) * 2.0**40) / 2.0**40 + 0.0  # so that seams and neighbours meet
        first = sum(len(p) for p in points)
        ids = first + np.arange(len(x)).reshape(count_u + 1, count_v + 1)
        a, b, c, d = ids[:-1, :-1].ravel(), ids[1:, :-1].ravel(), ids[1:, 1:].ravel(), ids[:-1, 1:].ravel()
        facets = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
        corners = x[facets - first]
        whole = (np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2) > 0).all(axis=1)
        points.append(x)
        triangles.append(facets[whole])
        uv.append(np.stack([u, v], 1))
        face.append(np.full(whole.sum(), number, dtype=np.int32))
    data = polydata(meshes.mesh(np.concatenate(points), np.concatenate(triangles)))
    attach(data.GetPointData(), "UV", np.concatenate(uv))
    attach(data.GetCellData(), "FaceId", np.concatenate(face))
    fields = data.GetFieldData()
    attach(fields, "NURBSDegrees", np.array([p.degrees for p in patches], dtype=np.int32))
    attach(fields, "NURBSCounts", np.array([p.poles.shape[:2] for p in patches], dtype=np.int32))
    attach(fields, "NURBSKnots", np.concatenate([np.concatenate(p.knots).astype(float) for p in patches]))
    attach(fields, "NURBSPoles", np.concatenate([p.poles.reshape(-1, 4) for p in patches]))
    return data


def attach(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)
