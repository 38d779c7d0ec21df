# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Recipes for surfaces: Booleans, intersection curves, distances, and what is wrong with one."""

import numpy as np

from surfacebooleans.meshes import as_data, as_list, as_surface, points_of, result
from surfacebooleans.running import configure, update
from surfacebooleans.vtk import (
    vtkPolyDataBooleanOperationFilter,
    vtkPolyDataDistance,
    vtkPolyDataDistanceField,
    vtkPolyDataIntersection,
    vtkPolyDataSurfaceCheck,
)
from vtkmodules.util.numpy_support import vtk_to_numpy

OPERATIONS = ("union", "intersection", "difference", "symmetric difference", "resolve")
SIGN_METHODS = ("pseudonormal", "winding number")


def boolean(a, b=None, operation="union", *, reorient=True, tolerance=0.0, threads=0, curves=False, progress=False):
    """Union, intersection, difference, symmetric difference or resolution of surfaces, by exact arithmetic.

    Parameters
    ----------
    a, b : mesh or list of meshes
        Input and Tool (`surfacebooleans.meshes` says what a mesh is). Those of a list are united first; `b` may be
        None, but not for a difference or a symmetric difference.
    operation : {"union", "intersection", "difference", "symmetric difference", "resolve"}, optional
        What the result encloses: what is inside any surface; inside an `a` and a `b` (without `b`: inside all of `a`);
        inside an `a` and no `b`; inside an `a` or a `b`, but not both; inside any surface, where each surface's own
        overlaps and self-intersections are taken away, too.
    reorient : bool, optional
        Whether the cells of a difference that come from `b` are turned over, so that all face outwards.
    tolerance : float, optional
        How far points may be moved before the exact computation starts, in the unit of the points.
    threads : int, optional
        0 for one a core. The result does not depend on it.
    curves : bool, optional
        Whether to return the curves in which the surfaces meet, too.
    progress : bool or callable, optional
        True draws a bar (needs tqdm); a callable gets the share done, in [0, 1], and the stage.

    Returns
    -------
    mesh
        Of the kind of `a`, or of its first one; closed if the surfaces are. Where they have point arrays, such as
        normals, the sides of a seam have points of their own at the same places (pyvista: ``clean(tolerance=0)`` joins
        them). The cell array ``SourceId`` says which surface a cell comes from, counted from 0 through `a` and `b`,
        ``OriginalCellId`` which cell of it. The field data have ``Status``, ``Message``, ``ResultVolume``,
        ``ResultArea`` and more.
    mesh
        The curves, if asked for: polylines with the cell arrays ``Length`` and ``Closed``, or a list of arrays (k, 3).

    Raises
    ------
    SurfaceBooleansError
        If a surface cannot be used: what, where, and what to do.
    ValueError, TypeError
        If there is no such operation; if `a` or `b` are no meshes.

    Warns
    -----
    SurfaceBooleansWarning
        Such as where a surface is open, empty or inside out.

    References
    ----------
    C. Quammen, C. Weigle, R. M. Taylor II, "Boolean Operations on Surfaces in VTK Without External Libraries", The VTK
    Journal, 2011. http://hdl.handle.net/10380/3262

    Examples
    --------
    >>> import pyvista, surfacebooleans as sb
    >>> drilled = sb.boolean(pyvista.Cube().triangulate(), pyvista.Cylinder(radius=0.2, height=2), "difference")
    """
    algorithm = configure(
        vtkPolyDataBooleanOperationFilter(),
        Operation=number_of(operation, OPERATIONS, "operation"),
        ReorientDifferenceCells=reorient,
        Tolerance=tolerance,
        NumberOfThreads=threads,
    )
    inputs, tools = as_list(a), as_list(b)
    for port, surfaces in enumerate((inputs, tools)):
        for surface in surfaces:
            algorithm.AddInputDataObject(port, as_surface(surface))
    update(algorithm, progress)
    first = (inputs or tools)[0]
    surface = result(algorithm.GetOutput(), first)
    return (surface, result(algorithm.GetCurvesOutput(), first, lines=True)) if curves else surface


