# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exact Boolean operations on surfaces, for pvpython and plain python3."""

from pkgutil import extend_path

# The compiled modules lie in another folder in a build tree, and in this one after an installation.
__path__ = extend_path(__path__, __name__)
