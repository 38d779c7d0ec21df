# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The selected result in the colours of the blocks that its parts come from, with their names."""

from surfacebooleans import gui

gui.blocks()
