# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs of the CAD reader, and the patches that its output carries, evaluated by a second, slow implementation."""

from dataclasses import dataclass, field

import numpy as np
import pytest
from vtkmodules.vtkCommonDataModel import vtkPolyData

from booleans import Reported, arrays_of, heard_from, points_of, triangles_of

SAMPLES = "/usr/share/opencascade/data"  # of Debian's package occt-misc


def needs_cad():
    """Skips the module where the project was built without Open CASCADE."""
    import surfacebooleans.vtk

    if not hasattr(surfacebooleans.vtk, "vtkNURBSReader"):
        pytest.skip("built without Open CASCADE", allow_module_level=True)


@dataclass
class Read(Reported):
    """What the reader gives, as plain arrays."""

    data: vtkPolyData
    body: object  # a meshes.Mesh
    point_data: dict
    cell_data: dict
    field_data: dict
    errors: list = field(default_factory=list)
    warnings: list = field(default_factory=list)


def plain(data, errors=(), warnings=()):
    return Read(
        data,
        triangles_of(data)[0],
        arrays_of(data.GetPointData()),
        arrays_of(data.GetCellData()),
        arrays_of(data.GetFieldData()),
        list(errors),
        list(warnings),
    )


def read(path, **settings):
    from surfacebooleans.vtk import vtkNURBSReader

    reader = vtkNURBSReader()
    if path is not None:
        reader.SetFileName(str(path))
    for name, value in settings.items():
        getattr(reader, "Set" + name)(value)
    errors, warnings = heard_from(reader)
    return plain(reader.GetOutputDataObject(0), errors, warnings)


def basis(knots, degree, parameters):
    """The B-splines at many parameters (Cox and de Boor): an array (parameter, spline)."""
    count = len(knots) - degree - 1
    x = np.clip(parameters, knots[degree], knots[count])[:, None]
    last = knots[:-1] < knots[1:]
    last &= knots[1:] == knots[count]
    values = ((knots[:-1] <= x) & (x < knots[1:])) | (last & (x == knots[count]))
    values = values.astype(float)
    for p in range(1, degree + 1):
        left, right = knots[p:-1] - knots[: -p - 1], knots[p + 1 :] - knots[1:-p]
        a = np.where(left > 0, (x - knots[: -p - 1]) / np.where(left > 0, left, 1), 0)
        b = np.where(right > 0, (knots[p + 1 :] - x) / np.where(right > 0, right, 1), 0)
        values = a * values[:, :-1] + b * values[:, 1:]
    return values


class Patches:
    """The field arrays NURBSDegrees, NURBSCounts, NURBSKnots and NURBSPoles."""

    def __init__(self, field_data):
        self.degrees, self.counts = field_data["NURBSDegrees"], field_data["NURBSCounts"]
        self.knots, self.poles = [], []
        knot = pole = 0
        for (p, q), (m, n) in zip(self.degrees, self.counts):
            middle, end = knot + m + p + 1, knot + m + p + n + q + 2
            self.knots.append((field_data["NURBSKnots"][knot:middle], field_data["NURBSKnots"][middle:end]))
            self.poles.append(field_data["NURBSPoles"][pole : pole + m * n].reshape(m, n, 4))
            knot, pole = end, pole + m * n
        assert knot == len(field_data["NURBSKnots"]) and pole == len(field_data["NURBSPoles"])

    def __len__(self):
        return len(self.knots)

    def points(self, face, uv):
        (p, q), (first, second), poles = self.degrees[face], self.knots[face], self.poles[face]
        a, b = basis(first, p, uv[:, 0]), basis(second, q, uv[:, 1])
        weighted = np.concatenate([poles[:, :, :3] * poles[:, :, 3:], poles[:, :, 3:]], axis=2)
        along = (a @ weighted.reshape(len(poles), -1)).reshape(len(uv), -1, 4)
        sums = np.einsum("kj,kjc->kc", b, along)
        return sums[:, :3] / sums[:, 3:]

    def normals(self, face, uv, step=1e-6):
        """By differences, not normalised, inwards from the border of the domain."""
        sides = []
        for axis in range(2):
            knots, degree = self.knots[face][axis], self.degrees[face][axis]
            first, last = knots[degree], knots[len(knots) - degree - 1]
            h = step * (last - first)
            low, high = uv.copy(), uv.copy()
            low[:, axis] = np.clip(uv[:, axis] - h, first, last)
            high[:, axis] = np.clip(uv[:, axis] + h, first, last)
            sides.append(self.points(face, high) - self.points(face, low))
        return np.cross(*sides)


def distances_to_patches(result, weights=((1, 0, 0), (0, 1, 0), (0, 0, 1))):
    """From the points with these weights in the corners of each facet, both in space and in the parameters, to the
    patch: an array (weight, facet)."""
    patches, face = Patches(result.field_data), result.cell_data["FaceId"]
    triangles, points, uv = result.body.triangles, points_of(result.data), result.point_data["UV"]
    found = np.zeros((len(weights), len(triangles)))
    for k, w in enumerate(weights):
        for f in np.unique(face):
            chosen = triangles[face == f]
            place = np.einsum("c,tcx->tx", w, uv[chosen])
            found[k, face == f] = np.linalg.norm(
                patches.points(f, place) - np.einsum("c,tcx->tx", w, points[chosen]), axis=1
            )
    return found


def chord_errors(result, weights=((0.5, 0.5, 0), (0, 0.5, 0.5), (0.5, 0, 0.5), (0.6, 0.2, 0.2), (1 / 3, 1 / 3, 1 / 3))):
    """How far the patch is from the plane of each facet at these places."""
    patches, face = Patches(result.field_data), result.cell_data["FaceId"]
    triangles, points, uv = result.body.triangles, points_of(result.data), result.point_data["UV"]
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    found = np.zeros(len(triangles))
    for w in weights:
        for f in np.unique(face):
            of = face == f
            there = patches.points(f, np.einsum("c,tcx->tx", w, uv[triangles[of]]))
            found[of] = np.maximum(found[of], np.abs(np.einsum("tx,tx->t", there - a[of], normal[of])))
    return found
