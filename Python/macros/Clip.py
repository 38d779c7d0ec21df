# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The selected closed surface clipped through its middle; drag the plane."""

from surfacebooleans import gui

gui.clip()
