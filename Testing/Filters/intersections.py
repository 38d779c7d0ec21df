# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs vtkPolyDataIntersection on meshes, and gives what comes out as plain arrays."""

from dataclasses import dataclass, field

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

import measures
from booleans import Reported, arrays_of, bytes_of, cells_of, heard_from, points_of, polydata, triangles_of
from meshes import Mesh, mesh


def places(points):
    """Each point's bytes as one value that can be compared, sorted and put into sets."""
    return np.ascontiguousarray(np.asarray(points, dtype=np.float64) + 0.0).view("V24").reshape(-1)


def edge_names(points, edges):
    """Edges, given by point ids, as a set of pairs of places; direction and double points do not matter."""
    names = places(points)
    ends = names[np.asarray(edges, dtype=np.int64).reshape(-1, 2)]
    return {tuple(sorted((a.tobytes(), b.tobytes()))) for a, b in ends}


class Split:
    """One of the cut surfaces."""

    def __init__(self, data):
        self.data = data
        self.points = points_of(data)
        self.cell_data, self.point_data = arrays_of(data.GetCellData()), arrays_of(data.GetPointData())
        self.field_data = arrays_of(data.GetFieldData())
        self.body, self.cell_of_triangle = triangles_of(data)

    @property
    def is_empty(self):
        return self.data.GetNumberOfCells() == 0 and self.data.GetNumberOfPoints() == 0

    @property
    def number_of_patches(self):
        return len(np.unique(self.cell_data["PatchId"]))

    def patch(self, number):
        """What a user's Threshold of PatchId gives."""
        return mesh(self.points, self.body.triangles[self.cell_data["PatchId"][self.cell_of_triangle] == number])

    def edges_between_patches(self):
        """The edges that have cells of different patches beside them; not where the surface crosses itself."""
        triangles = self.body.triangles
        _, place = np.unique(self.points + 0.0, axis=0, return_inverse=True)
        edges = np.sort(place.reshape(-1)[np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1)], axis=-1)
        patches = np.repeat(self.cell_data["PatchId"][self.cell_of_triangle], 3)
        found, number = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)
        lowest, highest = np.full(len(found), 2**31), np.full(len(found), -1)
        np.minimum.at(lowest, number.reshape(-1), patches)
        np.maximum.at(highest, number.reshape(-1), patches)
        first = np.zeros(place.max() + 1, dtype=np.int64)
        first[place.reshape(-1)] = np.arange(len(self.points))
        divides = (lowest < highest) & (np.bincount(number.reshape(-1)) == 2)
        return edge_names(self.points, first[found[divides]])

    def edges(self):
        triangles = self.body.triangles
        return edge_names(self.points, np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1))


@dataclass
class Cut(Reported):
    """What came out of the filter."""

    curves: vtkPolyData
    splits: list  # of SplitInput and SplitTool
    cell_data: dict
    field_data: dict
    errors: list = field(default_factory=list)
    warnings: list = field(default_factory=list)

    @property
    def length(self):
        return float(self.field_data["TotalLength"][0])

    @property
    def loops(self):
        return int(np.count_nonzero(self.cell_data["Closed"])) if len(self.polylines) else 0

    @property
    def points(self):
        return points_of(self.curves)

    @property
    def polylines(self):
        """The curves as arrays of point ids."""
        offsets, ids = cells_of(self.curves.GetLines())
        return [ids[a:b] for a, b in zip(offsets[:-1], offsets[1:])]

    @property
    def segments(self):
        """All segments as pairs of point ids, in the order of SegmentCellIds."""
        pairs = [np.stack([line[:-1], line[1:]], axis=1) for line in self.polylines]
        return np.concatenate(pairs) if pairs else np.zeros((0, 2), dtype=np.int64)

    def segment_names(self):
        return edge_names(self.points, self.segments)

    def degrees(self):
        return np.bincount(self.segments.ravel(), minlength=len(self.points))

    def bytes(self):
        """Everything that must not depend on the number of threads."""
        makers = np.asarray(self.field_data.get("SegmentCellIds", [])).tobytes()
        return makers + b"|" + bytes_of(self.curves, *(split.data for split in self.splits))


def intersection(first, second=None, number_of_threads=None, **settings):
    """Run the filter on meshes or vtkPolyData; `settings` go to its setters."""
    from surfacebooleans.vtk import vtkPolyDataIntersection

    tested = vtkPolyDataIntersection()
    if number_of_threads is not None:
        tested.SetNumberOfThreads(number_of_threads)
    for name, value in settings.items():
        getattr(tested, "Set" + name)(value)
    for port, surface in enumerate((first, second)):
        if surface is not None:
            tested.SetInputDataObject(port, polydata(surface) if isinstance(surface, Mesh) else surface)
    return update(tested)


def update(tested):
    """Update a filter and collect what it gives and says."""
    errors, warnings = heard_from(tested)
    curves = tested.GetOutputDataObject(0)
    return Cut(
        curves,
        [Split(tested.GetOutputDataObject(port)) for port in (1, 2)],
        arrays_of(curves.GetCellData()),
        arrays_of(curves.GetFieldData()),
        errors,
        warnings,
    )


def assert_sound(cut, *surfaces):
    """What holds of every result, whatever the surfaces."""
    points, segments = cut.points, cut.segments
    assert len(np.unique(places(points))) == len(points), "each point is there once"
    names = cut.segment_names()
    assert len(names) == len(segments), "no segment comes twice"
    degrees = cut.degrees()
    for line, closed, length in zip(cut.polylines, cut.cell_data["Closed"], cut.cell_data["Length"]):
        assert closed == (line[0] == line[-1])
        assert np.all(degrees[line[1:-1]] == 2), "a curve goes on to where others meet it"
        assert closed or (degrees[line[0]] != 2 and degrees[line[-1]] != 2)
        steps = np.linalg.norm(np.diff(points[line], axis=0), axis=1)
        assert abs(steps.sum() - length) <= 1e-12 * length
    assert cut.cell_data["CurveId"].tolist() == list(range(len(cut.polylines)))
    assert cut.field_data["SegmentCellIds"].shape == (len(segments), 2)
    for split, body in zip(cut.splits, surfaces):
        assert_same_surface(split, body, names)


def assert_same_surface(split, body, names):
    """The cut surface has the curves as edges, is the same surface, and divides nowhere else."""
    given = triangles_of(body)[0] if isinstance(body, vtkPolyData) else body
    assert names <= split.edges(), "the curves are edges"
    assert split.edges_between_patches() <= names, "patches end at curves only"
    assert abs(measures.area(split.body) - measures.area(given)) <= 1e-12 * measures.area(given)
    on_curve = set(places(split.points[split.point_data["SeamPoint"] == 1]).tolist())
    wanted = {end for name in names for end in name}
    assert {np.void(p).tobytes() for p in on_curve} == wanted, "SeamPoint marks the points on the curves"
    assert split.cell_data["PatchId"].min() == 0
    assert split.number_of_patches == split.cell_data["PatchId"].max() + 1
