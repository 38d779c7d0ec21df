# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""One class a contender in measuring distances: how it gets from raw arrays to distances.

`prepare` is not timed: it turns the arrays into the element types that the contender takes without a copy. `update` is
timed: it builds every structure anew, measures all points, and gives back (distances, keep). Distances are signed where
`signed` says so. Each contender is driven as its documentation shows.
"""

import importlib.util
from pathlib import Path

import numpy as np

from contenders import VTKFilter, package_version


class Contender:
    signed = False

    def prepare(self, points, triangles, queries):
        self.points, self.triangles, self.queries = points, triangles, queries


class VTKDistance(VTKFilter):
    """What ours and VTK's own filter have in common."""

    signed = True

    def prepare(self, points, triangles, queries):
        self.mesh, self.queries = self.native(points, triangles), queries

    def cloud(self):
        cloud = self.vtkPolyData()
        cloud.SetPoints(self.points(self.queries))
        return cloud

    def update(self):
        cloud, surface = self.cloud(), self.surface(*self.mesh)
        filter = self.filter_class()
        self.configure(filter)
        filter.SetInputData(0, cloud)
        filter.SetInputData(1, surface)
        filter.Update()
        return self.to_numpy(filter.GetOutput().GetPointData().GetArray("Distance")), (filter, cloud, surface)


class Ours(VTKDistance):
    """surfacebooleans.vtk.vtkPolyDataDistance: signed, and with the nearest cells."""

    threads = 0

    def __init__(self):
        from surfacebooleans.vtk import vtkPolyDataDistance

        self.filter_class = vtkPolyDataDistance
        self.version = f"this tree, VTK {self.import_vtk()}"

    def configure(self, filter):
        filter.ComputeNearestCellIdOn()
        filter.SetNumberOfThreads(self.threads)


class OursOneThread(Ours):
    """The same on one thread, for the scaling."""

    threads = 1


class VTK(VTKDistance):
    """VTK's own vtkDistancePolyDataFilter, of the wheel on PyPI."""

    def __init__(self):
        self.version = self.import_vtk()
        from vtkmodules.vtkFiltersGeneral import vtkDistancePolyDataFilter

        self.filter_class = vtkDistancePolyDataFilter

    def cloud(self):
        cloud = super().cloud()
        cloud.SetPolys(self.surface(*self.native(self.queries, np.array([[0, 1, 2]]))).GetPolys())  # it wants a cell
        return cloud

    def configure(self, filter):
        filter.ComputeSecondDistanceOff()
        filter.ComputeCellCenterDistanceOff()


class PackagedVTK(VTK):
    """The same of the VTK that ParaView's package has, which ours runs in, too."""


class FCPW(Contender):
    """fcpw, single precision, without sign."""

    def __init__(self):
        import fcpw

        self.module = fcpw
        self.version = package_version("fcpw")

    def prepare(self, points, triangles, queries):
        super().prepare(points.astype(np.float32), triangles, np.asfortranarray(queries, dtype=np.float32))
        self.reach = np.full(len(queries), np.inf, dtype=np.float32)

    def update(self):
        scene = self.module.scene_3D()
        scene.set_object_count(1)
        scene.set_object_vertices(self.points, 0)
        scene.set_object_triangles(self.triangles, 0)
        scene.build(self.module.aggregate_type.bvh_surface_area, True)
        found = self.module.interaction_3D_list()
        scene.find_closest_points(self.queries, self.reach, found)
        return found, scene

    def distances(self, found):
        return np.array([one.d for one in found])


class Open3D(Contender):
    """Open3D's RaycastingScene, single precision, with sign. Only its compiled part is imported: the rest wants a
    notebook."""

    signed = True

    def __init__(self):
        folder = Path(importlib.util.find_spec("open3d").origin).parent
        spec = importlib.util.spec_from_file_location("pybind", next(folder.glob("pybind*.so")))
        self.module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(self.module)
        self.version = package_version("open3d")

    def prepare(self, points, triangles, queries):
        tensor = self.module.core.Tensor
        self.arrays = [points.astype(np.float32), triangles.astype(np.uint32), queries.astype(np.float32)]
        super().prepare(*(tensor.from_numpy(array) for array in self.arrays))

    def update(self):
        scene = self.module.t.geometry.RaycastingScene()
        scene.add_triangles(self.points, self.triangles)
        found = scene.compute_signed_distance(self.queries)
        return found.numpy(), scene


class LibIGL(Contender):
    """libigl, double precision, sign by pseudonormals."""

    signed = True

    def __init__(self):
        import igl

        self.module = igl
        self.version = package_version("libigl")

    def prepare(self, points, triangles, queries):
        super().prepare(points, triangles.astype(np.int64), queries)

    def update(self):
        kind = self.module.SignedDistanceType.SIGNED_DISTANCE_TYPE_PSEUDONORMAL
        found = self.module.signed_distance(self.queries, self.points, self.triangles, kind)
        return found[0], found


class PyMeshLab(Contender):
    """MeshLab's distance from a reference mesh, with sign."""

    signed = True

    def __init__(self):
        import pymeshlab

        self.module = pymeshlab
        self.version = package_version("pymeshlab")

    def update(self):
        meshes = self.module.MeshSet()
        meshes.add_mesh(self.module.Mesh(self.points, self.triangles), "reference")
        meshes.add_mesh(self.module.Mesh(self.queries), "measured")
        meshes.compute_scalar_by_distance_from_another_mesh_per_vertex(measuremesh=1, refmesh=0, signeddist=True)
        return meshes.mesh(1).vertex_scalar_array(), meshes


class MeshLib(Contender):
    """meshlib's projections, single precision, without sign."""

    def __init__(self):
        from meshlib import mrmeshnumpy, mrmeshpy

        self.module, self.numpy = mrmeshpy, mrmeshnumpy
        self.version = package_version("meshlib")

    def prepare(self, points, triangles, queries):
        super().prepare(points, triangles, self.numpy.pointCloudFromPoints(queries).points.vec)

    def update(self):
        mesh = self.numpy.meshFromFacesVerts(self.triangles, self.points)
        projector, found = self.module.PointsToMeshProjector(), self.module.std_vector_MeshProjectionResult()
        projector.updateMeshData(mesh)
        none = self.module.AffineXf3f()
        projector.findProjections(found, self.queries, none, none, np.finfo(np.float32).max, 0.0)
        return found, (mesh, projector)

    def distances(self, found):
        return np.sqrt([one.distSq for one in found])


CONTENDERS = {
    "ours": Ours,
    "ours-1-thread": OursOneThread,
    "packaged-vtk": PackagedVTK,
    "vtk": VTK,
    "fcpw": FCPW,
    "open3d": Open3D,
    "libigl": LibIGL,
    "pymeshlab": PyMeshLab,
    "meshlib": MeshLib,
}
