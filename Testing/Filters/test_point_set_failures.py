# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""How clouds fail, one case a test: by what sign it is seen, and what the filters do about it."""

import numpy as np
import pytest

import cloud_booleans
import clouds
import measures
import meshes
from booleans import polydata
from clouds import implicit, surface_of
from sections import curves_of, plane_section

OK, DOUBTFUL, THIN_PARTS, TOUCHING, THIN_WALL, OUT_OF_SCALE = 0, 2, 4, 6, 38, 39
DEFINED, FAR, BORDER, CONTRADICTING = 0, 1, 2, 3


def section(points, normals, origin, normal, **settings):
    curves = plane_section(clouds.cloud(points, normals), origin, normal, **settings)
    assert not curves.errors
    return curves


def random_sphere(count, rng, radius=1.0):
    normals = rng.normal(size=(count, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return radius * normals, normals


# ---- noise and outliers ------------------------------------------------------------------------


def test_noise_is_reported_and_a_larger_width_averages_it():
    rng = np.random.default_rng(1)
    points, normals = clouds.sphere(20000)
    spacing = np.sqrt(4 * np.pi / 20000)
    noisy = points + 0.5 * spacing * rng.normal(size=(20000, 1)) * normals
    errors = []
    for widths in (3, 6):
        result = surface_of(noisy, normals, Width=widths * spacing, ComputeCurvatures=False)
        assert result.number("ResidualRMS") == pytest.approx(0.5 * spacing, rel=0.05)
        errors.append(np.sqrt(np.mean((np.linalg.norm(result.points, axis=1) - 1) ** 2)))
        # (1 - r^2 / R^2)^3 up to R = 2 h leaves 4 / sqrt(7 pi) s / R of the noise
        predicted = 0.5 * spacing * 4 / (np.sqrt(7 * np.pi) * 2 * widths)
        assert errors[-1] == pytest.approx(predicted, rel=0.25)


def test_specks_around_outliers_are_left_out_and_counted():
    rng = np.random.default_rng(2)
    points, normals = clouds.sphere(8000)
    spacing = np.sqrt(4 * np.pi / 8000)
    places = 3 * rng.normal(size=(12, 3))
    places *= (3 + rng.uniform(size=(12, 1))) / np.linalg.norm(places, axis=1)[:, None]
    scraps = np.concatenate([p + 1.2 * spacing * rng.normal(size=(40, 3)) for p in places])
    result = surface_of(
        np.concatenate([points, scraps]),
        np.concatenate([normals, np.tile([0.0, 0.0, 1.0], (len(scraps), 1))]),
        GenerateSurface=True,
    )
    assert result.number("NumberOfSpecks") >= 4
    assert measures.is_closed(result.mesh) and result.number("NumberOfBorderEdges") == 0
    assert np.linalg.norm(result.mesh.points, axis=1).max() < 1.01
    assert measures.volume(result.mesh) == pytest.approx(4 * np.pi / 3, rel=6e-3)


def test_small_bodies_are_no_specks():
    points, normals = clouds.sphere(8000)
    spacing = np.sqrt(4 * np.pi / 8000)
    small, outwards = clouds.sphere(110)  # 6 spacings wide: a diameter of two widths
    pearl = 3 * spacing * small
    result = surface_of(
        np.concatenate([points, pearl + [3, 0, 0]]), np.concatenate([normals, outwards]), GenerateSurface=True
    )
    assert result.number("NumberOfSpecks") == 0 and measures.is_closed(result.mesh)
    assert (result.mesh.points[:, 0] > 2.5).any()


# ---- overlapping scans that do not fit -----------------------------------------------------------


def test_the_residual_shows_where_scans_do_not_fit():
    rng = np.random.default_rng(3)
    (lower, n0), (upper, n1) = random_sphere(12000, rng), random_sphere(12000, rng)
    lower, n0 = lower[lower[:, 2] < 0.3], n0[lower[:, 2] < 0.3]
    upper, n1 = upper[upper[:, 2] > -0.3], n1[upper[:, 2] > -0.3]
    spacing = np.sqrt(4 * np.pi / 12000)
    apart = 0.8 * spacing
    points = np.concatenate([lower, (1 + apart) * upper])
    result = surface_of(points, np.concatenate([n0, n1]), Width=5 * spacing, ComputeCurvatures=False)
    height, residual = np.abs(points[:, 2]), np.abs(result.arrays["Residual"])
    # In the overlap the surface lies half-way; away from it, on the one scan there is.
    assert np.median(residual[height < 0.1]) == pytest.approx(apart / 2, rel=0.15)
    assert np.median(residual[height > 0.7]) < 0.02 * apart
    assert 0.1 * spacing < result.number("ResidualRMS") < 0.5 * spacing


# ---- open scans and holes ------------------------------------------------------------------------


def test_the_ends_of_an_open_section_are_listed():
    points, normals = clouds.sphere(20000)
    kept = np.arccos(points[:, 0]) > 0.5  # a hole about the x axis
    curves = section(points[kept], normals[kept], (0, 0, 0), (0, 0, 1))
    x, ids = curves.points, curves.lines[0]
    assert curves.of_curves["Closed"].tolist() == [0]
    spacing = np.sqrt(4 * np.pi / 20000)
    for end in (x[ids[0]], x[ids[-1]]):
        assert np.arctan2(abs(end[1]), end[0]) == pytest.approx(0.5, abs=2.5 * spacing)
    result = surface_of(points[kept], normals[kept], GenerateSurface=True)
    assert result.number("NumberOfBorderEdges") > 0
    assert (result.arrays["Validity"][np.arccos(points[kept][:, 0]) > 0.7] == DEFINED).all()
    beyond = implicit(points[kept], normals[kept])
    assert not beyond.IsDefined([1, 0, 0])


# ---- uneven sampling -----------------------------------------------------------------------------


@pytest.mark.parametrize("ratio", [1, 4, 10])
def test_density_may_vary_tenfold(ratio):
    rng = np.random.default_rng(5)
    points, normals = clouds.torus(60000, rng)
    cosine = points[:, 0] / np.hypot(points[:, 0], points[:, 1])
    kept = rng.uniform(size=len(points)) < ratio ** (0.5 * (cosine - 1)) * 0.4
    points, normals, cosine = points[kept], normals[kept], cosine[kept]
    result = surface_of(points, normals, GenerateSurface=True)
    assert result.status == OK and result.number("NumberOfBorderEdges") == 0 and measures.is_closed(result.mesh)
    assert (result.arrays["Validity"] == DEFINED).all()
    spacing = result.number("Spacing")
    off = clouds.distance_to_torus(result.points)
    assert np.sqrt(np.mean(off[cosine > 0] ** 2)) < 0.01 * spacing
    assert np.sqrt(np.mean(off[cosine < 0] ** 2)) < 0.02 * spacing
    assert measures.volume(result.mesh) == pytest.approx(2 * np.pi**2 * 0.16, rel=5e-3)
    curves = section(points, normals, (0, 0, 0), (0, 0, 1))
    assert curves.of_curves["Closed"].tolist() == [1, 1]


# ---- thin walls ----------------------------------------------------------------------------------


def hollow_ball(thickness, count=8000):
    """Two concentric spheres, the inner one facing inwards; the thickness in spacings."""
    points, normals = clouds.sphere(count)
    radius = 1 - thickness * np.sqrt(4 * np.pi / count)
    inner, outwards = clouds.sphere(int(count * radius**2))
    return np.concatenate([points, radius * inner]), np.concatenate([normals, -outwards]), radius


@pytest.mark.parametrize("thickness", [6, 4, 3, 2.5])
def test_walls_down_to_two_and_a_half_spacings_keep_their_two_sides(thickness):
    points, normals, radius = hollow_ball(thickness)
    result = surface_of(points, normals, GenerateSurface=True)
    assert result.status == OK and measures.is_closed(result.mesh)
    wanted = np.where(np.linalg.norm(points, axis=1) > (1 + radius) / 2, 1, radius)
    off = np.abs(np.linalg.norm(result.points, axis=1) - wanted)
    assert off.max() < 0.05 * result.number("Spacing")
    shell = 4 * np.pi / 3 * (1 - radius**3)
    assert measures.volume(result.mesh) == pytest.approx(shell, rel=0.01)


def test_walls_that_are_too_thin_are_refused_with_their_thickness():
    points, normals, _ = hollow_ball(1.5)
    result = surface_of(points, normals)
    assert result.status == THIN_WALL and result.is_empty and len(result.errors) == 1
    assert result.number("ThinWall") == pytest.approx(1.5 * np.sqrt(4 * np.pi / 8000), rel=0.1)
    assert "Width" in result.errors[0] and "walls" in result.errors[0]
    points, normals, _ = hollow_ball(4)
    spacing = np.sqrt(4 * np.pi / 8000)
    assert surface_of(points, normals, Width=3.5 * spacing).status == OK
    assert surface_of(points, normals, Width=4.5 * spacing).status == THIN_WALL


def test_a_thin_part_is_told_and_the_rest_goes_on():
    points, normals = clouds.sphere(8000)
    spacing = np.sqrt(4 * np.pi / 8000)
    cap = points[:, 2] > 0.8  # doubled inwards by a wall of one spacing and a half
    both = np.concatenate([points, (1 - 1.5 * spacing) * points[cap]])
    result = surface_of(both, np.concatenate([normals, -normals[cap]]))
    assert result.status == THIN_PARTS and not result.errors and len(result.warnings) >= 1
    assert 0.05 < result.number("ThinShare") < 0.2


# ---- sharp edges ---------------------------------------------------------------------------------


def test_edges_are_rounded_over_about_a_width():
    points, normals = clouds.cube(12000, np.random.default_rng(11))
    result = surface_of(points, normals)
    width = result.number("Width")
    from_edge = np.sort(0.5 - np.abs(points), axis=1)[:, 1]
    residual = np.abs(result.arrays["Residual"])
    assert residual[from_edge > 2.0 * width].max() < 1e-9  # flat: no difference at all
    assert residual[from_edge < 0.3 * width].mean() > 0.05 * width  # the edge itself is cut off
    assert np.nanmax(residual) < width


# ---- normals that are wrong ----------------------------------------------------------------------


def test_an_inside_out_cloud_is_told():
    points, normals = clouds.sphere(4000)
    for settings in ({}, {"GenerateSurface": True}):
        result = surface_of(points, -normals, **settings)
        assert result.status == DOUBTFUL and "inside out" in result.message and "FlipNormals" in result.message
    for name in ("kitten.xyz", "oni.pwn"):
        scan, outwards = clouds.cgal_cloud(name)
        assert "inside out" not in surface_of(scan, outwards).message
        assert "inside out" in surface_of(scan, -outwards).message
    turned = surface_of(points, -normals, GenerateSurface=True, FlipNormals=True)
    assert turned.status == OK and measures.volume(turned.mesh) > 0


def test_a_half_that_is_turned_over_is_told():
    points, normals = clouds.sphere(20000)
    result = surface_of(points, np.where(points[:, :1] > 0, 1, -1) * normals)
    assert result.status == DOUBTFUL and "turned over" in result.warnings[0]
    marked = np.isin(result.arrays["Validity"], (BORDER, CONTRADICTING)) | (result.arrays["DoubtfulNormal"] == 1)
    assert marked.any() and np.abs(points[marked, 0]).max() < 2 * result.number("Width")


def test_few_points_are_not_called_none():
    points, normals = clouds.sphere(20000)
    patch = points[:, 2] > 0.996  # 40 points, of which those at its rim contradict the others
    result = surface_of(points, np.where(patch[:, None], -1, 1) * normals)
    assert 20 < (result.arrays["Validity"] == CONTRADICTING).sum() < 100
    assert result.status == DOUBTFUL and "Of the 20000 points, less than 1 % have" in result.message


# ---- tangential contact --------------------------------------------------------------------------


def test_a_plane_that_touches_gives_a_small_loop_or_a_warning():
    points, normals = clouds.sphere(20000)
    spacing = np.sqrt(4 * np.pi / 20000)
    touching = section(points, normals, (0, 0, 1), (0, 0, 1))
    x = touching.points
    assert (len(x) == 0) == (touching.status == TOUCHING) and np.abs(x[:, :2]).max(initial=0) < 2 * spacing
    near = section(points, normals, (0, 0, 1 + 0.05 * spacing), (0, 0, 1))
    assert near.points.size == 0 and near.status == TOUCHING and len(near.warnings) == 1
    assert near.field_data["NumberOfTouches"][0] == 1 and "Plane touches" in near.message
    for turned in (normals, -normals):  # from outside and from inside
        assert section(points, turned, (0, 0, 1 + 0.05 * spacing), (0, 0, 1)).status == TOUCHING
    away = section(points, normals, (0, 0, 1.01), (0, 0, 1))
    assert away.points.size == 0 and away.status == OK and away.field_data["NumberOfTouches"][0] == 0
    # The one line that a tangent line meets it in is found, or not, but never twice the same.
    surface = implicit(points, normals)
    assert surface.IntersectWithLine([-1, 0, 1 - 1e-3], [1, 0, 1 - 1e-3], None) == 2
    assert surface.IntersectWithLine([-1, 0, 1 + 1e-3], [1, 0, 1 + 1e-3], None) == 0


# ---- far starts, large coordinates, degenerate clouds --------------------------------------------


@pytest.mark.parametrize("definition", [0, 1])
def test_far_places_are_invalid_and_nothing_is_nan(definition):
    surface = implicit(*clouds.sphere(3000), Definition=definition)
    width = surface.GetActualWidth()
    for reach in (1 + 2.5 * width, 3, 1e3, 1e150, 0.0):
        found = [7.0] * 3
        assert not surface.Project([reach, 0, 0], found) and found == [reach, 0, 0]
        assert surface.GetValidity([reach, 0, 0]) == FAR
        assert np.isfinite(surface.EvaluateFunction([reach, 0, 0]))
        slope = [0.0] * 3
        surface.EvaluateGradient([reach, 0, 0], slope)
        assert np.isfinite(slope).all()


@pytest.mark.parametrize("shift", [1e6, -3e7])
def test_large_coordinates_cost_their_last_digits_only(shift):
    points, normals = random_sphere(5000, np.random.default_rng(6))
    here = surface_of(points, normals, GenerateSurface=True)
    there = surface_of(points + shift, normals, GenerateSurface=True)
    digits = 16 * np.spacing(abs(shift))
    assert np.abs(np.linalg.norm(there.points - shift, axis=1) - 1).max() < digits
    assert np.abs(there.points - shift - here.points).max() < 100 * digits
    assert measures.is_closed(there.mesh)
    curves = section(points + shift, normals, (shift, shift, shift + 0.6), (0, 0, 1), ChordError=1e-4)
    x = curves.points - shift
    assert curves.of_curves["Closed"].tolist() == [1]
    assert np.hypot(x[:, 0], x[:, 1]) == pytest.approx(0.8, abs=1e-6)
    ball = meshes.moved(meshes.icosphere(3, 0.5), (0.9 + shift, shift, shift))
    cut = curves_of(clouds.cloud(points + shift, normals), ball)
    assert cut.of_curves["Closed"].tolist() == [1]
    assert np.abs(np.linalg.norm(cut.points - shift, axis=1) - 1).max() < 100 * digits


def all_of_a_torus(scale):
    """What the three filters make of it, scaled: the results, and the places in them."""
    points, normals = clouds.torus(3000, np.random.default_rng(8))
    cloud = clouds.cloud(scale * points, normals)
    ball = polydata(meshes.scaled(meshes.moved(meshes.icosphere(3, 0.3), (1.2, 0, 0)), scale))
    surface = clouds.run(cloud, GenerateSurface=True)
    curves = plane_section(cloud, (0, 0, 0.1 * scale), (0, 0.1, 1))
    trimmed = cloud_booleans.run(cloud, ball, cloud_booleans.DIFFERENCE)
    places = (surface.points, surface.mesh.points, curves.points, trimmed.body.points, trimmed.seam)
    return (surface, curves, trimmed), places


@pytest.mark.parametrize("power", [-190, 190])
def test_the_unit_of_length_does_not_matter(power):
    scale = 2.0**power
    for here, there in zip(all_of_a_torus(1)[1], all_of_a_torus(scale)[1]):
        assert len(here) > 50 and np.array_equal(there, scale * here)


@pytest.mark.parametrize("scale", [1e-300, 1e-100, 1e100, 1e300])
def test_points_whose_distances_cannot_be_computed_with_are_refused(scale):
    results, places = all_of_a_torus(scale)
    for result in results:
        assert result.status == OUT_OF_SCALE and len(result.errors) == 1
        assert "1e60 apart" in result.message and "Transform" in result.message
    assert not any(len(place) for place in places)


@pytest.mark.parametrize("name", ["line", "two lines", "copies", "bad"])
def test_degenerate_clouds_are_refused_in_one_sentence(name):
    t = np.linspace(0, 1, 200)[:, None]
    line = t * [[1.0, 2.0, 3.0]]
    cloud, wanted = {
        "line": (line, "lines"),
        "two lines": (np.concatenate([line, line + [100, 0, 0]]), "lines"),
        "copies": (np.repeat(np.eye(3), 50, axis=0), "duplicates"),
        "bad": (np.full((40, 3), np.nan), "not finite"),
    }[name]
    result = surface_of(cloud, GenerateSurface=True)
    assert result.is_empty and result.status >= 30 and len(result.errors) == 1 and wanted in result.errors[0]


def test_duplicates_and_nan_change_nothing():
    points, normals = random_sphere(4000, np.random.default_rng(7))
    clean = surface_of(points, normals, GenerateSurface=True)
    more = np.concatenate([points, points[:500], np.full((9, 3), np.nan)])
    dirty = surface_of(more, np.concatenate([normals, normals[:500], np.tile([0.0, 0, 1], (9, 1))]), GenerateSurface=True)
    assert dirty.number("NumberOfDuplicates") == 500 and dirty.number("NumberOfBadPoints") == 9
    assert np.array_equal(dirty.mesh.points, clean.mesh.points)
    assert np.array_equal(dirty.mesh.triangles, clean.mesh.triangles)
    assert np.array_equal(dirty.points[:4000], clean.points)
