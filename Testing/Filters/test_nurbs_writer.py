# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exact surfaces written back as STEP: the same solids when read again; also cut, moved, mirrored, mixed; not bent."""

from dataclasses import dataclass, field

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet, vtkPlane, vtkPlaneCollection
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkThreshold
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

import cad
import cloud_booleans
import clouds
import measures
import step_files
from booleans import heard_from_call, points_of
from cloud_booleans import DIFFERENCE, INTERSECTION, OPERATIONS, REVERSE_DIFFERENCE, UNION
from distances import cloud, distance_filter

cad.needs_cad()


@dataclass
class Written:
    faces: int
    solids: int
    shells: int
    failed: bool
    errors: list = field(default_factory=list)
    warnings: list = field(default_factory=list)


def write(data, path):
    from surfacebooleans.vtk import vtkNURBSWriter

    writer = vtkNURBSWriter()
    writer.SetFileName(str(path))
    writer.SetInputDataObject(0, data)
    errors, warnings = heard_from_call(writer, writer.Write)
    return Written(
        writer.GetNumberOfFaces(),
        writer.GetNumberOfSolids(),
        writer.GetNumberOfOpenShells(),
        writer.GetErrorCode() != 0,
        errors,
        warnings,
    )


def made(tmp_path, shape, *sizes):
    step = step_files.StepFile()
    step.product(getattr(step_files, shape)(step, *sizes))
    return step.write(tmp_path / f"{shape}.step")


def written_and_read(data, tmp_path, **settings):
    path = tmp_path / "written.step"
    said = write(data, path)
    assert not said.failed and said.errors == [], said
    return said, cad.read(path, **settings)


SOLIDS = [("cylinder", 2.0, 5.0), ("sphere", 3.0), ("hollow_sphere", 3.0, 1.5), ("torus", 4.0, 1.0)]


@pytest.mark.parametrize("shape", SOLIDS, ids=lambda s: s[0])
def test_solids_come_back(tmp_path, shape):
    bound = 1e-3
    first = cad.read(made(tmp_path, *shape), ChordError=bound)
    said, again = written_and_read(first.data, tmp_path, ChordError=bound)
    assert said.warnings == [] and (said.solids, said.shells) == (1, 0)
    assert again.status == 0 and again.number("Closed") == 1 and measures.open_edges(again.body) == 0
    assert said.faces == first.number("NumberOfFaces") == again.number("NumberOfFaces")
    # The patches are the same to the bit but for the digits of the file, whatever the order of the faces.
    for name in ("NURBSPoles", "NURBSKnots"):
        one, two = (np.sort(r.field_data[name].ravel()) for r in (first, again))
        assert one == pytest.approx(two, abs=1e-12)
    # Trimming curves are closer to the true edge than facets are.
    size = np.linalg.norm(first.body.points.max(axis=0) - first.body.points.min(axis=0))
    assert again.number("Gap") < 0.05 * bound * size
    assert measures.volume(again.body) == pytest.approx(measures.volume(first.body), rel=4e-3)
    assert measures.area(again.body) == pytest.approx(measures.area(first.body), rel=4e-3)


@pytest.mark.parametrize("name, faces", [("step/screw.step", 10), ("step/linkrods.step", 37), ("iges/hammer.iges", 45)])
def test_real_solids_come_back(tmp_path, name, faces):
    first = cad.read(f"{cad.SAMPLES}/{name}")
    said, again = written_and_read(first.data, tmp_path)
    assert (said.faces, said.solids, said.shells) == (faces, 1, 0) and said.warnings == []
    assert again.number("NumberOfFaces") == faces and again.number("NumberOfSolids") == 1
    assert again.number("Closed") == 1 and measures.open_edges(again.body) == 0
    assert measures.volume(again.body) == pytest.approx(measures.volume(first.body), rel=2e-3)
    assert measures.area(again.body) == pytest.approx(measures.area(first.body), rel=1e-3)


def clipped(data, origin, normal):
    from surfacebooleans.vtk import vtkPolyDataClipClosedSurface

    plane, planes = vtkPlane(), vtkPlaneCollection()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    planes.AddItem(plane)
    clip = vtkPolyDataClipClosedSurface()
    clip.SetInputDataObject(0, data)
    clip.SetClippingPlanes(planes)
    clip.SetPassPointData(True)
    clip.Update()
    result = vtkPolyData()
    result.ShallowCopy(clip.GetOutput())
    result.GetFieldData().PassData(data.GetFieldData())
    return result