def intersection(a, b=None, *, tolerance=0.0, threads=0, progress=False):
    """The curves in which two surfaces meet, or in which one surface meets itself.

    Parameters
    ----------
    a, b : mesh
        They may be open, and of any orientation. Without `b`: the curves of `a` with itself.
    tolerance, threads, progress
        As in `boolean`.

    Returns
    -------
    mesh
        Polylines with the cell arrays ``CurveId``, ``Length`` (in the unit of the points), ``Closed`` and
        ``SourceIds``; for `(points, faces)` a list of arrays of shape (k, 3). Empty, with ``Status`` 40, where the
        surfaces do not meet.

    Raises
    ------
    SurfaceBooleansError
        If a surface cannot be used.

    References
    ----------
    Quammen, Weigle, Taylor (2011), section 5.3: vtkPolyDataIntersection.
    """
    return result(_intersected(a, b, False, tolerance, threads, progress).GetCurvesOutput(), a, lines=True)


def split(a, b, *, tolerance=0.0, threads=0, progress=False):
    """Two surfaces, cut along the curves in which they meet; nothing is taken away.

    Parameters
    ----------
    a, b, tolerance, threads, progress
        As in `intersection`.

    Returns
    -------
    a, b : mesh
        The surfaces with cuts. Their cell array ``PatchId`` tells the parts, the point array ``SeamPoint`` is 1 on the
        curves.

    Raises
    ------
    SurfaceBooleansError
        If a surface cannot be used.

    References
    ----------
    Quammen, Weigle, Taylor (2011), section 5.3: vtkPolyDataIntersection.
    """
    algorithm = _intersected(a, b, True, tolerance, threads, progress)
    return result(algorithm.GetSplitInputOutput(), a), result(algorithm.GetSplitToolOutput(), a)


def _intersected(a, b, parts, tolerance, threads, progress):
    algorithm = configure(
        vtkPolyDataIntersection(),
        SplitFirstOutput=parts,
        SplitSecondOutput=parts,
        Tolerance=tolerance,
        NumberOfThreads=threads,
    )
    algorithm.SetInputDataObject(0, as_surface(a))
    if b is not None:
        algorithm.SetInputDataObject(1, as_surface(b))
    update(algorithm, progress)
    return algorithm


def distance(
    a,
    b,
    *,
    signed=True,
    negate=False,
    sign="pseudonormal",
    maximum=0.0,
    cells=False,
    nearest=False,
    second=False,
    threads=0,
    progress=False,
):
    """The distance of each point of `a` to the surface `b`: negative inside, positive outside.

    Parameters
    ----------
    a : any data set of VTK or pyvista, a mesh, or array of shape (n, 3)
        Where to measure.
    b : mesh
        The surface to measure from.
    signed, negate : bool, optional
        Off: without sign. On: positive inside.
    sign : {"pseudonormal", "winding number"}, optional
        Inside is told by the nearest face, edge or vertex, or by how often `b` winds around the point: better where `b`
        has holes.
    maximum : float, optional
        Farther points get this distance, in the unit of the points; 0 for no limit.
    cells : bool, optional
        Whether cells get their distance, too, at the mean of their points.
    nearest : bool, optional
        Whether to add the arrays ``NearestPoint``, ``NearestCellId`` and ``Direction``.
    second : bool, optional
        Whether to measure from the points of `b` to `a`, too, which also gives the Hausdorff distance of both.
    threads, progress
        As in `boolean`.

    Returns
    -------
    data set, or array of shape (n,)
        A copy of `a` with the point array ``Distance`` (float64, in the unit of the points), and in the field data
        minimum, maximum, mean, RMS, quantiles and Hausdorff distances. For arrays, the distances alone.
    mesh, or array of shape (m,)
        If `second`: `b` with its distances, or these alone.

    Raises
    ------
    SurfaceBooleansError
        If `b` has no polygons.

    References
    ----------
    Quammen, Weigle, Taylor (2011), section 3.2; sign: J. A. Baerentzen, H. Aanaes, "Signed Distance Computation Using
    the Angle Weighted Pseudonormal", IEEE TVCG 11(3), 2005.
    """
    algorithm = configure(
        vtkPolyDataDistance(),
        SignedDistance=signed,
        NegateDistance=negate,
        SignMethod=number_of(sign, SIGN_METHODS, "sign"),
        MaximumDistance=maximum,
        ComputeCellCenterDistance=cells,
        ComputeNearestPoint=nearest,
        ComputeNearestCellId=nearest,
        ComputeDirection=nearest,
        ComputeSecondDistance=second,
        NumberOfThreads=threads,
    )
    algorithm.SetInputDataObject(0, as_data(a))
    algorithm.SetInputDataObject(1, as_surface(b))
    update(algorithm, progress)
    outputs = [algorithm.GetOutputDataObject(port) for port in range(2 if second else 1)]
    if isinstance(a, (tuple, np.ndarray)):
        outputs = [vtk_to_numpy(output.GetPointData().GetArray("Distance")) for output in outputs]
    else:
        outputs = [result(output, a) for output in outputs]
    return tuple(outputs) if second else outputs[0]


