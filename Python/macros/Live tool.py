# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The first selected source minus the second one, which can be dragged in the view: the result follows."""

from surfacebooleans import gui

gui.live_tool()
