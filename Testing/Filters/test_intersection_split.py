# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""SplitInput and SplitTool of vtkPolyDataIntersection: the same surfaces, cut along the curves and nowhere else."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource

import measures
import meshes
from booleans import cells_of, points_of, polydata
from intersections import assert_sound, edge_names, intersection
from meshes import box, mesh

LEVEL = mesh([[-9, -9, 0.25], [9, -9, 0.25], [9, 9, 0.25], [-9, 9, 0.25]], [[0, 1, 2], [0, 2, 3]])
QUADS = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def quad_box(lower, upper):
    """A box of six quadrilaterals."""
    corners = [[(lower, upper)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)]
    return polydata(mesh(corners, []), QUADS)


def creased_cube(center, side=1.0):
    """VTK's own cube: 24 points, three normals and three texture coordinates a corner."""
    source = vtkCubeSource()
    source.SetCenter(*center)
    source.SetXLength(side), source.SetYLength(side), source.SetZLength(side)
    source.Update()
    return source.GetOutput()


def real_pair():
    first = meshes.cgal_mesh("elephant")
    return first, meshes.moved(meshes.cgal_mesh("knot1"), (0.05, 0.02, 0.1))


def general_pairs():
    rng = np.random.default_rng(5)
    bumpy = meshes.bumpy_sphere(rng, 4), meshes.turned(meshes.bumpy_sphere(rng, 4), meshes.rotation((1, 2, 3), 0.4))
    spheres = meshes.sphere(), meshes.moved(meshes.sphere(), (0.3, 0.2, 0.1))
    return {"spheres": spheres, "bumpy": bumpy, "real": real_pair()}


@pytest.fixture(scope="module", params=("spheres", "bumpy", "real"))
def pair(request):
    surfaces = general_pairs()[request.param]
    return surfaces, intersection(*surfaces)


# ---- the same surface, cut along the curves --------------------------------------------------------


def test_the_cut_surfaces_have_exactly_the_curves_as_constrained_edges(pair):
    surfaces, cut = pair
    assert_sound(cut, *surfaces)
    names = cut.segment_names()
    for split in cut.splits:
        assert split.edges_between_patches() == names, "closed surfaces in general position: neither more nor less"


def test_cutting_preserves_area_volume_and_closedness(pair):
    surfaces, cut = pair
    for split, body in zip(cut.splits, surfaces):
        assert abs(measures.area(split.body) - measures.area(body)) < 1e-12 * measures.area(body)
        assert abs(measures.volume(split.body) - measures.volume(body)) < 1e-12 * abs(measures.volume(body))
        assert measures.open_edges(split.body) == measures.open_edges(body) == 0, "no T-junction"
        assert measures.non_manifold_edges(split.body) == measures.non_manifold_edges(body)


def test_the_pieces_of_a_cell_fill_that_cell(pair):
    """Merging them back gives the same surface: area, plane and orientation are those of the cell."""
    surfaces, cut = pair
    for split, body in zip(cut.splits, surfaces):
        def area_vectors(points, triangles):
            a, b, c = (points[triangles[:, k]] for k in range(3))
            return np.cross(b - a, c - a) / 2

        given = area_vectors(body.points, body.triangles)
        pieces = area_vectors(split.points, split.body.triangles)
        cell = split.cell_data["OriginalCellId"][split.cell_of_triangle]
        assert set(cell) == set(range(len(body.triangles)))
        sums = np.stack([np.bincount(cell, pieces[:, k], len(given)) for k in range(3)], axis=1)
        assert np.abs(sums - given).max() < 1e-15
        assert np.einsum("ij,ij->i", pieces, given[cell]).min() > -1e-22, "none is turned over"
        uncut = np.bincount(cell, minlength=len(given))[cell] == 1
        same = np.sort(split.points[split.body.triangles[uncut]], axis=1) == np.sort(
            body.points[body.triangles[cell[uncut]]], axis=1
        )
        assert np.count_nonzero(uncut) > 0 and np.all(same), "an uncut cell keeps its bytes"


