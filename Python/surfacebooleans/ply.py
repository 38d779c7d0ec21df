# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads PLY files, because VTK's reader ends the whole program where one is damaged.

The format: G. Turk, "The PLY Polygon File Format", 1994. A head names elements, each with so many items of the same
properties: numbers, or lists of numbers after their length. The items follow one after another, as text or as bytes.
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkCellArray

from surfacebooleans.meshes import polydata

TYPES = {
    **{name: "i1" for name in ("char", "int8")},
    **{name: "u1" for name in ("uchar", "uint8")},
    **{name: "i2" for name in ("short", "int16")},
    **{name: "u2" for name in ("ushort", "uint16")},
    **{name: "i4" for name in ("int", "int32")},
    **{name: "u4" for name in ("uint", "uint32")},
    **{name: "f4" for name in ("float", "float32")},
    **{name: "f8" for name in ("double", "float64")},
}
ORDERS = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}
LONGEST_HEAD = 1 << 16
ENDS = "the file ends before its data do"


def read_ply(path):
    """A surface or a cloud; of the vertices also normals (``nx``) and colours (``red``), as arrays.

    Raises
    ------
    ValueError
        If it is no such file, or a damaged one; it says what is wrong.
    """
    with open(path, "rb") as file:
        content = file.read()
    order, elements, start = _head(content)
    source = _Text(content[start:]) if order == "=" else _Bytes(content[start:], order)
    items = {name: source.items(count, properties) for name, count, properties in elements}
    if "vertex" not in items:
        raise ValueError("it has no vertices")
    return _surface(items["vertex"], items.get("face", {}))


def _head(content):
    """The order of bytes, the elements (name, count, [(name, type, type of length or None)]), and where data begin."""
    end = content.find(b"end_header", 0, LONGEST_HEAD)
    after = content.find(b"\n", end)
    if not content.startswith(b"ply") or end < 0 or after < 0:
        raise ValueError("it has no head of a PLY file")
    order, elements = None, []
    for line in content[:end].decode("latin-1").splitlines()[1:]:
        words = line.split()
        if len(words) == 3 and words[0] == "format":
            order = ORDERS.get(words[1])
        elif len(words) == 3 and words[0] == "element" and words[2].isdecimal():
            elements.append((words[1], int(words[2]), []))
        elif words and words[0] == "property" and elements and _property(words):
            elements[-1][2].append(_property(words))
        elif words and words[0] not in ("comment", "obj_info"):
            raise ValueError(f"its head has the line '{line[:60]}', which says nothing")
    if not order:
        raise ValueError("its head does not say how the data are written")
    return order, elements, after + 1


def _property(words):
    """Name, type, and type of the length or None, of a line of the head; None if it is none."""
    if len(words) == 3 and words[1] in TYPES:
        return words[2], TYPES[words[1]], None
    if len(words) == 5 and words[1] == "list" and words[2] in TYPES and words[3] in TYPES:
        return words[4], TYPES[words[3]], TYPES[words[2]]
    return None


class _Source:
    """Items one after another; where they are is `at`."""

    def items(self, count, properties):
        """{property: array}, or {property: (lengths, values)} for lists."""
        if count == 0 or not properties:
            return {}
        if not any(length for _, _, length in properties):
            return self.table(count, properties)
        return self.alike(count, properties) or self.one_by_one(count, properties)

    def one_by_one(self, count, properties):
        """Where the lists are of many lengths."""
        columns = [[] for _ in properties]
        lengths = [[] for _ in properties]
        for _ in range(count):
            for column, own, (_, kind, length) in zip(columns, lengths, properties):
                size = 1 if length is None else int(self.take(1, length)[0])
                column.append(self.take(size, kind))
                own.append(size)
        result = {}
        for column, own, (name, _, length) in zip(columns, lengths, properties):
            values = np.concatenate(column)
            result[name] = values if length is None else (np.array(own), values)
        return result


