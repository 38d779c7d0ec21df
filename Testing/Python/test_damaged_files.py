# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims about damaged files: read ends in a surface or a sentence, and so do the filters with what was read."""

import os
import random
import struct
import warnings

import numpy as np
import pytest
import surfacebooleans as sb
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import booleans
import meshes
from every_filter import with_arrays
from processes import in_another_process

ASCII, BINARY = 1, 2  # file types of VTK's writers
WRITTEN = {
    "text.stl": (vtkSTLWriter, {"FileType": ASCII}),
    "bytes.stl": (vtkSTLWriter, {"FileType": BINARY}),
    "text.ply": (vtkPLYWriter, {"FileType": ASCII}),
    "bytes.ply": (vtkPLYWriter, {"FileType": BINARY}),
    "text.vtk": (vtkPolyDataWriter, {"FileType": ASCII}),
    "bytes.vtk": (vtkPolyDataWriter, {"FileType": BINARY}),
    "text.vtp": (vtkXMLPolyDataWriter, {"DataMode": 0}),
    "inline.vtp": (vtkXMLPolyDataWriter, {"DataMode": 1}),
    "appended.vtp": (vtkXMLPolyDataWriter, {"DataMode": 2}),
    "text.obj": None,
}
DAMAGES = 24  # of each


@pytest.fixture(scope="module")
def body():
    return with_arrays(booleans.polydata(meshes.sphere(0.5, around=12, along=8)))


def written(body, name, folder):
    """The file's content."""
    path = folder / name
    if WRITTEN[name] is None:
        sb.write(body, path)
        return path.read_bytes()
    writer, settings = WRITTEN[name][0](), WRITTEN[name][1]
    for key, value in settings.items():
        getattr(writer, "Set" + key)(value)
    writer.SetInputData(body)
    writer.SetFileName(str(path))
    writer.Write()
    return path.read_bytes()


def damaged(content, rng):
    """Cut off, with a hole, with other bytes somewhere or in the head, or with another number in it."""
    how, data = rng.choice(("cut", "hole", "bytes", "head", "number")), bytearray(content)
    if how == "cut":
        del data[rng.randrange(len(data)) :]
    elif how == "hole":
        begin = rng.randrange(len(data))
        del data[begin : begin + rng.randrange(1, 400)]
    elif how == "number":
        at = rng.choice([i for i, byte in enumerate(data[:3000]) if chr(byte).isdigit()])
        data[at : at + 1] = rng.choice((b"9", b"0", b"-1", b"99999999", b"123456789012", b"1e999", b"nan"))
    else:
        for _ in range(rng.choice((1, 3, 20))):
            data[rng.randrange(len(data) if how == "bytes" else 400)] = rng.randrange(256)
    return bytes(data)


def outcome(path, other):
    """Sentences of reading, or else of checking and subtracting; none where there are results."""
    warnings.simplefilter("ignore")
    try:
        data = sb.read(path)
    except sb.FileError as error:
        return [str(error)]
    sentences = []
    for work in (lambda: sb.check(data), lambda: sb.boolean(data, other, "difference")):
        try:
            work()
        except sb.SurfaceBooleansError as error:
            sentences.append(str(error))
    return sentences


@pytest.mark.parametrize("name", WRITTEN)
def test_damage_is_told_in_a_sentence_or_does_no_harm(name, body, tmp_path):
    content, rng = written(body, name, tmp_path), random.Random(name)
    told = 0
    for k in range(DAMAGES):
        path = tmp_path / f"{k}{os.path.splitext(name)[1]}"
        path.write_bytes(damaged(content, rng))
        sentences = in_another_process(lambda: outcome(path, body))
        assert sentences is not None, f"crashed: damage {k}"
        assert all("\n" not in sentence and len(sentence) < 500 for sentence in sentences)
        told += bool(sentences)
    assert told > DAMAGES // 8


# ---- PLY, of which the reader is our own ------------------------------------------------------------

HEAD = "ply\nformat {} 1.0\ncomment none\n{}end_header\n"
VERTEX = "element vertex 4\nproperty {0} x\nproperty {0} y\nproperty {0} z\n"
COLOURS = "property uchar red\nproperty uchar green\nproperty uchar blue\n"
FACE = "element face 2\nproperty uchar quality\nproperty list {} {} {}\n"
POINTS = [(0, 0, 0), (1.5, 0, 0), (1, 1, 0.25), (0, 1, 0)]
FACES = [(0, 1, 2, 3), (3, 1, 0)]


def as_text():
    head = HEAD.format("ascii", VERTEX.format("double") + COLOURS + FACE.format("int", "uint", "vertex_indices"))
    lines = [" ".join(map(str, (*point, 7, 8, 9))) for point in POINTS]
    lines += [" ".join(map(str, (5, len(face), *face))) for face in FACES]
    return (head + "\n".join(lines) + "\n").encode()


def as_bytes(name, order):
    head = HEAD.format(name, VERTEX.format("float") + COLOURS + FACE.format("uchar", "short", "vertex_index"))
    data = b"".join(struct.pack(order + "3f3B", *point, 7, 8, 9) for point in POINTS)
    data += b"".join(struct.pack(f"{order}BB{len(face)}h", 5, len(face), *face) for face in FACES)
    return head.encode() + data


@pytest.mark.parametrize(
    "content",
    [as_text(), as_bytes("binary_little_endian", "<"), as_bytes("binary_big_endian", ">"), as_text().replace(b"\n", b"\r\n")],
    ids=["text", "little", "big", "lines end as on Windows"],
)
def test_ply_of_any_kind(content, tmp_path):
    path = tmp_path / "file.ply"
    path.write_bytes(content)
    data = sb.read(path)
    assert booleans.points_of(data).tolist() == [list(map(float, point)) for point in POINTS]
    offsets, ids = booleans.cells_of(data.GetPolys())
    assert [tuple(ids[a:b]) for a, b in zip(offsets[:-1], offsets[1:])] == FACES
    assert vtk_to_numpy(data.GetPointData().GetArray("RGB")).tolist() == [[7, 8, 9]] * 4


@pytest.mark.parametrize("name", ["text.ply", "bytes.ply"])
def test_ply_is_what_vtk_reads(name, body, tmp_path):
    written(body, name, tmp_path)
    theirs = vtkPLYReader()
    theirs.SetFileName(str(tmp_path / name))
    theirs.Update()
    ours, theirs = sb.read(tmp_path / name), theirs.GetOutput()
    assert np.array_equal(booleans.points_of(ours), booleans.points_of(theirs))
    assert all(np.array_equal(a, b) for a, b in zip(booleans.cells_of(ours.GetPolys()), booleans.cells_of(theirs.GetPolys())))


@pytest.mark.parametrize(
    "old, new, words",
    [
        (b"element vertex 4", b"element vertex 4000000000", "ends before"),
        (b"element vertex 4", b"element vertex -4", "which says nothing"),
        (b"4 0 1 2 3", b"4 0 1 2 9", "face 0 has a corner 9"),
        (b"4 0 1 2 3", b"400 0 1 2 3", "ends before"),
        (b"format ascii", b"format braille", "how the data are written"),
        (b"property double z", b"property double q", "no x, y and z"),
        (b"property double z", b"property complex z", "which says nothing"),
    ],
)
def test_what_is_wrong_with_a_ply_file_is_told(old, new, words, tmp_path):
    assert old in as_text()
    path = tmp_path / "file.ply"
    path.write_bytes(as_text().replace(old, new))
    with pytest.raises(sb.FileError, match=f"file.ply: .*{words}"):
        sb.read(path)