def test_patches_are_what_a_user_would_pick(pair):
    """A patch is on one side of the other surface throughout; put together, the patches are the surface."""
    surfaces, cut = pair
    for k, split in enumerate(cut.splits):
        patches = [split.patch(number) for number in range(split.number_of_patches)]
        assert len(patches) > 1
        whole = meshes.mesh(split.points, np.concatenate([patch.triangles for patch in patches]))
        assert len(whole.triangles) == len(split.body.triangles) and measures.open_edges(whole) == 0
        for patch in patches:
            corners = patch.points[patch.triangles]
            size = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
            middles = corners.mean(axis=1)[size > 1e-9]
            inside = measures.inside(surfaces[1 - k], middles[:: max(1, len(middles) // 200)])
            assert np.all(inside) or not np.any(inside)


def test_the_points_of_the_curves_are_the_same_in_all_outputs(pair):
    _, cut = pair
    on_curve = {p.tobytes() for p in cut.points}
    for split in cut.splits:
        assert {p.tobytes() for p in split.points[split.point_data["SeamPoint"] == 1]} == on_curve
        assert set(np.unique(split.cell_data["SourceId"])) == {cut.splits.index(split)}


# ---- points, normals and other arrays ---------------------------------------------------------------


def test_points_are_doubled_along_split_normals():
    """Section 5.1 of the paper, and its Figure 2: a cut through a crease has two points there, each with the normal of
    its side."""
    cut = intersection(creased_cube((0, 0, 0)), creased_cube((0.5, 0.5, 0.5)))
    for split in cut.splits:
        normals = split.point_data["Normals"]
        corners = split.points[split.body.triangles]
        facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        facing /= np.linalg.norm(facing, axis=1)[:, None]
        assert np.allclose(normals[split.body.triangles], facing[:, None], atol=1e-6)
        seam = split.point_data["SeamPoint"] == 1
        places, count = np.unique(split.points[seam], axis=0, return_counts=True)
        # A hexagon: three of its corners are on creases of this cube, three inside of faces.
        assert len(places) == 6 and sorted(count) == [1, 1, 1, 2, 2, 2]
    assert len(cut.points) == 6, "on the curve itself each point is there once"


def test_without_creases_no_point_is_doubled():
    first, second = meshes.icosphere(3), meshes.moved(meshes.icosphere(3), (0.5, 0.3, 0.2))
    for split in intersection(first, second).splits:
        assert len(np.unique(split.points, axis=0)) == len(split.points)


def with_arrays(data, point, cell):
    for attributes, arrays in ((data.GetPointData(), point), (data.GetCellData(), cell)):
        for name, values in arrays.items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            attributes.AddArray(array)
    return data


def test_arrays_are_carried_and_interpolated():
    ball, other = meshes.icosphere(4), meshes.moved(meshes.icosphere(4), (0.5, 0.3, 0.2))
    linear = ball.points @ [1.0, -2.0, 3.0] + 4.0
    data = with_arrays(polydata(ball), {"linear": linear}, {"number": np.arange(len(ball.triangles)) * 10})
    cut = intersection(data, with_arrays(polydata(other), {"other": other.points}, {}))
    first, second = cut.splits
    assert np.abs(first.point_data["linear"] - (first.points @ [1.0, -2.0, 3.0] + 4.0)).max() < 1e-14
    assert np.array_equal(first.cell_data["number"], 10 * first.cell_data["OriginalCellId"])
    assert np.abs(second.point_data["other"] - second.points).max() < 1e-14
    assert "other" not in first.point_data and "linear" not in second.point_data, "each surface has its own arrays"
    assert first.data.GetCellData().GetScalars().GetName() == "PatchId", "what ParaView colours by"


def test_float_points_stay_floats_and_agree_in_all_outputs():
    def floats(body):
        data = polydata(body)
        points = vtkPoints()
        points.SetData(numpy_to_vtk(body.points.astype(np.float32), deep=True))
        data.SetPoints(points)
        return data

    ball, other = meshes.icosphere(3), meshes.moved(meshes.icosphere(3), (0.5, 0.3, 0.2))
    cut = intersection(floats(ball), floats(other))
    for data in (cut.curves, *(split.data for split in cut.splits)):
        assert data.GetPoints().GetDataType() == 10  # VTK_FLOAT
    assert all(cut.segment_names() <= split.edges() for split in cut.splits)
    mixed = intersection(floats(ball), other)
    assert all(data.GetPoints().GetDataType() == 11 for data in (mixed.curves, mixed.splits[0].data))


# ---- polygons, strips, several blocks ----------------------------------------------------------------


def sizes(split):
    return np.diff(cells_of(split.data.GetPolys())[0])


def test_polygons_that_no_curve_touches_stay_whole():
    cut = intersection(quad_box((0, 0, 0), (2, 2, 2)), LEVEL)
    first = cut.splits[0]
    assert np.count_nonzero(sizes(first) == 4) == 2, "bottom and top"
    assert sorted(first.cell_data["OriginalCellId"][sizes(first) == 4]) == [0, 1]
    assert first.number_of_patches == 2 and cut.length == 8.0
    assert measures.open_edges(first.body) == 0 and measures.area(first.body) == 24


def test_a_curve_along_the_diagonal_of_a_polygon_becomes_an_edge():
    """However the kernel cuts the quadrilateral: a cut along either diagonal is there."""
    quad = polydata(mesh([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], []), [[0, 1, 2, 3]])
    for (a, b), (c, d) in (((0, 0), (2, 2)), ((2, 0), (0, 2))):
        for end, patches in (((c, d), 2), ((1, 1), 1)):  # a blade from corner to corner, and one that ends half-way
            blade = mesh([[a, b, -1], [*end, -1], [*end, 1], [a, b, 1]], [[0, 1, 2], [0, 2, 3]])
            cut = intersection(quad, blade)
            assert len(cut.segments) > 0 and cut.segment_names() <= cut.splits[0].edges()
            assert cut.splits[0].number_of_patches == patches
            assert measures.area(cut.splits[0].body) == 4.0


def test_triangles_without_common_points_hang_together_in_patches():
    """As read from .stl: three points of its own for every triangle."""
    ball = meshes.icosphere(3)
    soup = mesh(ball.points[ball.triangles.ravel()], np.arange(3 * len(ball.triangles)))
    cut = intersection(soup, LEVEL)
    assert cut.splits[0].number_of_patches == 2
    assert cut.segment_names() == intersection(ball, LEVEL).segment_names()
    assert_sound(cut, soup, LEVEL)


def test_strips_become_triangles():
    points = np.array([[x, y, 0] for x in range(5) for y in (0, 1)], dtype=float)
    strips = vtkCellArray()
    offsets, ids = np.array([0, 10]), np.arange(10)
    strips.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(ids, deep=True))
    band = vtkPolyData()
    band.SetPoints(vtkPoints())
    band.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    band.SetStrips(strips)
    blade = mesh([[1.25, -1, -1], [1.25, 2, -1], [1.25, 2, 1], [1.25, -1, 1]], [[0, 1, 2], [0, 2, 3]])
    cut = intersection(band, blade)
    assert cut.length == 1.0 and measures.area(cut.splits[0].body) == 4.0
    assert set(cut.splits[0].cell_data["OriginalCellId"]) == {0}
    assert cut.splits[0].number_of_patches == 2 and set(sizes(cut.splits[0])) == {3}
    assert set(cut.field_data["SegmentCellIds"][:, 0]) == {0}


def test_vertices_and_lines_are_passed_over_and_cells_keep_their_numbers():
    data = quad_box((0, 0, 0), (2, 2, 2))
    verts = vtkCellArray()
    for point in (0, 1):
        verts.InsertNextCell(1, [point])
    data.SetVerts(verts)
    cut = intersection(data, LEVEL)
    assert set(cut.splits[0].cell_data["OriginalCellId"]) == set(range(2, 8))
    assert set(cut.field_data["SegmentCellIds"][:, 0]) == {4, 5, 6, 7}


def test_a_multi_block_input_is_one_surface():
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, quad_box((0, 0, 0), (2, 2, 2)))
    blocks.SetBlock(1, quad_box((3, 0, 0), (5, 2, 2)))
    cut = intersection(blocks, LEVEL)
    assert (len(cut.polylines), cut.loops, cut.length) == (2, 2, 16.0)
    assert cut.splits[0].number_of_patches == 4


# ---- areas in common ----------------------------------------------------------------------------------


def test_an_area_in_common_is_a_patch_of_its_own():
    """A box stands on another one, off centre: what they share is cut along the other's edges, but is one patch."""
    cut = intersection(box((0, 0, 0), (4, 4, 4)), box((1, 1, 4), (3, 5, 6)))
    assert_sound(cut, box((0, 0, 0), (4, 4, 4)), box((1, 1, 4), (3, 5, 6)))
    assert cut.length == 10.0
    areas = [sorted(measures.area(split.patch(k)) for k in range(split.number_of_patches)) for split in cut.splits]
    assert areas == [[6.0, 90.0], [6.0, 34.0]]


def test_identical_surfaces_are_one_patch_without_curve():
    cut = intersection(box((0, 0, 0), (4, 4, 4)), box((0, 0, 0), (4, 4, 4)))
    assert cut.status == 40 and [split.number_of_patches for split in cut.splits] == [1, 1]
    assert [measures.area(split.body) for split in cut.splits] == [96.0, 96.0]


def test_the_edges_of_a_cut_are_those_of_the_surface_and_of_the_curves():
    """Two triangles that cross: nothing but what has to be there."""
    first = mesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    second = mesh([[1, -5, -1], [1, 9, -1], [1, 2, 1]], [[0, 1, 2]])
    cut = intersection(first, second)
    assert len(cut.segments) == 1 and [split.number_of_patches for split in cut.splits] == [2, 1]
    assert edge_names(cut.points, cut.segments) <= cut.splits[0].edges() & cut.splits[1].edges()
    assert points_of(cut.curves)[:, 0].tolist() == [1, 1]
    assert vtk_to_numpy(cut.curves.GetCellData().GetArray("Closed")).tolist() == [0]
