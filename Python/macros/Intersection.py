# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is inside both selected sources: the first one is the Input, the second one the Tool."""

from surfacebooleans import gui

gui.boolean("Intersection")