def test_a_cut_solid_keeps_its_exact_faces(tmp_path):
    """Half of a cylinder: its side and one lid, trimmed; the cap, which is on no patch, is left out."""
    first = cad.read(made(tmp_path, "cylinder", 2.0, 6.0))
    half = clipped(first.data, (0, 0, 2), (0, 0, 1))
    said, again = written_and_read(half, tmp_path, ChordError=2.5e-4)
    assert len(said.warnings) == 1 and "no exact surface" in said.warnings[0]
    assert (said.faces, said.solids, said.shells) == (2, 0, 1)
    assert again.status == 2 and again.number("NumberOfFaces") == 2
    assert measures.area(again.body) == pytest.approx(np.pi * 2**2 + 2 * np.pi * 2 * 4, rel=2e-3)
    assert again.body.points[:, 2].min() == pytest.approx(2, abs=0.01)
    radius = np.hypot(again.body.points[:, 0], again.body.points[:, 1])
    assert radius.max() == pytest.approx(2, abs=2e-3)


def test_a_face_cut_in_two_is_two_faces(tmp_path):
    """The middle of a sphere taken out: of its one patch two caps are left."""
    first = cad.read(made(tmp_path, "sphere", 3.0), ChordError=5e-4)
    z = first.body.points[first.body.triangles][:, :, 2]
    caps = taken(first.data, np.abs(z).min(axis=1) > 1.5)
    said, again = written_and_read(caps, tmp_path, ChordError=5e-4)
    assert (said.faces, said.solids, said.shells) == (2, 0, 2)
    assert again.number("NumberOfFaces") == 2
    assert measures.area(again.body) == pytest.approx(measures.area(cad.plain(caps).body), rel=5e-3)


def test_what_a_boolean_leaves_is_written(tmp_path):
    """Connecting rods with a ball of facets taken out: the rods' faces, some of them cut in two, in two parts."""
    from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter

    first = cad.read(f"{cad.SAMPLES}/step/linkrods.step", ChordError=5e-4)
    ball = vtkSphereSource()
    ball.SetCenter(first.data.GetCenter())
    ball.SetThetaResolution(64)
    ball.SetPhiResolution(64)
    ball.SetRadius(1.0)
    boolean = vtkPolyDataBooleanOperationFilter()
    boolean.SetOperationToDifference()
    boolean.SetInputDataObject(0, first.data)
    boolean.SetInputConnection(1, ball.GetOutputPort())
    boolean.Update()
    left = cad.plain(boolean.GetOutput())
    face = left.cell_data["FaceId"]
    assert np.array_equal(face == -1, left.cell_data["SourceId"] == 1)
    said, again = written_and_read(left.data, tmp_path, ChordError=5e-4)
    assert (said.faces, said.solids, said.shells) == (46, 0, 2)
    kept = type(left.body)(left.body.points, left.body.triangles[face >= 0])
    assert measures.area(again.body) == pytest.approx(measures.area(kept), rel=1e-3)


def check_that_a_scan_left(tmp_path, result):
    """The faces of the body, trimmed at the seam: an open shell, as what the scan closes has no exact surface."""
    assert not result.errors
    said, again = written_and_read(result.surface, tmp_path, ChordError=5e-4)
    of_scan = int(np.count_nonzero(result.cell_data["FaceId"] < 0))
    assert len(said.warnings) == (1 if of_scan else 0) and all(str(of_scan) in text for text in said.warnings)
    left = type(result.body)(result.body.points, result.body.triangles[result.cell_data["FaceId"] >= 0])
    assert measures.area(again.body) == pytest.approx(measures.area(left), rel=4e-3)
    spacing = result.number("Spacing")
    assert again.number("Gap") < 0.03 * spacing
    # The written faces reach to the seam and not beyond it.
    both = distance_filter(cloud(points_of(result.curves)), again.body, SignedDistance=False)
    assert vtk_to_numpy(both.GetOutput().GetPointData().GetArray("Distance")).max() < 0.05 * spacing
    beyond = distance_filter(cloud(again.body.points), left, SignedDistance=False)
    assert vtk_to_numpy(beyond.GetOutput().GetPointData().GetArray("Distance")).max() < 0.15 * spacing
    return said


