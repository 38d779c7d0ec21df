# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims about files: what is written can be read, also where VTK alone cannot; bad files are told in a sentence."""

import itertools

import numpy as np
import pytest
import surfacebooleans as sb
from surfacebooleans.appended_xml import has_appended_data
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLPolyDataWriter,
)

import booleans
import clouds
import meshes


@pytest.fixture(scope="module")
def surface():
    """A result with points of doubles, polygons of several sizes, point, cell and field arrays."""
    box = booleans.polydata(meshes.box((0, 0, 0), (2, 2, 2)), meshes.BOX_QUADS.tolist())
    box.ShallowCopy(sb.distance(box, booleans.polydata(meshes.sphere(0.9))))
    return sb.boolean(box, booleans.polydata(meshes.sphere(0.9, around=40, along=30)), "difference")


@pytest.fixture(scope="module")
def curves(surface):
    return sb.intersection(surface, booleans.polydata(meshes.cube(2.5)))


@pytest.mark.parametrize("suffix", [".vtk", ".vtp"])
def test_the_own_formats_keep_every_bit(surface, curves, suffix, tmp_path):
    for data in (surface, curves):
        sb.write(data, tmp_path / f"file{suffix}")
        again = sb.read(tmp_path / f"file{suffix}")
        assert booleans.bytes_of(again) == booleans.bytes_of(data)
        assert str(sb.fields_of(again)) == str(sb.fields_of(data))


@pytest.mark.parametrize("suffix, error", [(".stl", 1e-6), (".ply", 1e-6), (".obj", 0)])
def test_other_formats_keep_a_closed_surface_closed(surface, suffix, error, tmp_path):
    sb.write(surface, tmp_path / f"file{suffix}")
    measured, expected = sb.measure(sb.read(tmp_path / f"file{suffix}")), sb.measure(surface)
    assert measured["closed"] and measured["volume"] == pytest.approx(expected["volume"], rel=error, abs=error / 1e3)


def test_obj_holds_curves(curves, tmp_path):
    sb.write(curves, tmp_path / "curves.obj")
    again = sb.read(tmp_path / "curves.obj")
    assert booleans.cells_of(again.GetLines())[1].tolist() == booleans.cells_of(curves.GetLines())[1].tolist()


def test_an_image_is_read_again(surface, tmp_path):
    image = sb.distance_field(surface, dimensions=(7, 8, 9))
    for suffix in (".vti", ".vtk"):
        sb.write(image, tmp_path / f"field{suffix}")
        again = sb.read(tmp_path / f"field{suffix}")
        assert again.GetDimensions() == (7, 8, 9) and again.GetScalarRange() == image.GetScalarRange()


# ---- appended data -----------------------------------------------------------------------------

APPENDED = 2


def write_appended(data, path, encoded, compressor, header, writer=vtkXMLPolyDataWriter):
    writer = writer()
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    writer.SetDataMode(APPENDED)
    writer.SetEncodeAppendedData(encoded)
    getattr(writer, f"SetCompressorTypeTo{compressor}")()
    getattr(writer, f"SetHeaderTypeTo{header}")()
    writer.SetBlockSize(4096)  # several blocks an array
    writer.Write()


@pytest.mark.parametrize(
    "encoded, compressor, header",
    itertools.product((0, 1), ("None", "ZLib", "LZ4", "LZMA"), ("UInt32", "UInt64")),
)
def test_appended_data_are_read_however_they_are_packed(surface, encoded, compressor, header, tmp_path):
    write_appended(surface, tmp_path / "file.vtp", encoded, compressor, header)
    assert has_appended_data(tmp_path / "file.vtp")
    again = sb.read(tmp_path / "file.vtp")
    assert booleans.bytes_of(again) == booleans.bytes_of(surface)
    assert str(sb.fields_of(again)) == str(sb.fields_of(surface))


def test_appended_grids_and_images_are_read(surface, tmp_path):
    image = sb.distance_field(surface, dimensions=(7, 8, 9))
    write_appended(image, tmp_path / "file.vti", 0, "ZLib", "UInt32", vtkXMLImageDataWriter)
    assert sb.read(tmp_path / "file.vti").GetScalarRange() == image.GetScalarRange()


