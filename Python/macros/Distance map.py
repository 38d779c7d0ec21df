# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The first selected source coloured by its distance to the second one, with a histogram."""

from surfacebooleans import gui

gui.distance_map()
