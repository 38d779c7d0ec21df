# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The union of the selected sources: select two or more in the Pipeline Browser, then click."""

from surfacebooleans import gui

gui.boolean("Union")
