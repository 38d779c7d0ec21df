#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Usage: run-in-build.sh BUILD COMMAND...   Runs the command as after `. BUILD/env.sh`.
set -e
. "$1/env.sh"
shift
exec "$@"
