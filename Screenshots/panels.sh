#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Makes panels/NAME.png: ParaView's window with the panel of every filter, or of those that are named.
#
#   . build/env.sh && Screenshots/panels.sh [FILTER...]    (needs imagemagick and python3-pyqt5)
set -e
/usr/bin/python3 -c "import PyQt5" 2>/dev/null || { echo "The pictures of panels need python3-pyqt5." >&2; exit 1; }
here=$(cd "$(dirname "$0")" && pwd)
SCREENSHOT_MESHES=$(mktemp -d)
trap 'rm -rf "$SCREENSHOT_MESHES"' EXIT
SCREENSHOT_FOLDER=$here/panels
mkdir -p "$SCREENSHOT_FOLDER"
PYTHONPATH=$here:$here/../Python:$PYTHONPATH
export SCREENSHOT_FOLDER SCREENSHOT_MESHES PYTHONPATH
unset PV_MACRO_PATH # the macros would fill the second row
[ $# -eq 0 ] || export SCREENSHOT_FILTERS="$*"
# -noreset: the server would else restart when its first client leaves, and lose the next one.
xvfb-run -a -s "-screen 0 1280x960x24 -noreset" \
  paraview -qwindowgeometry 1280x960+0+0 --dr \
    --plugin-search-paths="$PV_PLUGIN_PATH" --plugins=SurfaceBooleans --script="$here/panels.py"
