# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The table of all filters, for claims that hold of each of them; a new one joins by its line in FILTERS."""

import functools
from dataclasses import dataclass, field

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPlane, vtkPolyData

import cad
import clouds
import meshes
from booleans import heard_from, polydata

ABORTED, OUT_OF_MEMORY = 9, 22


@dataclass(frozen=True)
class Filter:
    """A class, what to connect to its ports (names of INPUTS), and what makes it do all that it can."""

    class_name: str
    inputs: tuple
    settings: dict = field(default_factory=dict)
    proxy: str = ""  # where it is not the name in the table

    def make(self, scene="bodies", **settings):
        """A fresh filter with its inputs."""
        import surfacebooleans.vtk

        made = getattr(surfacebooleans.vtk, self.class_name)()
        for name, value in {**self.settings, **settings}.items():
            value = value() if callable(value) else value
            getattr(made, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
        for port, name in enumerate(self.inputs):
            made.SetInputDataObject(port, INPUTS[scene][name]())
        return made


def plane():
    made = vtkPlane()
    made.SetNormal(0.2, 0.3, 1)
    return made


ALL_DISTANCES = {
    f"Compute{what}": 1
    for what in ("SecondDistance", "CellCenterDistance", "NearestPoint", "NearestCellId", "Direction")
}
CLIP = {"UsePlane": 1, "Normal": (0.2, 0.3, 1), "GenerateOutline": 1, "PassPointData": 1, "ScalarMode": 1}

FILTERS = {
    "SurfaceBoolean": Filter("vtkPolyDataBooleanOperationFilter", ("body", "tool"), {"Operation": 2}),
    "SurfaceIntersection": Filter("vtkPolyDataIntersection", ("body", "tool")),
    "SurfaceDistance": Filter("vtkPolyDataDistance", ("body", "tool"), ALL_DISTANCES),
    "SurfaceDistanceField": Filter("vtkPolyDataDistanceField", ("body",), {"Dimensions": (24, 24, 24)}),
    "SurfaceCheck": Filter("vtkPolyDataSurfaceCheck", ("body",)),
    "ClosedSurfaceClip": Filter("vtkPolyDataClipClosedSurface", ("body",), CLIP),
    "ClosedSurfaceCut": Filter("vtkPolyDataCutClosedSurface", ("body",), {"Normal": (0.2, 0.3, 1)}),
    "ContourTriangulator": Filter("vtkPolyDataContourTriangulator", ("contours",)),
    "PointSetSurface": Filter("vtkPointSetSurfaceFilter", ("cloud",), {"GenerateSurface": 1}),
    "PointSetIntersection": Filter("vtkPointSetIntersectionFilter", ("cloud",), {"Plane": plane}),
    "PointSetIntersection, mesh": Filter("vtkPointSetIntersectionFilter", ("cloud", "near body"), proxy="PointSetIntersection"),
    "PointSetIntersection, CAD": Filter("vtkPointSetIntersectionFilter", ("cloud", "designed"), proxy="PointSetIntersection"),
    "PointSetBoolean": Filter("vtkPointSetBooleanFilter", ("cloud", "near body"), {"Operation": 2}),
    "PointSetBoolean, CAD": Filter("vtkPointSetBooleanFilter", ("cloud", "designed"), {"Operation": 2}, "PointSetBoolean"),
    "NURBSReader": Filter("vtkNURBSReader", (), {"FileName": f"{cad.SAMPLES}/step/screw.step", "ChordError": 2e-4}),
}


def kitten(every):
    points, normals = clouds.cgal_cloud("kitten.xyz")
    scale = 2.0 / np.linalg.norm(np.ptp(points, axis=0))
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    return clouds.cloud((points[::every] - middle) * scale, None if normals is None else normals[::every])


def with_arrays(data):
    """Point and cell arrays to be carried along."""
    for attributes, count in ((data.GetPointData(), data.GetNumberOfPoints()), (data.GetCellData(), data.GetNumberOfCells())):
        attributes.AddArray(named("Number", np.arange(count, dtype=float)))
        attributes.AddArray(named("Id", np.arange(count, dtype=np.int64)))
    return data


def named(name, values):
    from vtkmodules.util.numpy_support import numpy_to_vtk

    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    return array


def body(name, fineness, offset=(0.0, 0.0, 0.0)):
    made = meshes.cgal_mesh(name)
    for _ in range(fineness):
        made = meshes.split_in_four(made)
    return with_arrays(polydata(meshes.moved(made, offset)))


def sections(data):
    """Lines where a body is cut by a plane."""
    from surfacebooleans.vtk import vtkPolyDataClipClosedSurface

    clip = vtkPolyDataClipClosedSurface()
    clip.SetInputDataObject(data)
    clip.SetUsePlane(1)
    clip.SetNormal(0, 0, 1)
    clip.SetGenerateFaces(0)
    clip.SetGenerateOutline(1)
    clip.Update()
    return clip.GetOutputDataObject(1)


def designed():
    """A body with exact faces across the cloud."""
    import patches

    return patches.body([patches.torus(0.5, 0.2)])


# Scenes: shapes of which a filter makes short work, for claims that take very many updates; real data; and finer ones
# of these, on which a filter works for a while.
INPUTS = {
    scene: {name: functools.lru_cache(maxsize=None)(make) for name, make in inputs.items()}
    for scene, inputs in {
        "shapes": {
            "body": lambda: with_arrays(polydata(meshes.sphere(0.5, around=12, along=8))),
            "tool": lambda: with_arrays(polydata(meshes.cube(0.5, (0.3, 0.2, 0.1)))),
            "near body": lambda: polydata(meshes.cube(0.5, (0.3, 0.2, 0.1))),
            "contours": lambda: sections(polydata(meshes.cube())),
            "cloud": lambda: clouds.cloud(*clouds.sphere(400, 0.5)),
            "designed": designed,
        },
        "bodies": {
            "body": lambda: body("knot1", 0),
            "tool": lambda: body("fandisk", 0, (0.1, 0.05, 0.02)),
            "near body": lambda: body("fandisk", 0, (0.3, 0.05, 0.02)),
            "contours": lambda: sections(body("knot1", 1)),
            "cloud": lambda: kitten(3),
            "designed": designed,
        },
        "large": {
            "body": lambda: body("camel", 1),
            "tool": lambda: body("camel", 1, (0.01, 0.005, 0.002)),
            "near body": lambda: body("bull", 0, (0.3, 0.05, 0.02)),
            "contours": lambda: sections(body("camel", 2)),
            "cloud": lambda: kitten(1),
            "designed": designed,
        },
    }.items()
}


def outputs(made):
    return [made.GetOutputDataObject(port) for port in range(made.GetNumberOfOutputPorts())]


def run(made):
    """Update; what it said: errors, warnings."""
    return heard_from(made)


def field_value(data, name):
    return data.GetFieldData().GetAbstractArray(name).GetValue(0)


def status(made):
    return int(field_value(outputs(made)[0], "Status"))


def is_empty(made):
    """No point, cell or array of theirs in any output."""
    return all(
        data.GetNumberOfPoints() == data.GetNumberOfCells() == 0
        and data.GetPointData().GetNumberOfArrays() == data.GetCellData().GetNumberOfArrays() == 0
        for data in outputs(made)
    )


def content(made):
    """All points, cells and arrays of all outputs, but for the times in the field data."""
    parts = []
    for data in outputs(made):
        if isinstance(data, vtkPolyData):
            if data.GetNumberOfPoints():
                parts.append(("points", vtk_to_numpy(data.GetPoints().GetData())))
            for cells in (data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()):
                parts += [("cells", vtk_to_numpy(a)) for a in (cells.GetOffsetsArray(), cells.GetConnectivityArray())]
        for attributes in (data.GetPointData(), data.GetCellData(), data.GetFieldData()):
            for i in range(attributes.GetNumberOfArrays()):
                array = attributes.GetAbstractArray(i)
                if array.GetName() not in ("StageSeconds", "Message"):
                    values = vtk_to_numpy(array) if array.IsNumeric() else [array.GetValue(k) for k in range(array.GetNumberOfValues())]
                    parts.append((array.GetName(), np.asarray(values)))
    return [(name, values.dtype.str, values.shape, values.tobytes()) for name, values in parts]