@pytest.mark.parametrize(
    "operation, faces, shells", [(UNION, 10, 1), (INTERSECTION, 5, 2), (DIFFERENCE, 5, 2), (REVERSE_DIFFERENCE, 10, 1)]
)
def test_what_a_point_set_boolean_leaves_is_written(tmp_path, operation, faces, shells):
    """The demo's cat and screw: all ten faces, three of them closed around, or those in the cat."""
    screw = cad.read(f"{cad.SAMPLES}/step/screw.step").data
    placed, _ = moved(screw, ("Translate", 0.7607, -0.74, -0.0356), ("RotateX", -90), ("Scale", 0.0425, 0.0425, 0.0425))
    result = cloud_booleans.run(clouds.cloud(*clouds.cgal_cloud("kitten.xyz")), placed, operation)
    said = check_that_a_scan_left(tmp_path, result)
    assert (said.faces, said.solids, said.shells) == (faces, 0, shells)


# The seam of a cylinder, a pole and both seams of a ring are where the scan's surface is, or near it.
ACROSS = [
    (("cylinder", 0.5, 1.6), (0.3, 0.1, -0.9)),
    (("sphere", 0.6), (-0.8, 0.1, 0.05)),
    (("sphere", 0.6), (0.9, 0.05, 0.1)),
    (("torus", 0.6, 0.25), (-0.5, 0.1, 0.6)),
]


@pytest.mark.parametrize("operation", OPERATIONS)
@pytest.mark.parametrize("shape, at", ACROSS, ids=lambda value: value[0] if isinstance(value[0], str) else "")
def test_faces_are_trimmed_across_their_own_seams(tmp_path, shape, at, operation):
    placed, _ = moved(cad.read(made(tmp_path, *shape)).data, ("Translate", *at))
    check_that_a_scan_left(tmp_path, cloud_booleans.run(cloud_booleans.ball_cloud(8000), placed, operation))


def test_facets_that_overlap_in_their_parameters_are_left_out(tmp_path):
    """A cylinder whose wall is joined at its seam: the facets there lie across all others."""
    first = cad.read(made(tmp_path, "cylinder", 2.0, 5.0))
    joined = vtkPolyData()
    joined.DeepCopy(first.data)
    uv = vtk_to_numpy(joined.GetPointData().GetArray("UV"))
    wall = np.unique(first.body.triangles[first.cell_data["FaceId"] == wall_of(first)])
    uv[wall[uv[wall, 0] == uv[wall, 0].max()], 0] = uv[wall, 0].min()
    said, again = written_and_read(joined, tmp_path)
    assert len(said.warnings) == 1 and "1 exact surface" in said.warnings[0] and "u and v" in said.warnings[0]
    assert (said.faces, said.solids) == (2, 0) and again.number("NumberOfFaces") == 2
    alone = taken(joined, first.cell_data["FaceId"] == wall_of(first))
    said = write(alone, tmp_path / "alone.step")
    assert said.failed and len(said.errors) == 1 and "u and v" in said.errors[0]


HOLES = {
    "across the middle line": lambda x: x[:, :, 0].min(axis=1) < -2.5,
    "in one half": lambda x: x[:, :, 1].min(axis=1) < -2.5,
    "one in each half": lambda x: np.abs(x[:, :, 1]).max(axis=1) > 2.5,
}


@pytest.mark.parametrize("name", HOLES)
@pytest.mark.parametrize("turn", [(0, 0, 0, 1), (50, 1, 2, 3)])
def test_a_sphere_with_holes_becomes_two_faces(tmp_path, name, turn):
    """A STEP file has no border for all of a sphere: as one face it would come back as what was taken out of it."""
    first = cad.read(made(tmp_path, "sphere", 3.0), ChordError=5e-4)
    chosen = ~HOLES[name](first.body.points[first.body.triangles])
    left, _ = moved(taken(first.data, chosen), ("RotateWXYZ", *turn))
    said, again = written_and_read(left, tmp_path, ChordError=5e-4)
    assert (said.faces, said.solids, said.shells, said.warnings) == (2, 0, 1, [])
    kept = type(first.body)(first.body.points, first.body.triangles[chosen])
    assert measures.area(again.body) == pytest.approx(measures.area(kept), rel=4e-3)
    assert again.number("Gap") < 0.02 and np.linalg.norm(again.body.points, axis=1) == pytest.approx(3, abs=0.02)


