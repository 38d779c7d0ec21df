# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims about what the package does with pyvista, meshio and tqdm (Python/requirements.txt)."""

import os
import subprocess
import sys

import meshio
import numpy as np
import pytest
import pyvista
import surfacebooleans as sb
from surfacebooleans.command_line import main

import clouds
import meshes

BOX, BALL = pyvista.Cube(), pyvista.Sphere(radius=0.6, center=(0.3, 0.2, 0.1))
OPERATIONS = ("union", "intersection", "difference", "symmetric difference")


# ---- pyvista -----------------------------------------------------------------------------------


@pytest.mark.parametrize("operation", OPERATIONS)
def test_pyvista_in_pyvista_out(operation):
    result = sb.boolean(BOX, BALL, operation)
    assert isinstance(result, pyvista.PolyData)
    # Points are apart where normals differ; the parts of a symmetric difference touch along the curve.
    assert result.clean(tolerance=0.0).n_open_edges == 0 or operation == "symmetric difference"
    assert result.volume == pytest.approx(result.field_data["ResultVolume"][0], rel=1e-5)
    assert set(result.cell_data["SourceId"]) == {0, 1}


def test_volumes_agree_with_set_theory():
    volume = {operation: sb.boolean(BOX, BALL, operation).field_data["ResultVolume"][0] for operation in OPERATIONS}
    a, b = (
        float(mesh.field_data["ResultVolume"][0])
        for mesh in (sb.boolean(BOX, operation="resolve"), sb.boolean(BALL, operation="resolve"))
    )
    assert volume["union"] + volume["intersection"] == pytest.approx(a + b, rel=1e-12)
    assert volume["difference"] + volume["intersection"] == pytest.approx(a, rel=1e-12)
    assert volume["symmetric difference"] == pytest.approx(volume["union"] - volume["intersection"], rel=1e-12)


def test_every_recipe_gives_pyvista():
    cloud = pyvista.PolyData(clouds.sphere(1000)[0])
    plane = ((0, 0, 0), (0, 0, 1))
    grid = pyvista.ImageData(dimensions=(4, 4, 4))
    outlines = sb.cut(BALL, outlines=True)
    results = {
        "intersection": (sb.intersection(BOX, BALL), pyvista.PolyData),
        "split": (sb.split(BOX, BALL)[1], pyvista.PolyData),
        "distance": (sb.distance(grid, BALL), pyvista.ImageData),
        "second distance": (sb.distance(grid, BALL, second=True)[1], pyvista.PolyData),
        "distance_field": (sb.distance_field(BALL, dimensions=(4, 4, 4)), pyvista.ImageData),
        "clip": (sb.clip(BALL, plane), pyvista.PolyData),
        "cut": (outlines, pyvista.PolyData),
        "triangulate_contours": (sb.triangulate_contours(outlines), pyvista.PolyData),
        "point_set_surface": (sb.point_set_surface(cloud), pyvista.PolyData),
        "point_set_points": (sb.point_set_points(cloud), pyvista.PolyData),
        "point_set_boolean": (sb.point_set_boolean(cloud, BOX), pyvista.PolyData),
        "point_set_intersection": (sb.point_set_intersection(cloud, plane), pyvista.PolyData),
    }
    assert {
        name for name, (result, kind) in results.items() if type(result) is not kind or result.n_points == 0
    } == set()


def test_grids_and_multiblocks_of_pyvista_are_meshes():
    blocks = pyvista.MultiBlock([BOX, pyvista.Cube(center=(3, 0, 0))])
    assert sb.measure(sb.boolean(blocks, BALL, "union"))["closed"]
    grid = pyvista.ImageData(dimensions=(3, 3, 3), spacing=(0.5, 0.5, 0.5))
    united = sb.boolean(grid, BALL)
    assert isinstance(united, pyvista.PolyData) and sb.measure(united)["closed"]


def test_arrays_of_pyvista_are_carried():
    body = BOX.triangulate()
    body.point_data["height"] = body.points[:, 2]
    body.cell_data["colour"] = np.arange(body.n_cells)
    result = sb.boolean(body, BALL, "difference")
    of_body = result.extract_cells(result.cell_data["SourceId"] == 0)
    assert np.allclose(of_body.point_data["height"], of_body.points[:, 2], atol=1e-6)
    parents = of_body.cell_data["OriginalCellId"]
    assert np.array_equal(of_body.cell_data["colour"], parents)


