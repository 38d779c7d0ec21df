#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Makes panel.png: plays the clicks of panel.xml in ParaView's window; the last one takes the picture.
#
#   make demo && . build/env.sh && Screenshots/panel.sh [build/demo]      (needs imagemagick)
set -e
here=$(cd "$(dirname "$0")" && pwd)
SCREENSHOT_MESHES=$(cd "${1:-$here/../build/demo}" && pwd)
SCREENSHOT_FILE=$here/panel.png
SCREENSHOT_SCENE=$here/panel_scene.py
export SCREENSHOT_MESHES SCREENSHOT_FILE SCREENSHOT_SCENE
unset PV_MACRO_PATH # the macros would fill the second row
# -noreset: the server would else restart when its first client leaves, and lose the next one.
exec xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" \
  paraview -qwindowgeometry 1600x1000+0+0 --dr \
    --plugin-search-paths="$PV_PLUGIN_PATH" --plugins=SurfaceBooleans \
    --test-directory="${TMPDIR:-/tmp}" --test-script="$here/panel.xml" --exit
