# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exact Boolean operations on surfaces, for pvpython and plain python3.

    import surfacebooleans as sb

    drilled = sb.boolean(plate, drill, "difference")

takes and returns meshes of pyvista or VTK, or arrays; `surfacebooleans.meshes` says exactly what. Errors of the filters
are raised as SurfaceBooleansError, warnings are warned as SurfaceBooleansWarning. ``python3 -m surfacebooleans --help``
shows the same for files.
"""

from pkgutil import extend_path

# The compiled modules lie in another folder in a build tree, and in this one after an installation.
__path__ = extend_path(__path__, __name__)

from surfacebooleans.clipping import clip, cut, triangulate_contours  # noqa: E402
from surfacebooleans.errors import FileError, SurfaceBooleansError, SurfaceBooleansWarning  # noqa: E402
from surfacebooleans.files import read, read_nurbs, write  # noqa: E402
from surfacebooleans.measures import measure  # noqa: E402
from surfacebooleans.meshes import fields_of, polydata  # noqa: E402
from surfacebooleans.point_sets import (  # noqa: E402
    point_set_boolean,
    point_set_intersection,
    point_set_points,
    point_set_surface,
)
from surfacebooleans.surfaces import boolean, check, distance, distance_field, intersection, split  # noqa: E402

__all__ = [
    "FileError",
    "SurfaceBooleansError",
    "SurfaceBooleansWarning",
    "boolean",
    "check",
    "clip",
    "cut",
    "distance",
    "distance_field",
    "fields_of",
    "intersection",
    "measure",
    "point_set_boolean",
    "point_set_intersection",
    "point_set_points",
    "point_set_surface",
    "polydata",
    "read",
    "read_nurbs",
    "split",
    "triangulate_contours",
    "write",
]