class _Bytes(_Source):
    def __init__(self, data, order):
        self.data, self.order, self.at = data, order, 0

    def take(self, count, kind):
        size = np.dtype(kind).itemsize * count
        if count < 0 or self.at + size > len(self.data):
            raise ValueError(ENDS)
        self.at += size
        return np.frombuffer(self.data, self.order + kind, count, self.at - size)

    def records(self, count, record):
        if record.itemsize * count > len(self.data) - self.at:
            return None
        return np.frombuffer(self.data, record, count, self.at)

    def table(self, count, properties):
        record = np.dtype([(f"p{i}", self.order + kind) for i, (_, kind, _) in enumerate(properties)])
        records = self.records(count, record)
        if records is None:
            raise ValueError(ENDS)
        self.at += records.nbytes
        return {name: records[f"p{i}"] for i, (name, _, _) in enumerate(properties)}

    def alike(self, count, properties):
        """All at once if all lists are as long as those of the first item, as in a mesh of triangles."""
        begin = self.at
        first = self.one_by_one(1, properties)
        self.at = begin
        fields = []
        for i, (name, kind, length) in enumerate(properties):
            if length:
                fields.append((f"n{i}", self.order + length))
                fields.append((f"p{i}", self.order + kind, (int(first[name][0][0]),)))
            else:
                fields.append((f"p{i}", self.order + kind))
        records = self.records(count, np.dtype(fields))
        lists = [(i, name) for i, (name, _, length) in enumerate(properties) if length]
        if records is None or any((records[f"n{i}"] != first[name][0][0]).any() for i, name in lists):
            return None
        self.at += records.nbytes
        result = {name: records[f"p{i}"] for i, (name, _, _) in enumerate(properties)}
        for i, name in lists:
            result[name] = (records[f"n{i}"].astype(np.int64), result[name].ravel())
        return result


class _Text(_Source):
    def __init__(self, data):
        try:
            self.numbers, self.at = np.array(data.split(), dtype=float), 0
        except ValueError:
            raise ValueError("it has words where there should be numbers") from None

    def take(self, count, kind):
        if count < 0 or self.at + count > len(self.numbers):
            raise ValueError(ENDS)
        self.at += count
        with np.errstate(invalid="ignore"):  # what does not fit is no index of a point either
            return self.numbers[self.at - count : self.at].astype(kind)

    def table(self, count, properties):
        table = self.take(count * len(properties), "f8").reshape(count, -1)
        with np.errstate(invalid="ignore", over="ignore"):
            return {name: table[:, i].astype(kind) for i, (name, kind, _) in enumerate(properties)}

    def alike(self, count, properties):
        """As that of bytes, for the usual case of one list and nothing else."""
        if len(properties) != 1 or self.at >= len(self.numbers):
            return None
        name, kind, _ = properties[0]
        length = self.numbers[self.at]
        if not 0 <= length <= (len(self.numbers) - self.at) / count - 1 or length != int(length):
            return None
        end = self.at + count * (int(length) + 1)
        table = self.numbers[self.at : end].reshape(count, -1)
        if (table[:, 0] != length).any():
            return None
        self.at = end
        with np.errstate(invalid="ignore"):
            return {name: (table[:, 0].astype(np.int64), table[:, 1:].astype(kind).ravel())}


def _surface(vertices, faces):
    points = _columns(vertices, "x y z")
    if points is None:
        raise ValueError("its vertices have no x, y and z")
    data = polydata(points, normals=_columns(vertices, "nx ny nz"))
    colours = _columns(vertices, "red green blue alpha")
    colours = _columns(vertices, "red green blue") if colours is None else colours
    if colours is not None and colours.dtype == np.uint8:
        array = numpy_to_vtk(colours, deep=True)
        array.SetName("RGB" if colours.shape[1] == 3 else "RGBA")
        data.GetPointData().SetScalars(array)
    lists = faces.get("vertex_indices", faces.get("vertex_index"))
    if isinstance(lists, tuple):
        lengths, ids = lists[0], lists[1].astype(np.int64)
        bad = np.flatnonzero((ids < 0) | (ids >= len(points)))
        if len(bad):
            cell = np.searchsorted(np.cumsum(lengths), bad[0], side="right")
            raise ValueError(f"face {cell} has a corner {ids[bad[0]]}, and there is no such vertex")
        polygons = vtkCellArray()
        offsets = np.concatenate([[0], np.cumsum(lengths)]).astype(np.int64)
        polygons.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(ids, deep=True))
        data.SetPolys(polygons)
    return data


def _columns(items, names):
    """Properties side by side, or None."""
    names = names.split()
    if not all(isinstance(items.get(name), np.ndarray) for name in names):
        return None
    return np.stack([np.asarray(items[name], items[name].dtype.newbyteorder("=")) for name in names], axis=1)
