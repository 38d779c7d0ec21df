# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the filters that clip and cut, and looks at what they give by the ids of its points."""

from dataclasses import dataclass, field

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges

import measures
from booleans import Reported, arrays_of, bytes_of, heard_from, polydata, triangles_of
from meshes import Mesh


def plane_collection(planes):
    """A vtkPlaneCollection of pairs (origin, normal)."""
    collection = vtkPlaneCollection()
    for origin, normal in planes:
        plane = vtkPlane()
        plane.SetOrigin(origin)
        plane.SetNormal(normal)
        collection.AddItem(plane)
    return collection


def turned_planes(planes):
    return [(origin, [-n for n in normal]) for origin, normal in planes]


@dataclass
class Clipped(Reported):
    """What came out of a filter, as plain arrays."""

    surface: vtkPolyData
    outline: vtkPolyData
    body: Mesh
    cell_data: dict
    point_data: dict
    field_data: dict
    errors: list = field(default_factory=list)
    warnings: list = field(default_factory=list)

    @property
    def volume(self):
        return measures.volume(self.body)

    @property
    def cap_points(self):
        """The bytes of all points of caps."""
        caps = np.flatnonzero(self.cell_data["SourceId"] > 0)
        corners = self.body.points[self.body.triangles[caps]].reshape(-1, 3) + 0.0
        return {point.tobytes() for point in corners}

    def bytes(self):
        return bytes_of(self.surface, self.outline)


def update(tested):
    """Update a filter and collect what it gives and says."""
    errors, warnings = heard_from(tested)
    surface = tested.GetOutputDataObject(0)
    outline = tested.GetOutputDataObject(1) if tested.GetNumberOfOutputPorts() > 1 else surface
    return Clipped(
        surface,
        outline,
        triangles_of(surface)[0],
        arrays_of(surface.GetCellData()),
        arrays_of(surface.GetPointData()),
        arrays_of(surface.GetFieldData()),
        errors,
        warnings,
    )


def set_all(tested, body, settings):
    tested.SetInputDataObject(polydata(body) if isinstance(body, Mesh) else body)
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    return tested


def clip(body, planes=(), **settings):
    """Clip a mesh or vtkPolyData by pairs (origin, normal); `settings` go to the setters."""
    from surfacebooleans.vtk import vtkPolyDataClipClosedSurface

    tested = set_all(vtkPolyDataClipClosedSurface(), body, settings)
    tested.SetClippingPlanes(plane_collection(planes))
    return update(tested)


def cut(body, origin, normal, offsets=(0.0,), **settings):
    """Cross-sections of a mesh or vtkPolyData."""
    from surfacebooleans.vtk import vtkPolyDataCutClosedSurface

    tested = set_all(vtkPolyDataCutClosedSurface(), body, settings)
    tested.SetOrigin(origin)
    tested.SetNormal(normal)
    tested.SetNumberOfOffsets(len(offsets))
    for index, offset in enumerate(offsets):
        tested.SetOffset(index, float(offset))
    return update(tested)


def triangulate(data):
    """Fill the lines of a vtkPolyData."""
    from surfacebooleans.vtk import vtkPolyDataContourTriangulator

    return update(set_all(vtkPolyDataContourTriangulator(), data, {}))


def bad_edges(body):
    """Edges, by the ids of their points, without exactly one triangle on either side."""
    ids = body.triangles.astype(np.int64)
    edges = np.stack([ids, np.roll(ids, -1, axis=1)], axis=-1).reshape(-1, 2)
    low, high = edges.min(axis=1), edges.max(axis=1)
    _, number = np.unique(low * (ids.max(initial=0) + 1) + high, return_inverse=True)
    forward = np.bincount(number, edges[:, 0] == low)
    backward = np.bincount(number, edges[:, 0] != low)
    return int(np.count_nonzero((forward != 1) | (backward != 1)))


def feature_edges(data):
    """How many boundary and non-manifold edges vtkFeatureEdges finds."""
    edges = vtkFeatureEdges()
    edges.SetInputData(data)
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()