def test_a_file_that_ends_within_its_appended_data_is_told(surface, tmp_path):
    for encoded, compressor in itertools.product((0, 1), ("None", "ZLib")):
        write_appended(surface, tmp_path / "file.vtp", encoded, compressor, "UInt32")
        content = (tmp_path / "file.vtp").read_bytes()
        (tmp_path / "file.vtp").write_bytes(content[: len(content) * 2 // 3])
        with pytest.raises(sb.FileError, match="file.vtp: the file ends within its data"):
            sb.read(tmp_path / "file.vtp")


# ---- CAD files ---------------------------------------------------------------------------------

SCREW = "/usr/share/opencascade/data/step/screw.step"  # Debian: occt-misc


def test_a_cad_file_is_read_with_its_exact_surfaces():
    coarse, fine = sb.read(SCREW), sb.read_nurbs(SCREW, chord_error=1e-4)
    assert sb.measure(coarse)["closed"] and sb.measure(fine)["closed"]
    assert fine.GetNumberOfCells() > 2 * coarse.GetNumberOfCells()
    assert sb.fields_of(fine)["ChordError"] < sb.fields_of(coarse)["ChordError"]
    assert fine.GetFieldData().GetArray("NURBSPoles").GetNumberOfTuples() > 0


def test_exact_surfaces_are_written_again(tmp_path):
    screw = sb.read(SCREW)
    sb.write(screw, tmp_path / "screw.step")
    again = sb.read(tmp_path / "screw.step")
    assert sb.measure(again)["closed"] and sb.measure(again)["volume"] == pytest.approx(
        sb.measure(screw)["volume"], rel=3e-3
    )
    with pytest.raises(sb.FileError, match="cube.step: "):
        sb.write(booleans.polydata(meshes.cube()), tmp_path / "cube.step")


def test_what_is_no_cad_file_is_told(tmp_path):
    with pytest.raises(sb.FileError, match="CAD files end in .iges"):
        sb.read_nurbs(tmp_path / "file.stl")


# ---- lists of points ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name, text",
    [
        ("a.xyz", "0 0 0\n1 2 3\n"),
        ("a.xyz", "# a comment\n\n0 0 0\n  1\t2 3  \n"),
        ("a.pts", "2\n0 0 0\n1 2 3\n"),
        ("a.csv", "x,y,z\n0,0,0\n1,2,3\n"),
        ("a.CSV", "0, 0, 0\n1, 2, 3\n"),
        ("a.txt", "X Y Z intensity\n0 0 0 7\n1 2 3 8\n"),
        ("a.pwn", "2\n0 0 0 0 0 1\n1 2 3 1 0 0\n"),
    ],
)
def test_lists_of_points(name, text, tmp_path):
    (tmp_path / name).write_text(text)
    cloud = sb.read(tmp_path / name)
    assert booleans.points_of(cloud).tolist() == [[0, 0, 0], [1, 2, 3]]
    assert (cloud.GetPointData().GetNormals() is not None) == (name == "a.pwn")


def test_a_scan_of_cgal_is_read_with_its_normals(tmp_path):
    points, normals = clouds.cgal_cloud("kitten.xyz")
    np.savetxt(tmp_path / "kitten.xyz", np.hstack([points, normals]), fmt="%.17g")
    assert np.array_equal(booleans.points_of(sb.read(tmp_path / "kitten.xyz")), points)


# ---- what cannot be read or written ------------------------------------------------------------


@pytest.mark.parametrize("name", ["none.stl", "none", ".", "file.unknown", "empty.stl"])
def test_what_cannot_be_read_is_told_with_its_name(name, tmp_path):
    (tmp_path / "file.unknown").write_text("?")
    (tmp_path / "empty.stl").write_text("")
    with pytest.raises(sb.FileError) as caught:
        sb.read(tmp_path / name)
    assert str(tmp_path) in str(caught.value) and "\n" not in str(caught.value)


SUFFIXES = [
    ".vtk",
    ".vtp",
    ".vtu",
    ".vti",
    ".vts",
    ".vtr",
    ".stl",
    ".ply",
    ".obj",
    ".xyz",
    ".csv",
    ".gltf",
    ".glb",
    ".g",
    ".step",
    ".iges",
]


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize(
    "content", [b"nonsense\n", b"\x00\xff" * 300, b"<?xml version='1.0'?><VTKFile"], ids=["text", "bytes", "xml"]
)
def test_nonsense_is_an_error_whatever_its_name(suffix, content, tmp_path):
    (tmp_path / f"file{suffix}").write_bytes(content)
    with pytest.raises(sb.FileError, match=f"file{suffix}: "):
        sb.read(tmp_path / f"file{suffix}")


@pytest.mark.parametrize(
    "name, words",
    [
        ("no/such/folder.stl", "cannot be written: No such file or directory"),
        ("file.unknown", r"the format .unknown cannot be written; these can: .obj .ply"),
        ("file", "without an ending"),
        ("file.vti", "holds images only"),
    ],
)
def test_what_cannot_be_written_is_told(surface, name, words, tmp_path):
    with pytest.raises(sb.FileError, match=words):
        sb.write(surface, tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_curves_and_images_do_not_go_into_a_surface_file(surface, curves, tmp_path):
    with pytest.raises(sb.FileError, match="surfaces only"):
        sb.write(curves, tmp_path / "file.stl")
    with pytest.raises(sb.FileError, match="no images; choose .vti"):
        sb.write(sb.distance_field(surface, dimensions=(3, 3, 3)), tmp_path / "file.ply")


def test_a_file_is_replaced_as_a_whole_or_not_at_all(surface, curves, tmp_path):
    path = tmp_path / "file.stl"
    sb.write(surface, path)
    before = path.read_bytes()
    with pytest.raises(sb.FileError):
        sb.write(curves, path)
    assert path.read_bytes() == before and list(tmp_path.iterdir()) == [path]


def test_meshio_is_named_where_it_would_help(tmp_path):
    (tmp_path / "file.msh").write_text("?")
    with pytest.raises(sb.FileError, match="meshio"):
        sb.read(tmp_path / "file.msh")
