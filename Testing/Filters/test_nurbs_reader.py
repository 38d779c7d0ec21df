# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The CAD reader: closed facets within the bound, on the exact surfaces that travel with them; STEP, IGES, bad files."""

import os
import subprocess
import sys

import numpy as np
import pytest

import cad
import measures
import step_files

cad.needs_cad()

OK, OPEN, BAD_REQUEST, NOT_READABLE, NO_FACES, TOO_MANY_FACETS = 0, 2, 10, 50, 51, 52


def step_of(tmp_path, shape, *sizes, unit="MILLI"):
    step = step_files.StepFile(unit)
    step.product(getattr(step_files, shape)(step, *sizes))
    return step.write(tmp_path / f"{shape}.step")


def inner_points(result):
    """Those that are no corner of an edge of their face."""
    triangles = result.body.triangles
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    pairs, counts = np.unique(edges, axis=0, return_counts=True)
    inner = np.ones(result.data.GetNumberOfPoints(), dtype=bool)
    inner[pairs[counts == 1]] = False
    return inner


def diagonal(result):
    points = result.body.points
    return np.linalg.norm(points.max(axis=0) - points.min(axis=0))


SOLIDS = [("cylinder", 2.0, 5.0), ("sphere", 3.0), ("hollow_sphere", 3.0, 1.5), ("torus", 4.0, 1.0)]


@pytest.mark.parametrize("shape", SOLIDS, ids=lambda s: s[0])
def test_solids_with_formulas(tmp_path, shape):
    name, *sizes = shape
    volume, area = step_files.VOLUMES[name](*sizes), step_files.AREAS[name](*sizes)
    errors = []
    for bound in (1e-3, 2.5e-4):
        result = cad.read(step_of(tmp_path, *shape), ChordError=bound)
        assert result.status == OK and result.errors == [] and result.warnings == []
        assert measures.open_edges(result.body) == 0 and result.number("Closed") == 1
        assert result.number("NumberOfSolids") == 1
        assert cad.distances_to_patches(result).max() < 1e-14 * diagonal(result)  # analytic: also on the edges
        assert cad.chord_errors(result).max() <= bound * diagonal(result)
        assert result.number("Volume") == pytest.approx(measures.volume(result.body))
        errors.append((volume - measures.volume(result.body), area - measures.area(result.body)))
    errors = np.array(errors)
    assert np.abs(errors[1] / (volume, area)).max() < 3e-3
    assert np.abs(errors[1] / errors[0]).max() < 0.3  # a quarter of the bound gives a quarter of the error


def test_the_exact_sphere_is_a_sphere(tmp_path):
    result = cad.read(step_of(tmp_path, "sphere", 3.0))
    patches = cad.Patches(result.field_data)
    rng = np.random.default_rng(1)
    for face in range(len(patches)):
        ends = [(k[d], k[-d - 1]) for k, d in zip(patches.knots[face], patches.degrees[face])]
        uv = np.stack([rng.uniform(a, b, 1000) for a, b in ends], axis=1)
        points, normals = patches.points(face, uv), patches.normals(face, uv)
        assert np.linalg.norm(points, axis=1) == pytest.approx(3.0, abs=1e-14 * 3)
        assert np.einsum("ij,ij->i", points, normals).min() > 0  # Du x Dv points out


def test_units_become_millimetres(tmp_path):
    result = cad.read(step_of(tmp_path, "sphere", 3.0, unit=None))
    assert result.field_data["Unit"] == ["mm"]
    assert result.body.points.max() == pytest.approx(3000.0, rel=1e-6)


