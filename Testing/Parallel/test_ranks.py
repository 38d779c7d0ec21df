# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What comes out does not depend on the number of processes: batch, symmetric batch, and a server with its client."""

import contextlib
import json
import os
import shutil
import socket
import subprocess

import pytest

FOLDER = os.path.dirname(os.path.abspath(__file__))
SCENES = os.path.join(FOLDER, "scenes.py")
RANKS = int(os.environ.get("RANKS", "2"))
MINUTES = 10
OUT_OF_MEMORY = 22

# Containers run as root, and small machines have fewer cores than ranks; other MPIs take no notice of these.
MPI_SETTINGS = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
}

pytestmark = pytest.mark.skipif(
    not shutil.which("mpirun"), reason="mpirun is not installed, so nothing is said about several processes"
)


# Of glibc: what is freed goes back to the system, so that nothing is left of it under a limit.
NO_RESERVE = {"MALLOC_ARENA_MAX": "1", "MALLOC_MMAP_THRESHOLD_": "4096"}


def run(*command, **environment):
    """The lines that a program printed; it has to end well, and in time: ranks that wait for each other never do."""
    done = subprocess.run(
        command, env=os.environ | MPI_SETTINGS | environment, timeout=60 * MINUTES, text=True, capture_output=True, check=False
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    return (done.stdout + done.stderr).splitlines()


def with_ranks(*command, **environment):
    """As run, for a program of several processes."""
    return run("mpirun", "-np", str(RANKS), *command, **environment)


def facts(folder, name):
    """What a run of the scenes has written down."""
    with open(folder / name, encoding="utf-8") as file:
        return json.load(file)


@pytest.fixture(scope="module", name="folder")
def scene_folder(tmp_path_factory):
    """Where the runs write to."""
    return tmp_path_factory.mktemp("scenes")


@pytest.fixture(scope="module", name="alone")
def facts_of_one_process(folder):
    """The facts to compare with."""
    run("pvbatch", SCENES, str(folder / "alone.json"))
    return facts(folder, "alone.json")


def check_same(ours, theirs):
    """Every scene of ours, with the first difference named."""
    for scene, found in ours.items():
        assert found.keys() == theirs[scene].keys()
        for kind, value in theirs[scene].items():
            assert found[kind] == value, f"{scene}: {kind}"


def test_the_reference_is_worth_comparing_with(alone):
    """Results that are all empty would agree, too."""
    scenes = alone
    assert len(scenes) > 50
    filled = [name for name, fact in scenes.items() if fact["cells"] > 0]
    assert len(filled) > 0.7 * len(scenes)
    assert all(
        fact["fields"]["Status"] == [0.0] for name, fact in scenes.items() if name.startswith("Boolean of pieces") and "output 0" in name
    )


def test_batch(folder, alone):
    """The first process runs the script, the others follow; an error is told once and not by all."""
    lines = with_ranks("pvbatch", SCENES, str(folder / "batch.json"))
    assert facts(folder, "batch.json").keys() == alone.keys()
    check_same(facts(folder, "batch.json"), alone)
    for sentence in ("The difference needs a second surface", "Distances need a surface"):
        told = [line for line in lines if sentence in line]
        assert told and all("pvbatch.0" in line for line in told)


def test_server_and_client(folder, alone):
    """The filters run on the server, the client fetches the results."""
    with socket.socket() as free:
        free.bind(("localhost", 0))
        port = str(free.getsockname()[1])
    command = ["mpirun", "-np", str(RANKS), "pvserver", "--server-port=" + port]
    with subprocess.Popen(
        command, env=os.environ | MPI_SETTINGS, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as server:
        try:
            run("pvpython", SCENES, str(folder / "client.json"), "localhost", port)
            server.wait(timeout=60)
        finally:
            with contextlib.suppress(ProcessLookupError):
                server.terminate()
    ours = facts(folder, "client.json")
    assert ours.keys() == {name for name in alone if not name.endswith("cleaned")}
    check_same(ours, alone)


def test_symmetric_batch(folder):
    """All processes run the script: whichever of them stops a filter, none waits for ever, and the next update works.

    Arrays are the same in the processes that have no cells.
    """
    with_ranks("pvbatch", "--symmetric", os.path.join(FOLDER, "symmetric.py"), str(folder))
    reports = [facts(folder, f"rank{rank}.json") for rank in range(RANKS)]
    assert reports[0]["cells"] > 0
    assert all(report["cells"] == 0 for report in reports[1:])
    for report in reports[1:]:
        for kind in ("arrays", "fields", "status when the first stops", "status after it"):
            assert report[kind] == reports[0][kind], kind
    assert reports[0]["status when the first stops"] != 0
    assert reports[0]["status after it"] == 0
    assert reports[0]["status when the last stops"] == 0  # it has nothing to stop
    assert len({report["distance when the last stops"] for report in reports}) == 1
    assert reports[0]["distance when the last stops"] != 0
    assert all(report["distance after it"] == 0 for report in reports)


def test_too_little_memory_in_one_process(folder):
    """Whichever process it is, all end the update with the error and nothing, and none waits for ever or crashes."""
    with_ranks("pvbatch", "--symmetric", os.path.join(FOLDER, "scarce_memory.py"), str(folder), **NO_RESERVE)
    reports = [facts(folder, f"memory{rank}.json") for rank in range(RANKS)]
    assert len(reports[0]) >= 7
    for name in reports[0]:
        for kind, (status, has_points) in ((kind, answer) for report in reports for kind, answer in report[name].items()):
            expected = OUT_OF_MEMORY if "none" not in kind else 0
            assert status == expected, f"{name}: {kind}"
            assert not (status and has_points), f"{name}: {kind}"
        assert all(reports[0][name][kind][1] for kind in ("none is poor", "none is poor again")), name
