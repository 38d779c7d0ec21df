# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is inside one of the two selected sources, but not inside both."""

from surfacebooleans import gui

gui.boolean("Symmetric Difference")
