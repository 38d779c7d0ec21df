# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""One class a contender in working on clouds: how it gets from raw arrays to raw arrays.

`prepare` is not timed. A method for each task is: it builds every structure anew and gives back (points, vectors or
triangles, keep). `queries` is how many points `project` moves, where a contender may choose. Each contender is driven as
its documentation shows.
"""

import numpy as np

from contenders import VTKFilter, package_version


class Ours(VTKFilter):
    """vtkPointSetSurfaceFilter and vtkPointSetBooleanFilter, on one thread: what is compared is work."""

    queries = None  # all points of the cloud: the filter has no others
    operation = "cloud"
    threads = 1

    def __init__(self):
        from surfacebooleans import vtk

        self.filters = vtk
        self.version = f"this tree, VTK {self.import_vtk()}"

    def prepare(self, case):
        self.cloud_points, self.normals = case["points"], case["normals"]
        self.tool = self.native(case["tool_points"], case["tool_triangles"])

    def cloud(self, with_normals=True):
        cloud = self.vtkPolyData()
        cloud.SetPoints(self.points(self.cloud_points))
        if with_normals:
            cloud.GetPointData().SetNormals(self.from_numpy(self.normals))
        return cloud

    def update(self, filter, cloud):
        filter.SetNumberOfThreads(self.threads)
        filter.SetInputData(0, cloud)
        filter.Update()
        status = filter.GetOutput().GetFieldData().GetArray("Status").GetValue(0)
        if status >= 8 and status < 40:
            raise RuntimeError(filter.GetOutput().GetFieldData().GetAbstractArray("Message").GetValue(0))
        return filter

    def surface_filter(self):
        filter = self.filters.vtkPointSetSurfaceFilter()
        filter.ComputeCurvaturesOff()
        return filter

    def project(self):
        filter = self.update(self.surface_filter(), self.cloud())
        output = filter.GetOutput()
        return self.to_numpy(output.GetPoints().GetData()), None, filter

    def estimate(self):
        """Normals, as a by-product of the projection."""
        filter = self.update(self.surface_filter(), self.cloud(with_normals=False))
        output = filter.GetOutput()
        return self.to_numpy(output.GetPoints().GetData()), self.to_numpy(output.GetPointData().GetNormals()), filter

    def mesh(self):
        filter = self.surface_filter()
        filter.GenerateSurfaceOn()
        return *self.arrays(self.update(filter, self.cloud()).GetOutput(1)), filter

    def boolean(self):
        filter = self.filters.vtkPointSetBooleanFilter()
        filter.SetOperationToDifference()
        tool = self.surface(*self.tool)
        filter.SetInputData(1, tool)
        return *self.arrays(self.update(filter, self.cloud()).GetOutput()), (filter, tool)


class OursAllThreads(Ours):
    """The same on all cores, as the peer works: elapsed seconds are what is compared."""

    threads = 0


class PyMeshLab:
    """MeshLab: APSS projection, normals, screened Poisson; and a Boolean of manifold3d after that."""

    queries = 50_000

    def __init__(self):
        import manifold3d
        import pymeshlab

        self.module, self.manifold = pymeshlab, manifold3d
        self.version = f"{package_version('pymeshlab')} with manifold3d {package_version('manifold3d')}"

    def prepare(self, case):
        self.points, self.normals = case["points"], case["normals"]
        self.tool = case["tool_points"], case["tool_triangles"].astype(np.uint64)

    def cloud(self, count=None):
        return self.module.Mesh(vertex_matrix=self.points[:count], v_normals_matrix=self.normals[:count])

    def project(self):
        meshes = self.module.MeshSet()
        meshes.add_mesh(self.cloud(), "cloud")
        meshes.add_mesh(self.cloud(self.queries), "moved")
        meshes.set_current_mesh(0)  # it crashes with another one
        meshes.compute_mls_projection_apss(controlmesh=0, proxymesh=1, accuratenormal=False)
        return meshes.mesh(1).vertex_matrix(), None, meshes

    def estimate(self):
        meshes = self.module.MeshSet()
        meshes.add_mesh(self.module.Mesh(vertex_matrix=self.points), "cloud")
        meshes.compute_normal_for_point_clouds(k=16)
        return self.points, meshes.mesh(0).vertex_normal_matrix(), meshes

    def poisson(self):
        meshes = self.module.MeshSet()
        meshes.add_mesh(self.cloud(), "cloud")
        meshes.generate_surface_reconstruction_screened_poisson(depth=8)
        return meshes

    def mesh(self):
        meshes = self.poisson()
        surface = meshes.current_mesh()
        return surface.vertex_matrix(), surface.face_matrix(), meshes

    def boolean(self):
        points, triangles, meshes = self.mesh()
        solids = []
        for mesh in ((points, triangles.astype(np.uint64)), self.tool):
            solid = self.manifold.Manifold(self.manifold.Mesh64(*map(np.ascontiguousarray, mesh)))
            if solid.status() != self.manifold.Error.NoError:
                raise RuntimeError(f"manifold3d refuses the input: {solid.status()}")
            solids.append(solid)
        mesh = (solids[0] - solids[1]).to_mesh64()
        return mesh.vert_properties[:, :3], mesh.tri_verts, (meshes, solids, mesh)


CONTENDERS = {"ours": Ours, "ours-threads": OursAllThreads, "pymeshlab": PyMeshLab}
