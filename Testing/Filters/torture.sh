#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
#
# What `make torture` runs: torture.py, with manifold3d as its second judge in a private environment.
set -eu

here=$(dirname "$(readlink -f "$0")")
environment=$1
shift
/usr/bin/python3 -m venv --system-site-packages "$environment"
"$environment/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps manifold3d==3.5.4
PYTHONDONTWRITEBYTECODE=1 exec "$environment/bin/python" "$here/torture.py" "$@"
