# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""One class a contender: how it gets from raw arrays to raw arrays.

`prepare` is not timed: it turns the case's arrays into the element types that the contender takes without a copy.
`update` is timed: it builds every structure anew, computes, and gives back (points, triangles, keep), where `keep`
holds what shall be destroyed after the clock has stopped. Curves are given back as (points, (offsets, ids), keep):
polyline k is ids[offsets[k]:offsets[k + 1]]. Each contender is driven as its documentation shows.
"""

import functools

import numpy as np

from cases import CURVES

class Contender:
    def prepare(self, operation, input, tool, planes=()):
        self.operation = operation
        self.planes = planes
        self.meshes = [self.native(*mesh) for mesh in input + tool]
        self.number_of_inputs = len(input)

    def native(self, points, triangles):
        return points, triangles


class VTKFilter(Contender):
    """What ours and VTK's own filter have in common: polygonal data made of arrays, without a copy."""

    def native(self, points, triangles):
        offsets = np.arange(0, 3 * len(triangles) + 1, 3, dtype=self.id_type)
        return points, np.ascontiguousarray(triangles.ravel(), dtype=self.id_type), offsets

    def surface(self, points, connectivity, offsets):
        cells = self.vtkCellArray()
        cells.SetData(self.from_numpy(offsets), self.from_numpy(connectivity))
        surface = self.vtkPolyData()
        surface.SetPoints(self.points(points))
        surface.SetPolys(cells)
        return surface

    def points(self, array):
        points = self.vtkPoints()
        points.SetData(self.from_numpy(array))
        return points

    def import_vtk(self):
        from vtkmodules.util import numpy_support
        from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

        self.vtkPoints, self.vtkCellArray, self.vtkPolyData = vtkPoints, vtkCellArray, vtkPolyData
        self.from_numpy = numpy_support.numpy_to_vtk
        self.to_numpy = numpy_support.vtk_to_numpy
        self.id_type = np.int64
        return vtkVersion.GetVTKVersion()

    def run(self, filter, surfaces):
        if self.operation in CURVES:
            filter.SetSplitFirstOutput(self.operation != CURVES[0])
            filter.SetSplitSecondOutput(self.operation != CURVES[0])
        else:
            getattr(filter, f"SetOperationTo{self.operation.capitalize()}")()
        filter.Update()
        return *self.arrays(filter.GetOutput()), (filter, surfaces)

    def arrays(self, surface):
        if self.operation in CURVES:
            lines = surface.GetLines()
            ids = self.to_numpy(lines.GetConnectivityArray()), self.to_numpy(lines.GetOffsetsArray())
            return self.to_numpy(surface.GetPoints().GetData()), ids[::-1]
        if surface.GetNumberOfCells() == 0:
            return np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64)
        connectivity = self.to_numpy(surface.GetPolys().GetConnectivityArray())
        if len(connectivity) != 3 * surface.GetNumberOfCells():
            raise RuntimeError("the result has other cells than triangles")
        return self.to_numpy(surface.GetPoints().GetData()), connectivity.reshape(-1, 3)


class Ours(VTKFilter):
    """surfacebooleans.vtk.vtkPolyDataBooleanOperationFilter, and vtkPolyDataIntersection."""

    def __init__(self):
        from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter, vtkPolyDataIntersection

        self.filter_class, self.curves_class = vtkPolyDataBooleanOperationFilter, vtkPolyDataIntersection
        self.version = f"this tree, VTK {self.import_vtk()}"

    def update(self):
        surfaces = [self.surface(*mesh) for mesh in self.meshes]
        filter = self.curves_class() if self.operation in CURVES else self.filter_class()
        for k, surface in enumerate(surfaces):
            filter.AddInputDataObject(0 if k < self.number_of_inputs else 1, surface)
        return self.run(filter, surfaces)

    def move_tool(self, keep, distance):
        """Gives the tools of an earlier update other points, as a transform would; not timed."""
        _, surfaces = keep
        for surface, mesh in list(zip(surfaces, self.meshes))[self.number_of_inputs :]:
            surface.SetPoints(self.points(mesh[0] + distance))

    def update_again(self, keep):
        filter, _ = keep
        filter.Update()
        return *self.arrays(filter.GetOutput()), keep


class OurCheck(VTKFilter):
    """surfacebooleans.vtk.vtkPolyDataSurfaceCheck: all that it looks for, self-intersections among it."""

    def __init__(self):
        from surfacebooleans.vtk import vtkPolyDataSurfaceCheck

        self.filter_class = vtkPolyDataSurfaceCheck
        self.version = f"this tree, VTK {self.import_vtk()}"

    def update(self):
        surface = self.surface(*self.meshes[0])
        filter = self.filter_class()
        filter.SetInputData(surface)
        filter.Update()
        meetings = filter.GetOutput().GetCellData().GetArray("SelfIntersections")
        points, triangles = self.meshes[0][0], self.meshes[0][1].reshape(-1, 3)
        kept = triangles if meetings is None else triangles[self.to_numpy(meetings) == 0]
        return points, kept, (filter, surface)


