# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a mesh measures, from its polygons alone and without any filter: size, area, volume, closed or not."""

from typing import NamedTuple

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from surfacebooleans.meshes import merged, points_of


def measure(mesh):
    """Measure a mesh.

    Parameters
    ----------
    mesh : mesh
        `surfacebooleans.meshes` says what that is.

    Returns
    -------
    dict
        ``points``, ``polygons``, ``lines`` (numbers of them), ``bounds`` (xmin, xmax, ymin, ...), and where there are
        polygons ``closed`` (whether every edge is gone along as often forwards as backwards, by coordinates), ``area``
        and ``volume`` (in the unit of the points squared and cubed; a volume means something if the surface is closed).
        Of other data than surfaces only the points.
    """
    data = merged(mesh)
    measured = {"points": data.GetNumberOfElements(vtkDataObject.POINT)}
    if not isinstance(data, vtkPolyData):
        return measured
    measured["polygons"] = data.GetNumberOfPolys()
    measured["lines"] = data.GetNumberOfLines()
    measured["bounds"] = list(data.GetBounds()) if data.GetNumberOfPoints() else None
    if data.GetNumberOfPolys():
        corners = _corners(data)
        measured.update(closed=_closed(corners), area=_area(corners), volume=_volume(corners))
    return measured


def is_closed(surface):
    """Whether every edge of a vtkPolyData is gone along as often forwards as backwards, by coordinates, and there are
    polygons."""
    return surface.GetNumberOfPolys() > 0 and _closed(_corners(surface))


def volume(surface):
    """The volume that the polygons of a vtkPolyData enclose."""
    return _volume(_corners(surface)) if surface.GetNumberOfPolys() else 0.0


class _Corners(NamedTuple):
    """The corners of all polygons, one after another."""

    points: np.ndarray  # float64, shape (n, 3)
    start: np.ndarray  # the point of each corner
    end: np.ndarray  # that of the next corner of its polygon
    first: np.ndarray  # that of the first corner of its polygon
    begin: np.ndarray  # where each polygon begins


def _corners(surface):
    polygons = surface.GetPolys()
    start = vtk_to_numpy(polygons.GetConnectivityArray())
    offsets = vtk_to_numpy(polygons.GetOffsetsArray())
    sizes = np.diff(offsets)
    begin, stop, sizes = offsets[:-1][sizes > 0], offsets[1:][sizes > 0], sizes[sizes > 0]
    end = np.roll(start, -1)
    end[stop - 1] = start[begin]
    return _Corners(points_of(surface).astype(np.float64), start, end, np.repeat(start[begin], sizes), begin)


def _closed(corners):
    """By a sum of hashes: what an edge adds forwards, it takes away backwards. It vanishes by chance once in 2^64."""
    with np.errstate(over="ignore"):
        place = _mixed((corners.points + 0.0).view(np.uint64) * np.array([1, 3, 5], np.uint64))  # -0.0 is 0.0
        place = _mixed(place @ np.array([0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9], np.uint64))
        a, b = place[corners.start], place[corners.end]
        turn = np.uint64(0xD6E8FEB86659FD93)
        return int(np.sum(_mixed(a * turn + b) - _mixed(b * turn + a), dtype=np.uint64)) == 0


def _mixed(values):
    """Scatter the bits of 64-bit numbers (the finalizer of SplitMix64: Steele, Lea, Flood 2014)."""
    values = (values ^ (values >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    values = (values ^ (values >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return values ^ (values >> np.uint64(31))


def _fans(corners):
    """Each polygon as a fan of triangles about its first corner; two of them have no area."""
    center = (corners.points.min(axis=0) + corners.points.max(axis=0)) / 2  # near the origin volumes round less
    return tuple(corners.points[ids] - center for ids in (corners.first, corners.start, corners.end))


def _area(corners):
    """Of planar polygons; where one is concave its fan overlaps, so the normals are added first."""
    a, b, c = _fans(corners)
    normals = np.add.reduceat(np.cross(b - a, c - a), corners.begin)
    return float(np.linalg.norm(normals, axis=1).sum() / 2)


def _volume(corners):
    a, b, c = _fans(corners)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)
