# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What `cmake --install` and the Debian package bring works by itself, without the build tree and without this one."""

import os
import pathlib
import re
import subprocess

import pytest

HERE = pathlib.Path(__file__).resolve().parent
BUILD = pathlib.Path(os.environ["PV_PLUGIN_PATH"]).parents[3]
OURS = ("PV_PLUGIN_PATH", "PV_MACRO_PATH", "PYTHONPATH")
LOADED = (
    "print(sorted({line.split()[-1] for line in open('/proc/self/maps') if '/libsb' in line or 'SurfaceBooleans.so' in line"
    " or '/surfacebooleans/' in line}))"
)
BOOLEAN = (
    "from paraview.simple import *\n"
    "import surfacebooleans, surfacebooleans.vtk\n"
    "f = SurfaceBoolean(Input=Box(XLength=2), Tool=Box(Center=[0.5, 0, 0]), Operation='Difference')\n"
    "f.UpdatePipeline()\n"
    "print(f.FieldData['ResultVolume'].GetRange()[0], surfacebooleans.__file__)\n" + LOADED
)


def run(*command, **more):
    """The command, with nothing of the build tree in its environment; what it prints."""
    environment = {name: value for name, value in os.environ.items() if name not in OURS} | more
    done = subprocess.run([str(c) for c in command], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def assert_works(printed, prefix):
    """Printed by BOOLEAN: the right volume, and everything that is ours comes from there."""
    volume, package, *libraries = re.findall(r"[^\s,'\[\]]+", printed.splitlines()[-2] + " " + printed.splitlines()[-1])
    assert float(volume) == 1.0
    assert len(libraries) >= 5
    for file in (package, *libraries):
        assert file.startswith(f"{prefix}/"), file


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    folder = tmp_path_factory.mktemp("prefix").resolve()
    run("cmake", "--install", BUILD, "--prefix", folder)
    return folder


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    """The Debian package, and what it puts where."""
    folder = tmp_path_factory.mktemp("package").resolve()
    run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", folder)
    (file,) = folder.glob("*.deb")
    run("dpkg-deb", "-x", file, folder / "root")
    return file, folder / "root"


def test_the_installed_plugin_and_package_work_by_themselves(prefix):
    command = f". {prefix}/share/surfacebooleans/env.sh && exec pvpython -c \"$SCRIPT\""
    assert_works(run("sh", "-c", command, SCRIPT=BOOLEAN), prefix)


def test_nothing_installed_names_the_build_tree(prefix):
    libraries = list(prefix.rglob("*.so"))
    assert len(libraries) >= 7
    for library in libraries:
        section = run("readelf", "-d", library)
        assert str(BUILD) not in section and "$ORIGIN" in section


def test_a_program_finds_the_installed_library(prefix, tmp_path):
    run("cmake", "-G", "Ninja", "-S", HERE / "consumer", "-B", tmp_path, f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", tmp_path)
    assert float(run(tmp_path / "consumer")) == 7.0


def test_the_package_tells_what_it_needs(package):
    fields = dict(re.findall(r"^ ?(\S+): (.*)$", run("dpkg-deb", "-f", package[0]), flags=re.MULTILINE))
    assert fields["Package"] == "paraview-surfacebooleans" and fields["Section"] == "science"
    assert re.search(r"paraview \(>= 5[.]", fields["Depends"]) and "python3-numpy" in fields["Depends"]
    assert len(fields["Description"]) < 80


def test_the_package_lists_the_plugin_where_paraview_looks(package):
    """In paraview.conf, beside ParaView's program or, from 5.13 on, in the place of ParaView's own."""
    _file, root = package
    (conf,) = root.rglob("paraview.conf")
    (listed,) = [line for line in conf.read_text().splitlines() if "surfacebooleans" in line]
    plugins = root / listed[1:] if listed.startswith("/usr/lib/") else conf.parent / listed
    modules = root / "usr/lib/python3/dist-packages"
    assert_works(run("pvpython", "-c", BOOLEAN, PYTHONPATH=str(modules), PV_PLUGIN_CONFIG_FILE=str(plugins)), root)


def test_the_package_replaces_no_list_of_paraview(package):
    """Where ParaView has a list of its own, it is put aside and comes back, and ours has all of its lines."""
    file, root = package
    (conf,) = root.rglob("paraview.conf")
    of_paraview = "/" / conf.relative_to(root)
    aside = of_paraview.with_name("paraview.conf.distrib")  # where this package is installed
    scripts = run("dpkg-deb", "-I", file).split()
    if conf.parent.name == "bin":
        assert "preinst" not in scripts
        return
    own = (aside if aside.exists() else of_paraview).read_text().splitlines()
    assert conf.read_text().splitlines() == [*own, "plugins/surfacebooleans.xml"]
    for script, change in (("preinst", "--add"), ("postrm", "--remove")):
        text = run("dpkg-deb", "-I", file, script)
        assert re.search(f"dpkg-divert .*{change} .*--divert {aside} {of_paraview} ", text)
