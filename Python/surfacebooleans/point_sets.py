# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Recipes for scanned points: the smooth surface of a cloud, and where other geometry meets it."""

from surfacebooleans.meshes import as_data, as_plane, as_surface, result
from surfacebooleans.running import configure, update
from surfacebooleans.surfaces import number_of
from surfacebooleans.vtk import vtkPointSetBooleanFilter, vtkPointSetIntersectionFilter, vtkPointSetSurfaceFilter
from vtkmodules.vtkCommonDataModel import vtkPlane

CLOUD_OPERATIONS = ("union", "intersection", "difference", "reverse difference")


def point_set_surface(cloud, *, cell_size=0.0, curvatures=True, width=0.0, flip=False, threads=0, progress=False):
    """A mesh of the smooth surface that a cloud of points samples (moving least squares).

    Parameters
    ----------
    cloud : vtkPointSet, pyvista data set, array of shape (n, 3), or pair of such for points and normals
        Normals are estimated where it has none.
    cell_size : float, optional
        About the edge of the triangles, in the unit of the points; 0 for two spacings of the cloud.
    curvatures : bool, optional
        Whether points get their curvatures.
    width : float, optional
        The scale below which detail is taken for noise, in the unit of the points; 0 for 3.15 spacings.
    flip : bool, optional
        Turn all normals over.
    threads, progress
        As in `boolean`.

    Returns
    -------
    mesh
        Triangles whose corners lie on the surface, with ``Normals`` and curvatures; closed if the cloud is. For arrays
        `(points, triangles)`.

    Raises
    ------
    SurfaceBooleansError
        If there are fewer than six points, all points lie on lines, or the cells are too small.

    Warns
    -----
    SurfaceBooleansWarning
        If many normals may be wrong, or many points are off the surface.

    References
    ----------
    P. Yang, X. Qian, "Direct Boolean intersection between acquired and designed geometry", Computer-Aided Design 41(2),
    2009, sections 3 and 4.1.
    """
    algorithm = _cloud_filter(cloud, True, cell_size, curvatures, width, flip, threads)
    update(algorithm, progress)
    return result(algorithm.GetSurfaceOutput(), cloud)


def point_set_points(cloud, *, project=True, curvatures=True, width=0.0, flip=False, threads=0, progress=False):
    """The points of a cloud on the smooth surface that they sample, with normals, curvatures and quality.

    Parameters
    ----------
    cloud, curvatures, width, flip, threads, progress
        As in `point_set_surface`.
    project : bool, optional
        Off, the points stay where they are.

    Returns
    -------
    vtkPolyData or pyvista.PolyData
        All points in their order with ``Normals``, ``Residual`` (how far the point was from its place), ``Validity``
        (0: all is well), ``MeanCurvature`` and others, ``DoubtfulNormal``. For an array too, because there is more than
        an array.

    Raises
    ------
    SurfaceBooleansError
        As in `point_set_surface`.

    References
    ----------
    Yang, Qian (2009), sections 3 and 4.1.
    """
    data = as_data(cloud)
    algorithm = _cloud_filter(data, False, 0.0, curvatures, width, flip, threads)
    algorithm.SetProjectPoints(project)
    update(algorithm, progress)
    return result(algorithm.GetOutput(), data)


def _cloud_filter(cloud, mesh, cell_size, curvatures, width, flip, threads):
    algorithm = configure(
        vtkPointSetSurfaceFilter(),
        GenerateSurface=mesh,
        CellSize=cell_size,
        ComputeCurvatures=curvatures,
        Width=width,
        FlipNormals=flip,
        NumberOfThreads=threads,
    )
    algorithm.SetInputDataObject(0, as_data(cloud))
    return algorithm