def test_assemblies_have_their_parts_in_place(tmp_path):
    step = step_files.StepFile()
    ball = step.product(step_files.sphere(step, 1.0), name="ball")
    origin = step.axes()
    whole = step.product(origin, kind="SHAPE_REPRESENTATION", name="whole")
    for x in (10.0, 20.0, 40.0):
        step.place(whole, ball, origin, step.axes((x, 0, 5), (1, 0, 0), (0, 1, 0)))
    result = cad.read(step.write(tmp_path / "whole.stp"))
    assert result.status == OK and result.number("NumberOfSolids") == 3
    solid, centers = result.cell_data["SolidId"], []
    for k in range(3):
        corners = result.body.points[np.unique(result.body.triangles[solid == k])]
        centers.append((corners.max(axis=0) + corners.min(axis=0)) / 2)
    assert np.array(sorted(c.tolist() for c in centers)) == pytest.approx(
        np.array([[10, 0, 5], [20, 0, 5], [40, 0, 5]]), abs=0.05
    )
    assert result.number("Volume") == pytest.approx(3 * step_files.VOLUMES["sphere"](1.0), rel=0.1)
    assert cad.distances_to_patches(result).max() < 1e-14 * diagonal(result)


def test_parts_have_their_names_and_colours(tmp_path):
    step = step_files.StepFile()
    face = step_files.sphere_face(step, 1.0)
    painted, rod = step.solid(face), step_files.cylinder(step, 0.5, 2.0)
    step.paint(painted, 1.0, 0.0, 0.0)
    step.paint(face, 0.0, 0.2, 1.0)  # of the face itself, which goes before that of its solid
    ball, pin = step.product(painted, name="ball"), step.product(rod, name="pin")
    origin = step.axes()
    whole = step.product(origin, kind="SHAPE_REPRESENTATION", name="whole")
    for x, part in ((10.0, ball), (20.0, pin), (40.0, ball)):
        step.place(whole, part, origin, step.axes((x, 0, 5), (1, 0, 0), (0, 1, 0)))
    result = cad.read(step.write(tmp_path / "whole.stp"))
    assert result.status == OK and sorted(result.field_data["PartNames"]) == ["ball", "ball", "pin"]
    part, color = result.cell_data["PartId"], result.cell_data["PartColor"]
    assert np.array_equal(np.unique(part), [0, 1, 2])
    middles = result.body.points[result.body.triangles].mean(axis=1)
    for number, name in enumerate(result.field_data["PartNames"]):
        of_part = part == number
        assert len(np.unique(result.cell_data["SolidId"][of_part])) == 1
        near_pin = np.abs(middles[of_part][:, 0] - 20) < 3
        assert near_pin.all() if name == "pin" else not near_pin.any()
        assert np.all(color[of_part] == ([255, 255, 255] if name == "pin" else [0, 51, 255]))


def test_a_file_without_names_or_colours_has_no_arrays_for_them():
    result = cad.read(f"{cad.SAMPLES}/iges/hammer.iges", ChordError=1e-3)
    assert result.status == OK and "PartNames" not in result.field_data
    assert "PartId" not in result.cell_data and "PartColor" not in result.cell_data


def test_a_real_part_has_its_name():
    result = cad.read(f"{cad.SAMPLES}/step/screw.step", ChordError=1e-3)
    assert list(result.field_data["PartNames"]) == ["the product name"]
    assert np.all(result.cell_data["PartId"] == 0) and "PartColor" not in result.cell_data


# Volume and area by Open CASCADE's own integration (BRepGProp) over the exact faces of these files.
REAL = {
    "step/linkrods.step": dict(faces=37, solids=1, volume=3.847, rel=3.5e-3, bound=1e-3),
    "step/screw.step": dict(faces=10, solids=1, volume=3788.27, rel=2.5e-3, bound=2.5e-4),
    "iges/hammer.iges": dict(faces=45, solids=1, volume=2.05929e11, rel=3.5e-3, bound=2.5e-4),
}


