# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds of sphere, torus, cylinder and cone at three densities and three noises: sections, volumes and areas go to
their analytic values, as fast as theory says.

Noise sigma leaves sigma 4 / sqrt(7 pi) s / R on the surface, R = 2 h: at h = 3.15 s 0.135 of it; averaged over a
whole curve or surface next to nothing of that is left but -H sigma^2. A mesh of chords of length e lies inside by
about k e^2 / 8.
"""

import numpy as np
import pytest

import clouds
import measures
from clouds import surface_of
from sections import plane_section

COUNTS = (2000, 8000, 32000)
NOISES = (0.0, 0.2, 0.5)  # in spacings
GAIN = 4 / (np.sqrt(7 * np.pi) * 2 * 3.15)


def sphere(count, rng):
    return clouds.sphere(count)


def torus(count, rng):
    return clouds.torus(count, rng)


def cylinder(count, rng):
    return clouds.cylinder(count, rng)


def cone(count, rng):
    """Between z = -0.6 and 0.4 of the cone of radius (1 - z) / 2 about z, evenly in the area."""
    z = 1 - np.sqrt(rng.uniform(0.6**2, 1.6**2, count))
    a = rng.uniform(0, 2 * np.pi, count)
    normals = np.stack([2 * np.cos(a), 2 * np.sin(a), np.ones(count)], axis=1) / np.sqrt(5)
    return np.stack([(1 - z) / 2 * np.cos(a), (1 - z) / 2 * np.sin(a), z], axis=1), normals


# Maker, area, distance of points, and the circles of the section at height 0.1: their radii.
SHAPES = {
    "sphere": (sphere, 4 * np.pi, lambda x: np.linalg.norm(x, axis=1) - 1, [np.sqrt(0.99)]),
    "torus": (
        torus,
        4 * np.pi**2 * 0.4,
        clouds.distance_to_torus,
        [1 - np.sqrt(0.15), 1 + np.sqrt(0.15)],
    ),
    "cylinder": (cylinder, 2 * np.pi, lambda x: np.hypot(x[:, 0], x[:, 1]) - 0.5, [0.5]),
    "cone": (
        cone,
        np.pi * np.sqrt(1.25) / 2 * (1.6**2 - 0.6**2),
        lambda x: (2 * np.hypot(x[:, 0], x[:, 1]) + x[:, 2] - 1) / np.sqrt(5),
        [0.45],
    ),
}


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("name", SHAPES)
def test_section_curves_converge(name, noise):
    make, area, distance, radii = SHAPES[name]
    for count in COUNTS:
        rng = np.random.default_rng(count)
        points, normals = make(count, rng)
        spacing = np.sqrt(area / count)
        noisy = points + noise * spacing * rng.normal(size=(count, 1)) * normals
        bound = 0.01 * spacing
        curves = plane_section(clouds.cloud(noisy, normals), (0, 0, 0.1), ChordError=bound)
        assert not curves.errors
        cells, x = curves.of_curves, curves.points
        assert cells["Closed"].tolist() == [1] * len(radii)
        assert cells["ChordError"].max() <= bound
        # Position: what is left of the noise, and of the curvature under random samples.
        off = distance(x) / spacing
        assert np.sqrt(np.mean(off**2)) < 0.02 + 1.6 * GAIN * noise
        # Length: of a wave of that height with the smoothing's length, less what chords cut off.
        steepness = GAIN * noise / 2.0
        for length, radius in zip(sorted(cells["Length"]), radii):
            relative = 0.001 + 0.3 * spacing**2 + steepness**2 + 0.15 * noise * spacing / radius
            assert length == pytest.approx(2 * np.pi * radius, rel=relative)


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("name, volume", [("sphere", 4 * np.pi / 3), ("torus", 2 * np.pi**2 * 0.16)])
def test_volume_and_area_converge(name, volume, noise):
    make, area, _, _ = SHAPES[name]
    errors = []
    for count in COUNTS:
        rng = np.random.default_rng(count)
        points, normals = make(count, rng)
        spacing = np.sqrt(area / count)
        noisy = points + noise * spacing * rng.normal(size=(count, 1)) * normals
        result = surface_of(noisy, normals, GenerateSurface=True, ComputeCurvatures=False)
        assert measures.is_closed(result.mesh)
        errors.append((1 - measures.volume(result.mesh) / volume, 1 - measures.area(result.mesh) / area))
    errors = np.array(errors)
    if noise == 0:  # chords alone: second order in the spacing
        assert np.abs(np.log2(errors[:-1] / errors[1:]) - 2).max() < 0.35
    else:
        assert np.abs(errors[-1, 0]) < np.abs(errors[0, 0]) / 8 and np.abs(errors[-1, 0]) < 4e-3
        # What is left of the noise is as steep at every density, and adds its share to the area.
        assert np.abs(errors[-1, 1]) < 2e-3 + (GAIN * noise) ** 2


def within(mesh, height):
    """Area and volume of a mesh about z between -0.3 and 0.3 of `height`, both weighted by a wave that ends there.

    Cos^2 has no step that triangles could lie across. By Gauss's theorem in each plane of one z, half the flux of
    (x, y, 0) is the area inside.
    """
    corners = mesh.points[mesh.triangles]
    middle = corners.mean(axis=1)
    vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    z = (middle[:, 2] - height) / 0.3
    weight = np.where(np.abs(z) < 1, np.cos(np.pi / 2 * z) ** 2, 0)
    flux = (middle[:, :2] * vectors[:, :2]).sum(axis=1) / 2
    return (weight * np.linalg.norm(vectors, axis=1)).sum(), (weight * flux).sum()


def exactly_within(name, height):
    z = 0.3 * ((np.arange(1000) + 0.5) / 500 - 1)
    radius, slant = (0.5 + 0 * z, 1) if name == "cylinder" else ((1 - z - height) / 2, np.sqrt(1.25))
    steps = np.cos(np.pi / 2 * z / 0.3) ** 2 * 0.6 / 1000
    return np.array([(steps * 2 * np.pi * radius).sum() * slant, (steps * np.pi * radius**2).sum()])


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("name, height", [("cylinder", 0.0), ("cone", -0.1)])
def test_volume_and_area_of_open_shapes_converge_away_from_the_rims(name, height, noise):
    make, area, distance, _ = SHAPES[name]
    wanted = exactly_within(name, height)
    for count in COUNTS:
        rng = np.random.default_rng(count)
        points, normals = make(count, rng)
        spacing = np.sqrt(area / count)
        noisy = points + noise * spacing * rng.normal(size=(count, 1)) * normals
        result = surface_of(noisy, normals, GenerateSurface=True, ComputeCurvatures=False)
        off = distance(result.mesh.points[np.abs(result.mesh.points[:, 2] - height) < 0.3]) / spacing
        assert np.sqrt(np.mean(off**2)) < 0.02 + 1.4 * GAIN * noise
        assert abs(off.mean()) < 0.01 + 0.04 * noise
        assert result.number("NumberOfBorderEdges") > 0
        # Chords alone, and -H sigma^2 of the noise: of second order in the spacing.
        errors = np.abs(within(result.mesh, height) / wanted - 1)
        assert errors[0] < 2 * spacing**2 and errors[1] < 3 * (1 + 3 * noise) * spacing**2


@pytest.mark.parametrize("widths", [2.5, 3, 6])
@pytest.mark.parametrize("count", COUNTS)
def test_random_spheres_have_no_bias_at_any_width(count, widths):
    normals = np.random.default_rng(count).normal(size=(count, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    spacing = np.sqrt(4 * np.pi / count)
    result = surface_of(5 * normals, normals, Width=5 * widths * spacing, ComputeCurvatures=False)
    assert (result.arrays["Validity"] == 0).mean() > 0.99
    valid = result.arrays["Validity"] == 0
    assert np.abs(np.linalg.norm(result.points[valid], axis=1) / 5 - 1).max() < 1e-12
