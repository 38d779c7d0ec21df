# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs vtkPolyDataSurfaceCheck on meshes, and gives what comes out as plain arrays."""

from dataclasses import dataclass, field

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

from booleans import Reported, arrays_of, bytes_of, cells_of, heard_from, points_of, polydata
from meshes import Mesh

BOUNDARY, NON_MANIFOLD, INCONSISTENT, TOUCHING, SELF, NO_AREA, DUPLICATE, WRONG_WAY, NOT_FINITE = range(1, 10)

# What is 0 for a clean body, by the name of its field array.
DEFECT_COUNTS = (
    "BoundaryEdgeCount",
    "BoundaryLoopCount",
    "NonManifoldEdgeCount",
    "NonManifoldPointCount",
    "InconsistentEdgeCount",
    "SelfIntersectionCount",
    "DegenerateCellCount",
    "DuplicateCellCount",
    "WrongWayTriangleCount",
    "NonFinitePointCount",
    "NonFiniteCellCount",
    "BadIndexCellCount",
    "OneSidedShellCount",
    "InvertedShellCount",
    "CoveredShellCount",
)


@dataclass
class Check(Reported):
    """What came out of the filter."""

    surface: vtkPolyData
    defects: vtkPolyData
    cell_data: dict
    point_data: dict
    defect_data: dict
    field_data: dict
    errors: list = field(default_factory=list)
    warnings: list = field(default_factory=list)

    def __getattr__(self, name):
        """A field array of one number by its name: check.ShellCount."""
        if name.startswith("_") or name not in self.field_data:
            raise AttributeError(name)
        value = self.field_data[name][0]
        return value if isinstance(value, str) else value.item()

    @property
    def found(self):
        """The counts that are not 0: {name without Count: number}."""
        return {name[: -len("Count")]: count for name in DEFECT_COUNTS if (count := int(self.field_data[name][0]))}

    def shells(self, name):
        return self.field_data["Shell" + name].tolist()

    def cells(self, defect):
        """The cells of Surface whose gravest defect this is."""
        return np.flatnonzero(self.cell_data["Defect"] == defect).tolist()

    def places(self, defect):
        """The coordinates of lines and vertices of one defect: a list of arrays of points, each sorted."""
        points, items = points_of(self.defects), []
        for cells in (self.defects.GetVerts(), self.defects.GetLines()):
            offsets, ids = cells_of(cells)
            items += [ids[begin:end] for begin, end in zip(offsets[:-1], offsets[1:])]
        kinds = self.defect_data["Defect"]
        return sorted(sorted(points[item].tolist()) for item, kind in zip(items, kinds) if kind == defect)

    def bytes(self):
        return bytes_of(self.surface, self.defects)


def check(surface, **settings):
    """Check a mesh, a vtkPolyData or a composite data set."""
    from surfacebooleans.vtk import vtkPolyDataSurfaceCheck

    tested = vtkPolyDataSurfaceCheck()
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    if surface is not None:
        tested.SetInputDataObject(polydata(surface) if isinstance(surface, Mesh) else surface)
    return update(tested)


def update(tested):
    errors, warnings = heard_from(tested)
    surface, defects = tested.GetOutputDataObject(0), tested.GetOutputDataObject(1)
    return Check(
        surface,
        defects,
        arrays_of(surface.GetCellData()),
        arrays_of(surface.GetPointData()),
        arrays_of(defects.GetCellData()),
        arrays_of(surface.GetFieldData()),
        errors,
        warnings,
    )