def test_normals_of_a_cloud_of_pyvista_are_used():
    points, normals = clouds.sphere(1000)
    cloud = pyvista.PolyData(points)
    cloud.point_data.active_normals = -normals
    assert sb.point_set_points(cloud).field_data["NormalsEstimated"][0] == 0


def test_vtk_in_is_vtk_out_although_pyvista_is_loaded():
    assert not isinstance(sb.boolean(sb.polydata(*meshes.cube()), BALL), pyvista.PolyData)


def test_pyvista_works_in_pvpython():
    code = """
import sys
sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__  # pyvista takes the window that pvpython prints through
import pyvista, surfacebooleans as sb
result = sb.boolean(pyvista.Cube(), pyvista.Sphere(radius=0.6), "difference")
print(type(result).__module__.split(".")[0], sb.measure(result)["closed"])
"""
    done = subprocess.run(["pvpython", "-c", code], capture_output=True, text=True, env={**os.environ, "DISPLAY": ""})
    assert (done.stdout, done.stderr) == ("pyvista True\n", "")


# ---- meshio ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "suffix", [".off", ".msh", ".inp", ".mesh", ".bdf", ".nas", ".vol", ".vol.gz", ".mdpa", ".stl", ".ply", ".vtu"]
)
def test_formats_of_meshio_are_read(suffix, tmp_path):
    body = meshes.on_lattice(meshes.bumpy_sphere(np.random.default_rng(3)), 10)  # .bdf has few digits
    meshio.write(tmp_path / f"file{suffix}", meshio.Mesh(body.points, [("triangle", body.triangles)]))
    measured = sb.measure(sb.read(tmp_path / f"file{suffix}"))
    assert measured["closed"] and measured["polygons"] == len(body.triangles)
    assert measured["volume"] == pytest.approx(sb.measure(tuple(body))["volume"], rel=1e-5)


def test_a_volume_mesh_of_meshio_counts_as_its_boundary(tmp_path):
    tetrahedra = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1.0]])
    meshio.write(tmp_path / "file.msh", meshio.Mesh(points, [("tetra", tetrahedra)]))
    measured = sb.measure(sb.read(tmp_path / "file.msh"))
    assert measured["closed"] and measured["polygons"] == 6 and measured["volume"] == pytest.approx(1 / 2)


@pytest.mark.parametrize("suffix", [".off", ".msh", ".mesh", ".inp"])
def test_formats_of_meshio_are_written(suffix, tmp_path):
    surface = sb.boolean(BOX, BALL, "difference")
    sb.write(surface, tmp_path / f"file{suffix}")
    measured, expected = sb.measure(sb.read(tmp_path / f"file{suffix}")), sb.measure(surface)
    assert measured["closed"] and measured["volume"] == pytest.approx(expected["volume"], rel=1e-5)


def test_a_mesh_of_cgal_goes_through_the_command_line(tmp_path, capsys):
    elephant = meshes.cgal_directory() / "elephant.off"
    sb.write(sb.polydata(*meshes.cylinder(0.1, 2.0)), tmp_path / "drill.off")
    assert main([*f"difference {elephant} {tmp_path}/drill.off -o {tmp_path}/drilled.off".split()]) == 0
    assert "closed" in capsys.readouterr().out and sb.measure(sb.read(tmp_path / "drilled.off"))["closed"]


@pytest.mark.parametrize("suffix", [".off", ".msh", ".med", ".inp", ".xdmf", ".bdf", ".mesh"])
def test_what_meshio_cannot_read_is_told(suffix, tmp_path, capfd):
    (tmp_path / f"file{suffix}").write_bytes(b"nonsense \xff\n")
    with pytest.raises(sb.FileError, match=f"file{suffix}: ") as caught:
        sb.read(tmp_path / f"file{suffix}")
    assert "\n" not in str(caught.value) and capfd.readouterr() == ("", "")


# ---- tqdm --------------------------------------------------------------------------------------


def test_a_bar_shows_the_stages(capsys):
    sb.boolean(BOX, BALL, progress=True)
    shown = capsys.readouterr().err
    assert "Winding numbers" in shown and "100%" in shown


def test_the_command_line_shows_a_bar(tmp_path):
    sb.write(BOX, tmp_path / "a.stl")
    sb.write(BALL, tmp_path / "b.stl")
    command = [sys.executable, "-m", "surfacebooleans", "union", "a.stl", "b.stl", "-o", "c.stl", "--progress"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "100%" in done.stderr and "closed" in done.stdout