class PyMeshLabCheck(Contender):
    """pymeshlab's selection of the faces that meet others."""

    def __init__(self):
        import pymeshlab

        self.module = pymeshlab
        self.version = package_version("pymeshlab")

    def update(self):
        meshes = self.module.MeshSet()
        meshes.add_mesh(self.module.Mesh(*self.meshes[0]))
        meshes.compute_selection_by_self_intersections_per_face()
        points, triangles = self.meshes[0]
        return points, triangles[~meshes.current_mesh().face_selection_array()], meshes


class MeshLibCheck(Contender):
    """meshlib's faces that meet others."""

    def __init__(self):
        from meshlib import mrmeshnumpy, mrmeshpy

        self.module, self.numpy = mrmeshpy, mrmeshnumpy
        self.version = package_version("meshlib")

    def update(self):
        points, triangles = self.meshes[0]
        mesh = self.numpy.meshFromFacesVerts(triangles, points)
        found = self.numpy.getNumpyBitSet(self.module.findSelfCollidingTrianglesBS(self.module.MeshPart(mesh)))
        meets = np.zeros(len(triangles), dtype=bool)
        meets[: len(found)] = found
        return points, triangles[~meets], mesh


class VTK(VTKFilter):
    """VTK's own vtkBooleanOperationPolyDataFilter and vtkIntersectionPolyDataFilter, of the wheel on PyPI."""

    def __init__(self):
        self.version = self.import_vtk()
        from vtkmodules.vtkFiltersGeneral import vtkBooleanOperationPolyDataFilter, vtkIntersectionPolyDataFilter

        self.filter_class, self.curves_class = vtkBooleanOperationPolyDataFilter, vtkIntersectionPolyDataFilter

    def update(self):
        surfaces = [self.surface(*mesh) for mesh in self.meshes]
        filter = self.curves_class() if self.operation in CURVES else self.filter_class()
        filter.SetInputData(0, surfaces[0])
        filter.SetInputData(1, surfaces[1])
        return self.run(filter, surfaces)


class Manifold(Contender):
    """manifold3d, in double precision."""

    def __init__(self):
        import manifold3d

        self.module = manifold3d
        self.version = package_version("manifold3d")

    def native(self, points, triangles):
        return points, triangles.astype(np.uint64)

    def update(self):
        solids = [self.module.Manifold(self.module.Mesh64(*mesh)) for mesh in self.meshes]
        for solid in solids:
            if solid.status() != self.module.Error.NoError:
                raise RuntimeError(f"manifold3d refuses the input: {solid.status()}")
        kinds = self.module.OpType
        kind = {"union": kinds.Add, "intersection": kinds.Intersect, "difference": kinds.Subtract}[self.operation]
        result = self.module.Manifold.batch_boolean(solids, kind)
        mesh = result.to_mesh64()
        return mesh.vert_properties[:, :3], mesh.tri_verts, (solids, result, mesh)


class Trueform(Contender):
    """trueform in double precision, the precision that ours works in."""

    real = np.float64

    def __init__(self):
        import trueform

        self.module = trueform
        self.version = package_version("trueform")

    def native(self, points, triangles):
        return triangles, points.astype(self.real)

    def update(self):
        meshes = [self.module.Mesh(*mesh) for mesh in self.meshes]
        if self.operation in CURVES:
            paths, points = self.module.intersection_curves(*meshes)
            return points, (paths.offsets, paths.data), (meshes, paths)
        if len(meshes) == 2:
            (triangles, points), *labels = getattr(self.module, f"boolean_{self.operation}")(*meshes)
            return points, triangles, (meshes, labels)
        graph = self.module.CsgGraph(meshes)
        union = functools.reduce(lambda a, b: a | b, (self.module.op(k) for k in range(len(meshes))))
        triangles, points = graph.mesh(union)
        return points, triangles, (meshes, graph)


class TrueformFloat(Trueform):
    """trueform in single precision, its fastest way."""

    real = np.float32


class MeshLib(Contender):
    """meshlib, which knows single precision only."""

    def __init__(self):
        from meshlib import mrmeshnumpy, mrmeshpy

        self.module, self.numpy = mrmeshpy, mrmeshnumpy
        self.version = package_version("meshlib")

    def native(self, points, triangles):
        return triangles, points

    def update(self):
        meshes = [self.numpy.meshFromFacesVerts(*mesh) for mesh in self.meshes]
        if len(meshes) == 2:
            kinds = self.module.BooleanOperation
            kind = {"union": kinds.Union, "intersection": kinds.Intersection, "difference": kinds.DifferenceAB}
            result = self.module.boolean(*meshes, kind[self.operation])
            if not result.valid():
                raise RuntimeError(f"meshlib: {result.errorString}")
            mesh = result.mesh
        else:
            pointers = self.module.std_vector_Mesh_const_ptr()
            for mesh in meshes:
                pointers.append(mesh)
            result = mesh = self.module.uniteManyMeshes(pointers)
        return self.numpy.getNumpyVerts(mesh), self.numpy.getNumpyFaces(mesh.topology), (meshes, result)


def package_version(name):
    from importlib.metadata import version

    return version(name)


# What finds triangles that meet others. It gives back those that meet none; if all do not, the volume is the surface's.
CHECKERS = {"ours": OurCheck, "pymeshlab": PyMeshLabCheck, "meshlib": MeshLibCheck}

CONTENDERS = {
    "ours": Ours,
    "manifold3d": Manifold,
    "vtk": VTK,
    "trueform": Trueform,
    "trueform-float": TrueformFloat,
    "meshlib": MeshLib,
}
