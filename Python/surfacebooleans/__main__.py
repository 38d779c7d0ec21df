# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""``python3 -m surfacebooleans`` and ``pvpython -m surfacebooleans``."""

import sys

from surfacebooleans.command_line import main

sys.exit(main())
