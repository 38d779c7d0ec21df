# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The contenders of the clips: as those of contenders.py, but they cut one mesh by planes and cap it."""

import numpy as np

from contenders import Contender, Trueform, VTKFilter, package_version


class VTKClipper(VTKFilter):
    """A filter with a collection of planes."""

    def update(self):
        from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection

        surface = self.surface(*self.meshes[0])
        collection = vtkPlaneCollection()
        for origin, normal in self.planes:
            plane = vtkPlane()
            plane.SetOrigin(origin)
            plane.SetNormal(normal)
            collection.AddItem(plane)
        filter = self.filter_class()
        filter.SetInputData(surface)
        filter.SetClippingPlanes(collection)
        filter.Update()
        return *self.arrays(filter.GetOutput()), (filter, surface)


class OurClip(VTKClipper):
    """surfacebooleans.vtk.vtkPolyDataClipClosedSurface."""

    def __init__(self):
        from surfacebooleans.vtk import vtkPolyDataClipClosedSurface

        self.filter_class = vtkPolyDataClipClosedSurface
        self.version = f"this tree, VTK {self.import_vtk()}"


class VTKClip(VTKClipper):
    """vtkClipClosedSurface: of the wheel on PyPI, or of ParaView's package, as the process finds VTK."""

    def __init__(self):
        self.version = self.import_vtk()
        from vtkmodules.vtkFiltersGeneral import vtkClipClosedSurface

        self.filter_class = vtkClipClosedSurface


class ManifoldClip(Contender):
    """manifold3d's trim_by_plane, in double precision."""

    def __init__(self):
        import manifold3d

        self.module = manifold3d
        self.version = package_version("manifold3d")

    def native(self, points, triangles):
        return points, triangles.astype(np.uint64)

    def update(self):
        solid = self.module.Manifold(self.module.Mesh64(*self.meshes[0]))
        for origin, normal in self.planes:
            length = np.linalg.norm(normal)
            solid = solid.trim_by_plane(tuple(np.asarray(normal) / length), float(np.dot(origin, normal) / length))
        mesh = solid.to_mesh64()
        return mesh.vert_properties[:, :3], mesh.tri_verts, (solid, mesh)


class TrimeshClip(Contender):
    """trimesh's slice_mesh_plane with caps."""

    def __init__(self):
        import trimesh

        self.module = trimesh
        self.version = package_version("trimesh")

    def update(self):
        mesh = self.module.Trimesh(*self.meshes[0], process=False, validate=False)
        for origin, normal in self.planes:
            mesh = self.module.intersections.slice_mesh_plane(mesh, normal, origin, cap=True, engine="earcut")
        return np.asarray(mesh.vertices), np.asarray(mesh.faces), mesh


class MeshLibClip(Contender):
    """meshlib's trimWithPlane, and its filling of plane contours; single precision."""

    def __init__(self):
        from meshlib import mrmeshnumpy, mrmeshpy

        self.module, self.numpy = mrmeshpy, mrmeshnumpy
        self.version = package_version("meshlib")

    def native(self, points, triangles):
        return triangles, points

    def update(self):
        mesh = self.numpy.meshFromFacesVerts(*self.meshes[0])
        for origin, normal in self.planes:
            parameters = self.module.TrimWithPlaneParams()
            length = float(np.linalg.norm(normal))
            direction = self.module.Vector3f(*(float(n) / length for n in normal))
            parameters.plane = self.module.Plane3f(direction, float(np.dot(origin, normal)) / length)
            self.module.trimWithPlane(mesh, parameters)
            self.module.fillContours2D(mesh, mesh.topology.findHoleRepresentiveEdges())
        mesh.pack()
        return self.numpy.getNumpyVerts(mesh), self.numpy.getNumpyFaces(mesh.topology), mesh


class TrueformClip(Trueform):
    """trueform has no clip: its intersection with a large block whose sides lie in the planes."""

    def prepare(self, operation, input, tool, planes):
        super().prepare("intersection", [*input, block(planes)], [])


def block(planes, size=10.0):
    """A box in front of up to three planes that are at right angles to each other, as a mesh."""
    from cases import box

    origin = np.asarray(planes[0][0])
    axes = [np.asarray(normal) / np.linalg.norm(normal) for _, normal in planes]
    while len(axes) < 3:
        other = np.eye(3)[np.argmin(np.abs(axes).sum(axis=0))]
        other = other - sum(np.dot(other, axis) * axis for axis in axes)
        axes.append(other / np.linalg.norm(other))
    axes = np.array(axes)
    points, triangles = box([0.0 if k < len(planes) else -size for k in range(3)], [size] * 3)
    return points @ axes + origin, triangles if np.linalg.det(axes) > 0 else triangles[:, ::-1].copy()


CLIPPERS = {
    "ours": OurClip,
    "vtk-packaged": VTKClip,
    "vtk": VTKClip,
    "manifold3d": ManifoldClip,
    "trimesh": TrimeshClip,
    "meshlib": MeshLibClip,
    "trueform": TrueformClip,
}
