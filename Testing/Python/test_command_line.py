# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims about the command line: files in, files out; exit statuses as documented; and never a traceback."""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import surfacebooleans as sb
from surfacebooleans.command_line import main
from surfacebooleans.commands import COMMANDS

import booleans
import clouds
import meshes

DONE, NO_RESULT, WRONG_CALL, BAD_FILE, INTERRUPTED = 0, 1, 2, 3, 130


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder of files to work with, which is the current one."""
    monkeypatch.chdir(tmp_path)
    box = meshes.box((0, 0, 0), (2, 2, 2))
    write("box.stl", box)
    write("other.ply", meshes.box((1, 1, 1), (3, 3, 3)))
    write("third.obj", meshes.box((-1, -1, -1), (1, 1, 1)))
    write("open.vtk", meshes.mesh(box.points, box.triangles[:-1]))
    write("ball.vtp", meshes.icosphere(4))
    np.savetxt("scan.xyz", np.hstack(clouds.sphere(2000)))
    pathlib.Path("bad.stl").write_text("solid nonsense")
    return tmp_path


def write(name, body):
    sb.write(booleans.polydata(body), name)


def run(text):
    """Run a command in this process; its exit status."""
    try:
        return main(text.split())
    except SystemExit as leave:  # argparse
        return leave.code


def volume(name):
    measured = sb.measure(sb.read(name))
    assert measured["closed"]
    return measured["volume"]


# ---- every command -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "command, expected",
    [
        ("union box.stl other.ply", 15),
        ("union box.stl other.ply third.obj", 22),
        ("intersection box.stl other.ply", 1),
        ("difference box.stl other.ply third.obj", 6),
        ("symmetric-difference box.stl other.ply", 14),
        ("resolve box.stl other.ply", 15),
        ("clip box.stl --plane 0 0 0.5 0 0 1", 6),
        ("clip box.stl --plane 0 0 1.5 0 0 -1e-3 --plane 1 0 0 1 0 0", 3),
        ("clip box.stl --box 0.5 1 0.5 1 -9 9", 0.5),
        ("clip box.stl --box 0.5 1 0.5 1 -9 9 --inside-out", 7.5),
        ("points-mesh scan.xyz", 4 / 3 * np.pi),
        ("points-boolean scan.xyz box.stl --operation intersection", np.pi / 6),
    ],
)
def test_solids(folder, command, expected):
    assert run(f"{command} -o out.vtk") == DONE
    assert volume("out.vtk") == pytest.approx(expected, rel=2e-2 if "points" in command else 1e-12)


def test_curves_and_surfaces_cut_along_them(folder):
    assert run("curves box.stl other.ply -o c.vtp --split-file a.vtp --split-tool b.vtp") == DONE
    assert sb.read("c.vtp").GetCellData().GetArray("Length").GetValue(0) == pytest.approx(6)
    assert sb.read("a.vtp").GetCellData().GetArray("PatchId").GetRange() == (0, 1)
    assert volume("b.vtp") == pytest.approx(8)
    assert run("union box.stl other.ply -o u.stl --curves again.vtp") == DONE
    assert sb.read("again.vtp").GetCellData().GetArray("Length").GetValue(0) == pytest.approx(6)


def test_distances_and_fields(folder):
    assert run("distance scan.xyz ball.vtp -o d.vtp --second e.vtp --nearest --json r.json") == DONE
    assert abs(np.array(sb.read("d.vtp").GetPointData().GetArray("Distance").GetRange())).max() < 0.01
    assert sb.read("e.vtp").GetPointData().GetArray("Distance")
    assert json.loads(pathlib.Path("r.json").read_text())["results"][0]["fields"]["HausdorffDistance"] < 0.1
    assert run("distance box.stl other.ply -o d.vtp --unsigned --maximum 1.5") == DONE
    assert sb.read("d.vtp").GetPointData().GetArray("Distance").GetRange() == (1, 1.5)
    assert run("field box.stl -o f.vti --dimensions 5 6 7 --margin 0.5 --sign winding-number --negate") == DONE
    assert sb.read("f.vti").GetDimensions() == (5, 6, 7)
    assert run("field box.stl -o f.vti --spacing 0.5 --band 0.25") == DONE
    assert sb.read("f.vti").GetScalarRange() == (-0.25, 0.25)


def test_cross_sections_are_filled_or_outlined(folder):
    assert run("cut box.stl -o s.vtp --count 4") == DONE
    slices = sb.fields_of(sb.read("s.vtp"))
    assert slices["SliceArea"] == pytest.approx([4] * 4)
    assert run("cut box.stl -o l.vtp --plane 0 0 1 0 0 1 --offsets -0.5 --outlines") == DONE
    assert run("fill l.vtp -o f.ply") == DONE
    assert sb.measure(sb.read("f.ply"))["area"] == pytest.approx(4)


def test_scanned_points(folder):
    assert run("points scan.xyz -o p.vtp") == DONE
    assert sb.read("p.vtp").GetPointData().GetArray("MeanCurvature")
    assert run("points-curves scan.xyz --plane 0 0 0 0 0 1 -o c.vtp --chord-error 1e-4") == DONE
    assert sb.read("c.vtp").GetCellData().GetArray("Length").GetValue(0) == pytest.approx(2 * np.pi, rel=1e-3)
    assert run("points-curves scan.xyz box.stl -o c.vtp") == DONE
    assert sb.read("c.vtp").GetCellData().GetArray("Length").GetValue(0) == pytest.approx(1.5 * np.pi, rel=2e-2)
    assert run("points-boolean scan.xyz box.stl -o b.ply --points p.vtp --curves c.vtp") == DONE
    assert sb.read("p.vtp").GetPointData().GetArray("SeamPoint").GetRange() == (0, 1)
    assert sb.read("c.vtp").GetNumberOfLines() > 0


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command.name)
def test_every_command_has_help_with_formats_and_exit_statuses(command, capsys):
    assert run(f"{command.name} --help") == DONE
    text = capsys.readouterr().out
    assert all(
        word in text for word in (command.description.split()[0], "formats:", "exit status: 0 done", "130 interrupted")
    )
    assert not re.search(r"^  -{1,2}\S+( \S+)*$\n^  -", text, re.MULTILINE), "an option without a word of help"


# ---- what is said ------------------------------------------------------------------------------


def test_one_line_says_what_came_out(folder, capsys):
    run("union box.stl other.ply -o out.stl")
    out, err = capsys.readouterr()
    assert re.fullmatch(r"out.stl: \d+ polygons, closed, area 42, volume 15 \(\d+\.\d{3} s\)\n", out) and err == ""
    run("union box.stl other.ply -o out.stl --quiet")
    assert capsys.readouterr() == ("", "")


def test_the_report_has_sizes_volumes_and_times(folder, capsys):
    assert run("difference box.stl other.ply -o out.stl --json -") == DONE
    report = json.loads(capsys.readouterr().out)
    (result,) = report["results"]
    assert report["status"] == 0 and result["error"] is None and result["warnings"] == []
    assert [item["file"] for item in result["inputs"]] == ["box.stl", "other.ply"]
    assert [item["volume"] for item in result["inputs"]] == [8, 8]
    assert result["outputs"][0]["closed"] and result["outputs"][0]["volume"] == pytest.approx(7)
    assert set(result["seconds"]) == {"read", "compute", "write"} and result["fields"]["ResultVolume"] == 7


def test_warnings_are_a_line_each_and_no_failure(folder, capsys):
    assert run("union box.stl open.vtk -o out.stl --json r.json") == DONE
    err = capsys.readouterr().err
    assert err.startswith("surfacebooleans: warning: Input 2 is not closed")
    assert err.count("\n") == err.count("surfacebooleans: warning: ") == 2  # nor does it cut the box through
    assert "not closed" in json.loads(pathlib.Path("r.json").read_text())["results"][0]["warnings"][0]


# ---- what goes wrong ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "command, status, words",
    [
        ("", WRONG_CALL, "command"),
        ("unite box.stl other.ply -o out.stl", WRONG_CALL, "invalid choice: 'unite'"),
        ("union box.stl -o out.stl", WRONG_CALL, "OTHER"),
        ("union box.stl other.ply", WRONG_CALL, "-o/--output"),
        ("clip box.stl --plane 0 0 0 -o out.stl", WRONG_CALL, "expected 6 arguments"),
        ("union box.stl other.ply -o out.stl --tolerance x", WRONG_CALL, "invalid float value: 'x'"),
        ("union none.stl other.ply -o out.stl", BAD_FILE, "none.stl: there is no such file"),
        ("union box.stl none.stl -o out.stl", BAD_FILE, "none.stl: there is no such file"),
        ("union bad.stl other.ply -o out.stl", BAD_FILE, "bad.stl: "),
        ("union box.stl other.ply -o out.xyzzy", BAD_FILE, "the format .xyzzy cannot be written"),
        ("union box.stl other.ply -o no/out.stl", BAD_FILE, "no/out.stl: cannot be written: No such file or directory"),
        ("union box.stl other.ply -o out.stl --json no/r.json", BAD_FILE, "no/r.json: cannot be written"),
        ("curves box.stl other.ply -o out.stl", BAD_FILE, "holds surfaces only"),
        ("distance box.stl scan.xyz -o out.vtp", NO_RESULT, "Tool has no polygon"),
        ("clip box.stl --plane 0 0 0 0 0 0 -o out.stl", NO_RESULT, "the normal of a plane must not be zero"),
        ("union box.stl other.ply -o out.stl --tolerance nan", NO_RESULT, "olerance"),
        ("field box.stl -o out.vti --dimensions 1 1 1", NO_RESULT, "imension"),
        ("field box.stl -o out.vti --dimensions 99999999999 2 2", NO_RESULT, ""),
        ("cut box.stl -o out.vtp --count 0", WRONG_CALL, "invalid number of planes value: '0'"),
        ("points box.stl -o out.vtp --width -1", NO_RESULT, "idth"),
        ("points-curves scan.xyz -o out.vtp", WRONG_CALL, "give either a tool or --plane"),
        ("points-boolean scan.xyz open.vtk -o out.vtp", NO_RESULT, "closed"),
    ],
)
def test_errors_are_one_sentence_and_have_a_status(folder, capsys, command, status, words):
    assert run(command) == status
    err = capsys.readouterr().err
    assert words in err and "error: " in err and "Traceback" not in err
    assert status == WRONG_CALL or err.count("\n") == err.count("surfacebooleans: ")
    assert not any(path.name.startswith((".", "out")) for path in folder.iterdir()) or "--json" in command


# ---- folders -----------------------------------------------------------------------------------


@pytest.fixture
def parts(folder):
    (folder / "parts").mkdir()
    for name in ("box.stl", "third.obj", "bad.stl", "open.vtk"):
        shutil.copy(folder / name, folder / "parts")
    (folder / "parts" / "notes.md").write_text("no mesh")
    return folder / "parts"


def test_each_file_of_a_folder_with_one_tool(parts, capsys):
    (parts / "bad.stl").unlink()
    assert run("union parts other.ply -o results --json r.json") == DONE
    assert sorted(os.listdir("results")) == ["box.stl", "open.vtk", "third.obj"]
    assert volume("results/box.stl") == pytest.approx(15) and volume("results/third.obj") == pytest.approx(16)
    assert len(json.loads(pathlib.Path("r.json").read_text())["results"]) == 3
    assert "warning: parts/open.vtk: Input 1 is not closed" in capsys.readouterr().err


def test_one_bad_file_does_not_keep_the_others_from_being_done(parts, capsys):
    assert run("difference parts other.ply -o results --format vtp --json r.json") == BAD_FILE
    assert sorted(os.listdir("results")) == ["box.vtp", "open.vtp", "third.vtp"]
    out, err = capsys.readouterr()
    assert out.count("\n") == 3 and "error: parts/bad.stl: " in err
    errors = [result["error"] is not None for result in json.loads(pathlib.Path("r.json").read_text())["results"]]
    assert errors == [True, False, False, False]


@pytest.mark.parametrize(
    "command, status, words",
    [
        ("union parts other.ply -o parts", WRONG_CALL, "would replace the files of the folder"),
        ("union parts other.ply -o results --curves c.vtp", WRONG_CALL, "--curves is for one file"),
        ("union empty other.ply -o results", BAD_FILE, "no file in this folder"),
        ("union parts other.ply -o box.stl", BAD_FILE, "box.stl: File exists"),
    ],
)
def test_what_cannot_be_done_with_a_folder(parts, capsys, command, status, words):
    (parts.parent / "empty").mkdir()
    before = {path: path.read_bytes() for path in parts.iterdir()}
    assert run(command) == status
    assert words in capsys.readouterr().err
    assert {path: path.read_bytes() for path in parts.iterdir()} == before


# ---- as a program ------------------------------------------------------------------------------


@pytest.mark.parametrize("python", [sys.executable, "pvpython"])
def test_it_is_a_program_of_python_and_of_paraview(folder, python):
    def call(words):
        command = [python, "-m", "surfacebooleans", *words.split()]
        return subprocess.run(command, capture_output=True, text=True, env={**os.environ, "DISPLAY": ""})

    done = call("union box.stl other.ply -o out.stl")
    assert (done.returncode, done.stderr) == (DONE, "") and "volume 15" in done.stdout
    assert volume("out.stl") == pytest.approx(15)
    failed = call("union box.stl none.stl -o out.stl")
    assert (failed.returncode, failed.stdout) == (BAD_FILE, "")
    assert failed.stderr == "surfacebooleans: error: none.stl: there is no such file\n"
    assert call("distance box.stl scan.xyz -o out.vtp").returncode == NO_RESULT
    assert call("unite").returncode == WRONG_CALL


@pytest.mark.parametrize("python", [sys.executable, "pvpython"])
def test_ctrl_c_ends_it_without_half_a_file(folder, python):
    np.savetxt("large.xyz", np.hstack(clouds.sphere(200000)))
    code = (
        "import os, runpy, sys, surfacebooleans.command_line; sys.argv = '- points-mesh large.xyz -o out.vtp'.split(); "
        "os.write(1, b'ready\\n'); runpy.run_module('surfacebooleans', run_name='__main__')"
    )
    program = subprocess.Popen([python, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert program.stdout.readline() == "ready\n"
    time.sleep(1)
    program.send_signal(signal.SIGINT)
    _, err = program.communicate(timeout=60)
    assert (program.returncode, err) == (INTERRUPTED, "surfacebooleans: interrupted; no file was left half written\n")
    assert not [path for path in folder.iterdir() if path.name.startswith((".", "out"))]
