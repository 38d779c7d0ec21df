# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the recipes raise and warn with: always one plain sentence, that of the filter where a filter says it."""


class SurfaceBooleansError(RuntimeError):
    """A filter could not give a result.

    Attributes
    ----------
    status : int
        The filter's ``Status`` (a table of the numbers is in the README); -1 if it did not come so far.
    """

    def __init__(self, sentence, status=-1):
        super().__init__(sentence)
        self.status = status


class FileError(SurfaceBooleansError):
    """A file could not be read or written."""


class SurfaceBooleansWarning(UserWarning):
    """There is a result, and something about it that one should know."""
