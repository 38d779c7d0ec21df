# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tries what may crash in a process of its own, forked from one in which everything is loaded."""

import json
import os


def in_another_process(task):
    """What the task returns; None if it crashed."""
    reading, writing = os.pipe()
    process = os.fork()
    if process == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
        os.write(writing, json.dumps(task()).encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as answer:
        text = answer.read()
    return json.loads(text) if os.waitpid(process, 0)[1] == 0 else None
