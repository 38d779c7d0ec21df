# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong with the selected surface, and where, with the verdict in words."""

from surfacebooleans import gui

gui.check()
