#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Usage: install-packages.sh PYTHON FOLDER   Installs Python/requirements.txt for the tests into an environment of its own.
# Does nothing, quickly, where they are installed already.
set -e
python=$1
folder=$2
requirements=$(dirname "$(readlink -f "$0")")/../../Python/requirements.txt
cmp -s "$requirements" "$folder/installed.txt" && exit 0
"$python" -m venv --system-site-packages "$folder" || {
  echo "Python cannot make an environment: install the package python3-venv." >&2
  exit 1
}
"$folder/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps -r "$requirements"
cp "$requirements" "$folder/installed.txt"
