# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The session as a state file of either kind, and a session from it."""

from paraview import simple, smstate

KINDS = ("pvsm", "py")


def save(file):
    """A path's suffix is the kind. SaveState would write XML into a .py file, too."""
    if file.suffix == ".pvsm":
        simple.SaveState(str(file))
    else:
        file.write_text(smstate.get_state())


def load(file):
    if file.suffix == ".pvsm":
        simple.LoadState(str(file))
    else:
        exec(compile(file.read_text(), str(file), "exec"), {})


def replay(kind, folder):
    """Everything there is goes into a file of a kind, and comes out of it into an empty session."""
    file = folder / f"state.{kind}"
    save(file)
    simple.ResetSession()
    load(file)
