# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The first selected source minus all others."""

from surfacebooleans import gui

gui.boolean("Difference")
