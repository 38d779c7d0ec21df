# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The curves in which the two selected sources meet; with one, those in which it meets itself."""

from surfacebooleans import gui

gui.curves()
