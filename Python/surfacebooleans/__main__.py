# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""``python3 -m surfacebooleans`` and ``pvpython -m surfacebooleans``."""

import signal
import sys

from surfacebooleans.command_line import main

signal.signal(signal.SIGINT, signal.default_int_handler)  # pvpython leaves it to the system, which would just kill it
sys.exit(main())
