# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Point Set Intersection with CAD files of a package: curves of balls with solids are closed, on both."""

import os

import numpy as np
import pytest

import cad
import clouds
from sections import curves_of, values_at

cad.needs_cad()
OK = 0


@pytest.mark.parametrize("file", ["step/screw.step", "step/linkrods.step", "iges/hammer.iges"])
def test_curves_go_on_from_face_to_face(file):
    path = os.path.join(cad.SAMPLES, file)
    if not os.path.exists(path):
        pytest.skip(f"{path} is not installed")
    body = cad.read(path)
    patches, corners = cad.Patches(body.field_data), body.body.points
    size = np.linalg.norm(corners.max(axis=0) - corners.min(axis=0))
    random = np.random.default_rng(3)
    points, normals = clouds.sphere(10000)
    found, changes = 0, 0
    for _ in range(8):
        radius = size * random.uniform(0.05, 0.3)
        centre = corners[random.integers(len(corners))] + 0.5 * radius * random.uniform(-1, 1, 3)
        data = clouds.cloud(centre + radius * points, normals)
        result = curves_of(data, body.data, ChordError=1e-3 * radius)
        assert result.status == OK and not result.errors and not result.warnings
        assert result.of_curves["Closed"].all(), "a solid has no border"
        assert result.of_curves["ChordError"].max(initial=0) <= 1e-3 * radius
        uv, face = result.of_points["UV"], result.of_points["FaceId"]
        for number in np.unique(face):
            exact = patches.points(number, uv[face == number])
            assert np.linalg.norm(exact - result.points[face == number], axis=1).max() <= 1e-12 * size
        assert np.abs(values_at(data, result.points)).max(initial=0) <= 1e-12 * size
        found += len(result.of_curves["Closed"])
        changes += np.count_nonzero(np.diff(face))
    assert found >= 8 and changes > 16, "the balls lie across edges of the solid"