def distance_field(
    a,
    *,
    dimensions=(64, 64, 64),
    spacing=None,
    margin=0.1,
    band=0.0,
    signed=True,
    negate=False,
    sign="pseudonormal",
    threads=0,
    progress=False,
):
    """The distance to a surface, sampled on an image around it: contour it at 0 for the surface, elsewhere for offsets.

    Parameters
    ----------
    a : mesh
        The surface.
    dimensions : three ints, optional
        Samples along x, y and z, at least 2 each.
    spacing : float, optional
        Distance of neighbouring samples in the unit of the points, instead of `dimensions`; 0 for a hundredth of the
        longest side.
    margin : float, optional
        How far the image goes beyond the surface's box, as a share of the box's longest side.
    band : float, optional
        Samples farther away than this have this distance with their sign, which saves time; 0 measures all.
    signed, negate, sign, threads, progress
        As in `distance`.

    Returns
    -------
    vtkImageData or pyvista.ImageData
        With the point array ``Distance`` (float32, in the unit of the points).

    Raises
    ------
    SurfaceBooleansError
        If `a` has no polygons, or the image would be too large.

    References
    ----------
    Quammen, Weigle, Taylor (2011), section 3.1: the signed distance as an implicit function.
    """
    algorithm = configure(
        vtkPolyDataDistanceField(),
        SampleBy=0 if spacing is None else 1,
        Dimensions=dimensions,
        Spacing=spacing or 0.0,
        Margin=margin,
        NarrowBand=band,
        SignedDistance=signed,
        NegateDistance=negate,
        SignMethod=number_of(sign, SIGN_METHODS, "sign"),
        NumberOfThreads=threads,
    )
    algorithm.SetInputDataObject(0, as_surface(a))
    update(algorithm, progress)
    return result(algorithm.GetOutputDataObject(0), a)


def check(a, *, self_intersections=True, threads=0, progress=False):
    """What is wrong with a surface before a Boolean, and where.

    Parameters
    ----------
    a : mesh
        The surface; it may be open, damaged or inside out.
    self_intersections : bool, optional
        Whether to look for triangles that run through each other, which takes longer than all the rest.
    threads, progress
        As in `boolean`.

    Returns
    -------
    surface : mesh
        The surface with marks to colour by, such as the cell array ``Defect``. Of its field data (`fields_of`)
        ``Verdict`` is a paragraph that says what is wrong and what cures it, ``Fit`` is 1 if `boolean` takes it as a
        solid without a warning; the counts end in ``Count``. For `(points, faces)` there are the triangles alone.
    defects : mesh
        The edges and points where something is wrong, with the cell array ``Defect``; for `(points, faces)` a list of
        arrays of shape (k, 3).

    Raises
    ------
    SurfaceBooleansError
        If `a` is no surface.

    References
    ----------
    P. Guigue, O. Devillers, "Fast and Robust Triangle-Triangle Overlap Test Using Orientation Predicates", Journal of
    Graphics Tools 8(1), 2003.
    """
    algorithm = configure(
        vtkPolyDataSurfaceCheck(), SelfIntersections=self_intersections, NumberOfThreads=threads
    )
    algorithm.SetInputDataObject(0, as_surface(a))
    update(algorithm, progress)
    return result(algorithm.GetOutputDataObject(0), a), result(algorithm.GetOutputDataObject(1), a, lines=True)


def number_of(word, words, what):
    """The index of a word in a list, however its parts are joined."""
    plain = str(word).lower().replace("-", " ").replace("_", " ")
    if plain not in words:
        raise ValueError(f"there is no {what} {word!r}; there are: {', '.join(words)}")
    return words.index(plain)