@pytest.mark.parametrize("name", REAL)
def test_real_solids(name):
    wanted, bound = REAL[name], REAL[name]["bound"]
    result = cad.read(f"{cad.SAMPLES}/{name}", ChordError=bound)
    assert result.status == OK and not result.errors and not result.warnings
    assert measures.open_edges(result.body) == 0
    assert result.number("NumberOfFaces") == wanted["faces"] == len(cad.Patches(result.field_data))
    assert result.number("NumberOfSolids") == wanted["solids"]
    assert measures.volume(result.body) == pytest.approx(wanted["volume"], rel=wanted["rel"])
    size = diagonal(result)
    assert cad.chord_errors(result).max() <= bound * size
    # Inside of a face facets are on the patch to rounding; on edges by no more than the file leaves open.
    gaps = np.zeros(result.data.GetNumberOfPoints())
    gaps[result.body.triangles.T] = cad.distances_to_patches(result)
    assert inner_points(result).any()
    assert gaps[inner_points(result)].max() < 1e-14 * size
    assert gaps.max() == pytest.approx(result.number("Gap"), rel=1e-6)
    assert gaps.max() < 1e-4 * size


@pytest.mark.parametrize("shape", [None, *SOLIDS], ids=lambda s: s[0] if s else "screw")
def test_normals_are_those_of_the_patches(tmp_path, shape):
    result = cad.read(step_of(tmp_path, *shape) if shape else f"{cad.SAMPLES}/step/screw.step")
    a, b, c = (result.body.points[result.body.triangles[:, k]] for k in range(3))
    facet = np.cross(b - a, c - a)
    large = np.linalg.norm(facet, axis=1) > 1e-6 * np.linalg.norm(facet, axis=1).max()
    normals = result.point_data["Normals"]
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1.0, abs=1e-12)
    mean = normals[result.body.triangles].sum(axis=1)
    assert (np.einsum("ij,ij->i", facet, mean)[large] > 0).all()


def test_a_finer_bound_gives_more_facets_and_the_same_patches():
    coarse, fine = (cad.read(f"{cad.SAMPLES}/step/screw.step", ChordError=e) for e in (2e-3, 2e-4))
    assert fine.data.GetNumberOfCells() > 2 * coarse.data.GetNumberOfCells()
    assert cad.chord_errors(fine).max() <= 2e-4 * diagonal(fine)
    assert np.array_equal(coarse.field_data["NURBSPoles"].shape, fine.field_data["NURBSPoles"].shape)


def test_open_shapes_are_read_and_said_to_be_open():
    result = cad.read(f"{cad.SAMPLES}/iges/bearing.iges", ChordError=4e-3)
    assert result.status == OPEN and result.number("Closed") == 0
    assert result.errors == [] and "open" in result.warnings[0]
    assert result.number("NumberOfFaces") == 213
    assert cad.chord_errors(result).max() <= 4e-3 * diagonal(result)


def test_reading_twice_gives_the_same_bytes():
    first, second = (cad.read(f"{cad.SAMPLES}/step/screw.step", ChordError=2e-4) for _ in range(2))
    assert first.body.points.tobytes() == second.body.points.tobytes()
    assert first.point_data["UV"].tobytes() == second.point_data["UV"].tobytes()
    assert np.array_equal(first.body.triangles, second.body.triangles)


