#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
#
# What `make screenshots` runs, after the demos: draws every picture of this folder and of the help anew. The brain's
# surfaces are those that nilearn comes with; it is installed into the build folder. The windows need imagemagick and
# python3-pyqt5. Look at each picture before you commit it.
set -eu

here=$(dirname "$(readlink -f "$0")")
build=$(readlink -f "${BUILD:-build}")
venv=$build/gallery-venv

/usr/bin/python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps -r "$here/requirements.txt"
brain=$(echo "$venv"/lib/python3*/site-packages/nilearn/datasets/data/fsaverage5)

for script in "$here"/*.py; do
  if grep -q "__main__" "$script"; then
    echo "$(basename "$script" .py)"
    xvfb-run -a -s "-noreset" /usr/bin/python3 "$script" "$brain"
  fi
done
cp "$build/demo/drilled_elephant.png" "$here/demo.png"
cp "$build/demo/cat_screw.png" "$here/scan_demo.png"
echo windows
"$here/panel.sh" "$build/demo"
"$here/window.sh"
"$here/panels.sh"
echo help_pictures
xvfb-run -a -s "-noreset" pvpython "$here/help_pictures.py"
