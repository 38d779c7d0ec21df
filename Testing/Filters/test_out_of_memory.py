# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where memory runs out every filter ends in one error, whichever of its blocks is the one that it does not get.

What has to be tried may crash, so it runs in processes of its own.
"""

import ctypes
import json
import os
import pathlib
import random
import resource
import subprocess
import sys

import pytest

from every_filter import FILTERS, OUT_OF_MEMORY, content, is_empty, run, status
from processes import in_another_process

LEAST_BLOCK = 16384  # bytes: VTK, Python and Open CASCADE themselves do not bear being refused less
LEAST_ALLOWED = 1 << 20  # bytes, under a limit, for the same reason
BLOCKS = 8  # a filter
SHARES = (0.01, 0.1, 0.3, 2.0)  # of the memory that the filter takes if it may

# Open CASCADE turns some refusals into failures of other kinds, or does without.
OWN_ANSWERS = {"NURBSReader"}


def memory(kind):
    """VmSize or VmPeak of this process in bytes."""
    return 1024 * int(pathlib.Path("/proc/self/status").read_text().split(f"{kind}:")[1].split()[0])


def outcome(made, errors, expected):
    if status(made) == OUT_OF_MEMORY and is_empty(made) and len(errors) == 1 and "memory" in errors[0]:
        return "refused"
    return "complete" if content(made) == expected and not errors else f"status {status(made)}, {errors}"


def with_limit(name, allowed=None):
    """How an update ends that may take so many bytes more; and how many it took."""
    made = FILTERS[name].make("large")
    before = memory("VmSize")
    if allowed is not None:
        resource.setrlimit(resource.RLIMIT_AS, (before + allowed, resource.RLIM_INFINITY))
    errors, _ = run(made)
    resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    return outcome(made, errors, content(made)), memory("VmPeak") - before


def without_blocks(name):
    """How updates end that get all blocks but one."""
    preloaded = ctypes.CDLL(None)
    preloaded.failing_memory_arm.argtypes = [ctypes.c_long, ctypes.c_size_t]
    preloaded.failing_memory_disarm.restype = ctypes.c_long
    made = FILTERS[name].make()
    preloaded.failing_memory_arm(0, LEAST_BLOCK)
    made.Update()
    count, expected = preloaded.failing_memory_disarm(), content(made)

    def task(block):
        made = FILTERS[name].make()
        preloaded.failing_memory_arm(block, LEAST_BLOCK)
        errors, _ = run(made)
        preloaded.failing_memory_disarm()
        how = outcome(made, errors, expected)
        made.Modified()
        errors, _ = run(made)
        return how, content(made) == expected and not errors

    chosen = sorted(random.Random(1968).sample(range(1, count + 1), min(count, BLOCKS)))
    return {block: in_another_process(lambda: task(block)) for block in chosen}


@pytest.fixture(scope="module")
def refusals():
    """By filter: {block: how an update ended without it, whether the next one was as ever}."""
    folder = pathlib.Path(os.environ["PV_PLUGIN_PATH"]).parents[2]
    done = subprocess.run(
        [sys.executable, __file__],
        env={**os.environ, "LD_PRELOAD": str(folder / "libsbFailingMemory.so")},
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


@pytest.mark.parametrize("name", FILTERS)
def test_a_block_that_is_refused_ends_the_update_and_harms_no_other(name, refusals):
    answers = refusals[name]
    assert len(answers) >= 5
    crashed = [block for block, answer in answers.items() if answer is None]
    assert not crashed
    refused = 0
    for block, (how, next_is_as_ever) in answers.items():
        assert next_is_as_ever, f"after block {block}"
        assert how in ("refused", "complete") or name in OWN_ANSWERS, f"block {block}: {how}"
        refused += how == "refused"
    assert refused > 0 or name in OWN_ANSWERS


@pytest.mark.parametrize("name", FILTERS)
def test_under_a_limit_there_is_an_error_or_the_result(name):
    FILTERS[name].make("large")  # whose inputs all processes then share
    how, taken = in_another_process(lambda: with_limit(name))
    assert how == "complete"
    for share in SHARES:
        answer = in_another_process(lambda: with_limit(name, LEAST_ALLOWED + int(share * taken)))
        assert answer is not None, f"crashed with {share} of the memory"
        assert answer[0] in ("refused", "complete") or name in OWN_ANSWERS, answer[0]
    assert answer[0] == "complete"


if __name__ == "__main__":
    print(json.dumps({name: without_blocks(name) for name in FILTERS}))