def wall_of(read):
    return np.bincount(read.cell_data["FaceId"]).argmax()


def taken(data, chosen):
    """These cells, as Threshold and Extract Surface give them."""
    copy = vtkPolyData()
    copy.ShallowCopy(data)
    array = numpy_to_vtk(chosen.astype(float), deep=True)
    array.SetName("Chosen")
    copy.GetCellData().AddArray(array)
    threshold = vtkThreshold()
    threshold.SetInputDataObject(0, copy)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "Chosen")
    threshold.SetUpperThreshold(0.5)
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(threshold.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def test_chosen_faces_are_written_alone(tmp_path):
    first = cad.read(f"{cad.SAMPLES}/step/screw.step")
    chosen = np.isin(first.cell_data["FaceId"], [1, 3, 7])
    said, again = written_and_read(taken(first.data, chosen), tmp_path)
    assert said.faces == 3 == again.number("NumberOfFaces") and said.solids == 0
    assert measures.area(again.body) == pytest.approx(measures.area(cad.plain(taken(first.data, chosen)).body), rel=4e-3)


def moved(data, *steps):
    transform = vtkTransform()
    for name, *numbers in steps:
        getattr(transform, name)(*numbers)
    mover = vtkTransformPolyDataFilter()
    mover.SetInputDataObject(0, data)
    mover.SetTransform(transform)
    mover.Update()
    return mover.GetOutput(), transform


MOVES = {
    "turned": [("Translate", 5, -3, 2), ("RotateWXYZ", 40, 1, 2, 3)],
    "scaled": [("Scale", 2.0, 2.0, 2.0)],
    "stretched": [("RotateX", 30), ("Scale", 1.0, 2.0, 0.5)],
    "mirrored": [("Scale", -1.0, 1.0, 1.0)],
}


@pytest.mark.parametrize("name", MOVES)
def test_patches_follow_moved_facets(tmp_path, name):
    """Written where the facets are: the file has only the patches, which the filter that moved points left alone."""
    first = cad.read(f"{cad.SAMPLES}/step/screw.step")
    data, transform = moved(first.data, *MOVES[name])
    said, again = written_and_read(data, tmp_path)
    assert said.warnings == [] and (said.faces, said.solids) == (10, 1)
    m = np.array([[transform.GetMatrix().GetElement(i, j) for j in range(4)] for i in range(4)])
    wanted = measures.volume(first.body) * abs(np.linalg.det(m[:3, :3]))
    # A mirrored solid is a solid: it is turned over, and its volume stays positive.
    assert measures.volume(again.body) == pytest.approx(wanted, rel=3e-3)
    poles = first.field_data["NURBSPoles"]
    expected = np.sort((poles[:, :3] @ m[:3, :3].T + m[:3, 3]).ravel())
    size = np.abs(expected).max()
    assert np.sort(again.field_data["NURBSPoles"][:, :3].ravel()) == pytest.approx(expected, abs=1e-11 * size)


def test_bent_facets_are_not_written(tmp_path):
    first = cad.read(f"{cad.SAMPLES}/step/screw.step")
    points = points_of(first.data).copy()
    points[:, 2] += 0.01 * points[:, 0] ** 2
    bent = vtkPolyData()
    bent.DeepCopy(first.data)
    bent.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    said = write(bent, tmp_path / "bent.step")
    assert said.failed and len(said.errors) == 1 and "bend" in said.errors[0]
    assert not (tmp_path / "bent.step").exists()


def test_several_bodies_in_a_group(tmp_path):
    """Each with patches of its own, one of them moved, one without any."""
    cylinder = cad.read(made(tmp_path, "cylinder", 2.0, 5.0)).data
    ball, _ = moved(cad.read(made(tmp_path, "sphere", 3.0)).data, ("Translate", 20, 0, 0))
    plain = vtkPolyData()
    plain.SetPoints(cylinder.GetPoints())
    plain.SetPolys(cylinder.GetPolys())
    group = vtkMultiBlockDataSet()
    for k, data in enumerate((cylinder, ball, plain)):
        group.SetBlock(k, data)
    said, again = written_and_read(group, tmp_path)
    assert (said.faces, said.solids) == (4, 2) and again.number("NumberOfSolids") == 2
    assert str(plain.GetNumberOfCells()) in said.warnings[0]
    assert again.body.points[:, 0].max() == pytest.approx(23, abs=0.05)


def without(data, attributes, name):
    copy = vtkPolyData()
    copy.DeepCopy(data)
    getattr(copy, f"Get{attributes}Data")().RemoveArray(name)
    return copy


def without_fields(data):
    copy = vtkPolyData()
    copy.ShallowCopy(data)
    copy.GetFieldData().Initialize()
    return copy


def shortened(data):
    copy = vtkPolyData()
    copy.DeepCopy(data)
    copy.GetFieldData().GetArray("NURBSKnots").SetNumberOfTuples(10)
    return copy


def merged(data):
    clean = vtkCleanPolyData()
    clean.SetInputDataObject(0, data)
    clean.Update()
    return clean.GetOutput()


@pytest.mark.parametrize(
    "spoil, word",
    [
        (lambda d: without(d, "Point", "UV"), "UV"),
        (lambda d: without(d, "Cell", "FaceId"), "FaceId"),
        (lambda d: without(d, "Field", "NURBSKnots"), "NURBSKnots"),
        (without_fields, "CAD file"),
        (shortened, "cut off"),
        (merged, "share points"),
        (lambda _: vtkTable(), "vtkTable"),
    ],
)
def test_what_has_no_exact_surfaces_is_refused_in_one_sentence(tmp_path, spoil, word):
    first = cad.read(made(tmp_path, "cylinder", 2.0, 5.0))
    said = write(spoil(first.data), tmp_path / "refused.step")
    assert said.failed and len(said.errors) == 1 and word in said.errors[0]
    assert not (tmp_path / "refused.step").exists()


def test_a_folder_that_is_not_there(tmp_path):
    first = cad.read(made(tmp_path, "cylinder", 2.0, 5.0))
    said = write(first.data, tmp_path / "absent" / "x.step")
    assert said.failed and "cannot be written" in said.errors[0]


def test_it_can_be_stopped_at_any_moment(tmp_path):
    """There is then no file, or, if the word came too late, the whole one; and the next one is as ever."""
    from surfacebooleans.vtk import vtkNURBSWriter

    path = tmp_path / "stopped.step"
    writer = vtkNURBSWriter()
    writer.SetFileName(str(path))
    writer.SetInputDataObject(0, cad.read(f"{cad.SAMPLES}/iges/hammer.iges").data)
    heard = []
    writer.AddObserver("ProgressEvent", lambda *_: heard.append(writer.GetProgress()))
    writer.Write()
    words, whole = len(heard), writer.GetNumberOfFaces()
    stopped = 0
    for at in sorted({1, 2, words // 3, words // 2, words - 1}):
        path.unlink()
        heard.clear()
        observer = writer.AddObserver("ProgressEvent", lambda *_: len(heard) == at and writer.SetAbortExecute(1))
        errors, _ = heard_from_call(writer, writer.Write)
        writer.RemoveObserver(observer)
        writer.SetAbortExecute(0)
        assert not errors
        assert [file.name for file in tmp_path.iterdir()] in ([], [path.name])
        stopped += not path.exists()
        writer.Write()
        assert writer.GetNumberOfFaces() == whole and cad.read(path).field_data["NumberOfFaces"][0] == whole
    assert stopped > 0


@pytest.mark.parametrize("name", ["", " ", "/", "/no/such/folder/x.step", "\n", "ä" * 5000, "%s%n"])
def test_any_name_is_a_file_or_a_sentence(tmp_path, name, monkeypatch):
    monkeypatch.chdir(tmp_path)
    said = write(cad.read(made(tmp_path, "cylinder", 2.0, 5.0)).data, name)
    assert len(said.errors) == (1 if said.failed else 0)
    assert said.failed or (tmp_path / name).exists()


def test_cells_that_end_nowhere_are_told(tmp_path):
    data = cad.read(made(tmp_path, "cylinder", 2.0, 5.0)).data
    vtk_to_numpy(data.GetPolys().GetOffsetsArray())[7] = 2**30
    said = write(data, tmp_path / "refused.step")
    assert said.failed and len(said.errors) == 1 and "damaged" in said.errors[0]
