# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What vtkPolyDataDistanceField promises: an image in the right place with the distance at every sample."""

import numpy as np
import pytest
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkContourFilter

import measures
import meshes
from booleans import points_of, triangles_of
from distances import arrays, cloud, distances, listened_to, prepared
from surfacebooleans.vtk import vtkPolyDataDistanceField

BLOCK = meshes.box((0, 0, 0), (4, 2, 1))


def field(body, **settings):
    tested = listened_to(prepared(vtkPolyDataDistanceField(), settings, body))
    return tested, tested.GetOutput()


def samples(image):
    points = np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
    return points, arrays(image.GetPointData())["Distance"]


def test_dimensions_and_margin_place_the_image():
    _, image = field(BLOCK, Dimensions=(9, 7, 5), Margin=0.25)
    assert image.GetDimensions() == (9, 7, 5)
    assert image.GetBounds() == pytest.approx((-1, 5, -1, 3, -1, 2))


def test_spacing_gives_cubic_cells_that_cover_the_box_and_its_margin():
    _, image = field(BLOCK, SampleBy=1, Spacing=0.3, Margin=0.1)
    assert image.GetSpacing() == pytest.approx((0.3, 0.3, 0.3))
    bounds = np.array(image.GetBounds()).reshape(3, 2)
    beyond = np.concatenate([[0, 0, 0] - bounds[:, 0], bounds[:, 1] - [4, 2, 1]])
    assert np.all(beyond > 0.4 - 1e-9) and np.all(beyond < 0.4 + 0.3)
    _, image = field(BLOCK, SampleBy=1, Margin=0.0)
    assert image.GetDimensions() == (101, 51, 26)


@pytest.mark.parametrize("settings", [{}, {"SignMethod": 1}, {"SignedDistance": 0}, {"NegateDistance": 1}])
def test_every_sample_is_the_distance(settings):
    body = meshes.cgal_mesh("eight")
    points, values = samples(field(body, Dimensions=(20, 21, 22), **settings)[1])
    wanted = distances(cloud(points), body, **settings)
    assert np.array_equal(values, wanted.astype(np.float32))


def test_a_narrow_band_keeps_the_signs():
    body = meshes.cgal_mesh("eight")
    points, values = samples(field(body, Dimensions=(30, 30, 30), NarrowBand=0.05)[1])
    wanted = np.clip(distances(cloud(points), body), -0.05, 0.05)
    assert np.array_equal(values, wanted.astype(np.float32))
    assert (values == np.float32(-0.05)).sum() > 50


def test_its_contour_is_the_surface_and_offsets_of_it():
    ball = meshes.icosphere(4, 1.0)
    tested = prepared(vtkPolyDataDistanceField(), {"Dimensions": (60, 60, 60), "Margin": 0.3}, ball)
    contour = vtkContourFilter()
    contour.SetInputConnection(tested.GetOutputPort())
    for offset in (-0.3, 0.0, 0.3):
        contour.SetValue(0, offset)
        contour.Update()
        surface = contour.GetOutput()
        assert surface.GetNumberOfCells() > 1000
        assert np.linalg.norm(points_of(surface), axis=1) == pytest.approx(1 + offset, abs=4e-3)
        assert measures.open_edges(triangles_of(surface)[0]) == 0


def test_another_size_of_image_arrives_downstream():
    tested = prepared(vtkPolyDataDistanceField(), {"SampleBy": 1, "Spacing": 0.25}, BLOCK)
    contour = vtkContourFilter()
    contour.SetInputConnection(tested.GetOutputPort())
    counts = []
    for spacing in (0.25, 0.1, 0.5):
        tested.SetSpacing(spacing)
        contour.Update()
        surface = triangles_of(contour.GetOutput())[0]
        assert measures.open_edges(surface) == 0 and abs(measures.volume(surface)) == pytest.approx(8, rel=0.4)
        counts.append(len(surface.triangles))
    assert counts[1] > counts[0] > counts[2]


def test_threads_do_not_matter():
    images = [field(BLOCK, NumberOfThreads=n)[1] for n in (1, 2, 4)]
    assert len({arrays(image.GetPointData())["Distance"].tobytes() for image in images}) == 1


@pytest.mark.parametrize(
    "body, settings, status, word",
    [
        (meshes.EMPTY, {}, 30, "no polygon"),
        (vtkImageData(), {}, 20, "Extract Surface"),
        (None, {}, 10, "Input"),
        (BLOCK, {"Spacing": -1.0}, 10, "Spacing"),
        (BLOCK, {"Margin": float("nan")}, 10, "Margin"),
        (BLOCK, {"Dimensions": (4, 1, 4)}, 10, "Dimensions"),
        (BLOCK, {"SampleBy": 1, "Spacing": 1e-9}, 8, "samples"),
    ],
)
def test_what_cannot_be_sampled_is_said_in_one_sentence(body, settings, status, word):
    tested, image = field(body, **settings)
    fields = arrays(image.GetFieldData())
    assert fields["Status"][0] == status and word in fields["Message"][0]
    assert image.GetNumberOfPoints() == 0
    assert len(tested.heard["ErrorEvent"]) == 1
