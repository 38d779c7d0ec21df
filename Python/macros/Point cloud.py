# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""A mesh of the selected cloud of points, coloured by its curvature."""

from surfacebooleans import gui

gui.point_cloud()