def point_set_intersection(cloud, tool, *, chord_error=0.0, width=0.0, flip=False, threads=0, progress=False):
    """The curves in which a plane or a surface meets the surface of a cloud of points, without meshing the cloud.

    Parameters
    ----------
    cloud, width, flip, threads, progress
        As in `point_set_surface`.
    tool : (origin, normal), vtkPlane or mesh
        What to cut with. Of a mesh that comes from a CAD file (`read_nurbs`), the exact surfaces are cut. The inside of
        the cloud is on the left of the curves as seen from the front of the tool.
    chord_error : float, optional
        How far the curve may be from a segment of the polyline, in the unit of the points; 0 for a tenth of the
        spacing.

    Returns
    -------
    mesh
        Polylines with the point arrays ``Normals`` and ``Curvature`` and the cell arrays ``Length``, ``Closed`` and
        ``ChordError`` (measured), with a mesh also ``OriginalCellId`` and others; for arrays a list of arrays of shape
        (k, 3).

    Raises
    ------
    SurfaceBooleansError
        As in `point_set_surface`.
    TypeError
        If `tool` is neither a plane nor a mesh.

    References
    ----------
    Yang, Qian (2009), section 4.2.
    """
    plane = as_plane(tool)
    algorithm = configure(
        vtkPointSetIntersectionFilter(), ChordError=chord_error, Width=width, FlipNormals=flip, NumberOfThreads=threads
    )
    algorithm.SetInputDataObject(0, as_data(cloud))
    if plane:
        algorithm.SetPlane(_vtk_plane(*plane))
    else:
        algorithm.SetInputDataObject(1, as_surface(tool))
    update(algorithm, progress)
    return result(algorithm.GetOutput(), cloud, lines=True)


def point_set_boolean(
    cloud,
    tool,
    operation="union",
    *,
    cell_size=0.0,
    width=0.0,
    flip=False,
    threads=0,
    points=False,
    curves=False,
    progress=False,
):
    """Union, intersection or difference of the solid that a cloud of points encloses with a designed body.

    Parameters
    ----------
    cloud, cell_size, width, flip, threads, progress
        As in `point_set_surface`.
    tool : mesh
        A closed surface. Of one from a CAD file (`read_nurbs`), the exact surfaces are used.
    operation : {"union", "intersection", "difference", "reverse difference"}, optional
        What is in the cloud's solid or in the tool, in both, in the cloud's solid without the tool, in the tool without
        the cloud's solid.
    points : bool, optional
        Whether to return what is left of the cloud, with the points of the seam, too.
    curves : bool, optional
        Whether to return the seam as curves, too.

    Returns
    -------
    mesh
        Triangles with ``SourceId`` (0 cloud, 1 tool), ``Confidence``, ``Normals``, ``Residual`` and ``SeamPoint``;
        closed if the scan is. The field data have what is known of the error, such as ``ErrorBudget`` in the unit of
        the points.
    vtkPolyData or pyvista.PolyData
        If `points`: one vertex each, with ``OriginalPointId`` (-1 on the seam).
    mesh
        If `curves`: polylines with ``Length``, ``Closed`` and ``ChordError``, or a list of arrays of shape (k, 3).

    Raises
    ------
    SurfaceBooleansError
        As in `point_set_surface`, and if the tool is not closed or the cloud is inside out.
    ValueError
        If there is no such operation.

    Warns
    -----
    SurfaceBooleansWarning
        If the surfaces do not meet or nearly coincide, or the scan is not closed.

    References
    ----------
    Yang, Qian (2009).
    """
    algorithm = configure(
        vtkPointSetBooleanFilter(),
        Operation=number_of(operation, CLOUD_OPERATIONS, "operation"),
        CellSize=cell_size,
        Width=width,
        FlipNormals=flip,
        NumberOfThreads=threads,
    )
    data = as_data(cloud)
    algorithm.SetInputDataObject(0, data)
    algorithm.SetInputDataObject(1, as_surface(tool))
    update(algorithm, progress)
    results = [result(algorithm.GetOutput(), cloud)]
    results += [result(algorithm.GetPointsOutput(), data)] if points else []
    results += [result(algorithm.GetCurvesOutput(), cloud, lines=True)] if curves else []
    return tuple(results) if points or curves else results[0]


def _vtk_plane(origin, normal):
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    return plane
