# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Recipes for planes: clips, cross-sections, and the filling of contours."""

import numpy as np

from surfacebooleans.meshes import as_data, as_plane, as_surface, result
from surfacebooleans.running import configure, update
from surfacebooleans.vtk import (
    vtkPolyDataClipClosedSurface,
    vtkPolyDataContourTriangulator,
    vtkPolyDataCutClosedSurface,
)


def clip(
    mesh,
    planes=None,
    *,
    box=None,
    inside_out=False,
    pass_point_data=False,
    outline=False,
    tolerance=0.0,
    threads=0,
    progress=False,
):
    """Cut a closed surface by planes, and close it again with caps.

    Parameters
    ----------
    mesh : mesh
        A closed surface. Several in one are several solids; one that is inside out is a hole in the one around it.
    planes : plane or list of planes, optional
        A plane is `(origin, normal)`, three numbers each, or a vtkPlane; an array has the shape (n, 6). Kept is what
        lies where the normals of all planes point.
    box : six numbers, optional
        Keep what is inside of (xmin, xmax, ymin, ymax, zmin, zmax), too.
    inside_out : bool, optional
        Keep all the rest instead.
    pass_point_data : bool, optional
        Whether the point arrays are passed and interpolated.
    outline : bool, optional
        Whether to return the outlines of the caps, too; they are then lines of the first mesh as well.
    tolerance, threads, progress
        As in `boolean`.

    Returns
    -------
    mesh
        A closed surface. Its cell array ``SourceId`` is 0 on the surface, and the plane's number plus one on caps;
        those of the box follow those of `planes`.
    mesh
        If `outline`: polylines, or a list of arrays of shape (k, 3).

    Raises
    ------
    SurfaceBooleansError
        If the surface or a plane cannot be used.
    TypeError
        If a plane is none.

    Warns
    -----
    SurfaceBooleansWarning
        If the surface is open where it was cut.

    References
    ----------
    D. Gobbi, "VTK/Closed Surface Clipping", VTK wiki, 2010: vtkClipClosedSurface.
    """
    algorithm = configure(
        vtkPolyDataClipClosedSurface(),
        InsideOut=inside_out,
        PassPointData=pass_point_data,
        GenerateOutline=outline,
        Tolerance=tolerance,
        NumberOfThreads=threads,
    )
    for origin, normal in _planes(planes):
        algorithm.AddPlane(*origin, *normal)
    if box is not None:
        configure(algorithm, UseBox=True, Box=box)
    algorithm.SetInputDataObject(0, as_surface(mesh))
    update(algorithm, progress)
    clipped = result(algorithm.GetOutput(), mesh)
    return (clipped, result(algorithm.GetOutlineOutput(), mesh, lines=True)) if outline else clipped


def _planes(planes):
    """One plane or several as a list of (origin, normal)."""
    if planes is None:
        return []
    single = as_plane(planes)
    if single:
        return [single]
    found = [as_plane(plane) for plane in planes]
    if None in found:
        raise TypeError("a plane is (origin, normal), three numbers each, but planes has something else")
    return found


def cut(
    mesh,
    origin=(0.0, 0.0, 0.0),
    normal=(0.0, 0.0, 1.0),
    *,
    offsets=(0.0,),
    outlines=False,
    pass_point_data=False,
    tolerance=0.0,
    threads=0,
    progress=False,
):
    """Filled cross-sections of a closed surface: one, or a series of parallel ones.

    Parameters
    ----------
    mesh : mesh
        A closed surface.
    origin, normal : three floats, optional
        The plane of offset 0.
    offsets : sequence of float, optional
        Where the planes lie: distances from the origin along the normal, in the unit of the points.
    outlines : bool, optional
        Whether to return the outlines as closed polylines instead of triangles.
    pass_point_data : bool, optional
        Whether point arrays are interpolated along the outlines.
    tolerance, threads, progress
        As in `boolean`.

    Returns
    -------
    mesh
        Triangles that face where the normal points, or polylines (for `(points, faces)` a list of arrays of shape (k,
        3)). The cell arrays are ``SourceId`` (the plane), ``Offset``, ``PolygonId``, ``Area``, ``Perimeter`` and
        ``Nesting``.

    Raises
    ------
    SurfaceBooleansError
        If the surface or the normal cannot be used.

    References
    ----------
    D. Gobbi, "VTK/Closed Surface Clipping", VTK wiki, 2010: the caps of vtkClipClosedSurface.
    """
    algorithm = configure(
        vtkPolyDataCutClosedSurface(),
        Origin=origin,
        Normal=normal,
        Triangulate=not outlines,
        PassPointData=pass_point_data,
        Tolerance=tolerance,
        NumberOfThreads=threads,
    )
    offsets = np.asarray(offsets, dtype=float).ravel().tolist()
    algorithm.SetNumberOfOffsets(len(offsets))
    for k, offset in enumerate(offsets):
        algorithm.SetOffset(k, offset)
    algorithm.SetInputDataObject(0, as_surface(mesh))
    update(algorithm, progress)
    return result(algorithm.GetOutput(), mesh, lines=outlines)


def triangulate_contours(contours, *, progress=False):
    """Fill the closed contours of one plane with triangles; a contour within a contour is a hole.

    Parameters
    ----------
    contours : vtkPolyData or pyvista.PolyData
        Lines that close where ends have the same coordinates, in any direction.
    progress : bool or callable, optional
        As in `boolean`.

    Returns
    -------
    vtkPolyData or pyvista.PolyData
        Triangles over the same points, with the cell arrays ``PolygonId`` and ``Nesting``.

    Raises
    ------
    SurfaceBooleansError
        If there is nothing to fill.

    Warns
    -----
    SurfaceBooleansWarning
        If lines are part of no closed contour, or points lie off the plane.

    References
    ----------
    D. Gobbi, "VTK/Closed Surface Clipping", VTK wiki, 2010: vtkContourTriangulator.
    """
    algorithm = vtkPolyDataContourTriangulator()
    algorithm.SetInputDataObject(0, as_data(contours))
    update(algorithm, progress)
    return result(algorithm.GetOutput(), contours)
