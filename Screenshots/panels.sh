#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Makes pictures of every filter's panel in ParaView's window: NAME.png, NAME-advanced.png and NAME-window.png.
#
#   make demo && . build/env.sh && Screenshots/panels.sh FOLDER [FILTER...]    (needs imagemagick and python3-pyqt5)
set -e
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
SCREENSHOT_FOLDER=$(cd "$1" && pwd)
shift
SCREENSHOT_MESHES=$SCREENSHOT_FOLDER
PYTHONPATH=$here:$here/../Python:$PYTHONPATH
export SCREENSHOT_FOLDER SCREENSHOT_MESHES PYTHONPATH
[ $# -eq 0 ] || export SCREENSHOT_FILTERS="$*"
# -noreset: the server would else restart when its first client leaves, and lose the next one.
exec xvfb-run -a -s "-screen 0 1600x1300x24 -noreset" \
  paraview -qwindowgeometry 1600x1300+0+0 --dr \
    --plugin-search-paths="$PV_PLUGIN_PATH" --plugins=SurfaceBooleans --script="$here/panels.py"