def cut_off(tmp_path):
    text = open(f"{cad.SAMPLES}/step/screw.step", encoding="latin1").read()
    path = tmp_path / "cut_off.step"
    path.write_text(text[: len(text) // 3], encoding="latin1")
    return path


def nonsense(tmp_path, name="nonsense.step"):
    path = tmp_path / name
    path.write_bytes(bytes(range(256)) * 40)
    return path


def without_faces(tmp_path):
    step = step_files.StepFile()
    step.product(step.axes(), kind="SHAPE_REPRESENTATION")
    return step.write(tmp_path / "without_faces.step")


@pytest.mark.parametrize(
    "make, settings, wanted, word",
    [
        (lambda _: None, {}, BAD_REQUEST, "FileName"),
        (lambda p: p / "absent.step", {}, NOT_READABLE, "cannot be opened"),
        (lambda p: p, {}, NOT_READABLE, "The file"),
        (nonsense, {}, NOT_READABLE, "damaged"),
        (lambda p: nonsense(p, "nonsense.igs"), {}, NO_FACES, "The file"),
        (without_faces, {}, NO_FACES, "no faces"),
        (lambda _: f"{cad.SAMPLES}/step/screw.step", {"ChordError": 0.0}, BAD_REQUEST, "ChordError"),
        (lambda _: f"{cad.SAMPLES}/step/screw.step", {"ChordError": np.nan}, BAD_REQUEST, "ChordError"),
        (lambda _: f"{cad.SAMPLES}/step/linkrods.step", {"ChordError": 1e-7}, TOO_MANY_FACETS, "ChordError"),
    ],
)
def test_what_cannot_be_read_is_refused_in_one_sentence(tmp_path, make, settings, wanted, word):
    result = cad.read(make(tmp_path), **settings)
    assert result.status == wanted and len(result.errors) == 1
    assert word in result.errors[0] and result.message in result.errors[0]
    assert result.data.GetNumberOfPoints() == 0 and result.data.GetNumberOfCells() == 0


def damaged(tmp_path, name, seed, count):
    """Copies of a file in which a few letters are others."""
    with open(f"{cad.SAMPLES}/{name}", encoding="latin1") as file:
        text = file.read()
    rng, paths = np.random.default_rng(seed), []
    for k in range(count):
        letters = list(text)
        for place in rng.integers(len(text) // 20, len(text), int(rng.integers(1, 80))):
            letters[place] = "0123456789.,#()$-+E*"[rng.integers(20)]
        paths.append(tmp_path / f"damaged_{k}.{name.rsplit('.', 1)[1]}")
        paths[-1].write_text("".join(letters), encoding="latin1")
    return paths


def test_damaged_files_end_in_a_sentence_or_a_surface(tmp_path):
    """Never a crash, which a process of its own would show: on some of these Open CASCADE reads where there is nothing."""
    script = (
        "import sys; sys.path.insert(0, sys.argv[1]); import cad\n"
        "for path in sys.argv[2:]:\n"
        "    result = cad.read(path, ChordError=0.01)\n"
        "    print(result.status, len(result.errors), result.data.GetNumberOfCells())\n"
    )
    paths = [cut_off(tmp_path)]
    paths += damaged(tmp_path, "step/screw.step", 3, 10) + damaged(tmp_path, "iges/hammer.iges", 11, 6)
    done = subprocess.run(
        [sys.executable, "-c", script, os.path.dirname(__file__), *map(str, paths)],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    lines = [[int(x) for x in line.split()] for line in done.stdout.splitlines()]
    assert len(lines) == len(paths)
    for status, errors, cells in lines:
        assert (status < 5 and errors == 0 and cells > 0) or (status >= 5 and errors == 1 and cells == 0)


def test_nothing_is_printed():
    done = subprocess.run(
        [
            sys.executable,
            "-c",
            "from surfacebooleans.vtk import vtkNURBSReader\n"
            f"r = vtkNURBSReader(); r.SetFileName('{cad.SAMPLES}/iges/hammer.iges'); r.Update()\n",
        ],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_it_can_be_stopped():
    from surfacebooleans.vtk import vtkNURBSReader

    reader = vtkNURBSReader()
    reader.SetFileName(f"{cad.SAMPLES}/step/linkrods.step")
    seen = []

    def stop(*_):
        seen.append(reader.GetProgress())
        if reader.GetProgress() > 0.3:
            reader.SetAbortExecuteAndUpdateTime()

    reader.AddObserver("ProgressEvent", stop)
    reader.Update()
    result = cad.plain(reader.GetOutputDataObject(0))
    assert result.status == 9 and result.data.GetNumberOfCells() == 0
    assert len(seen) > 5 and max(seen[:-1]) < 0.7 and seen == sorted(seen)  # the pipeline ends with 1
