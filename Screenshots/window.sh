#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Makes window.png: plays the clicks of window.xml on the toolbar in ParaView's window; the last one takes the picture.
#
#   . build/env.sh && Screenshots/window.sh      (needs imagemagick)
set -e
here=$(cd "$(dirname "$0")" && pwd)
SCREENSHOT_FILE=$here/window.png
SCREENSHOT_SCENE=$here/window_scene.py
export SCREENSHOT_FILE SCREENSHOT_SCENE
unset PV_MACRO_PATH # the macros would fill the second row
# -noreset: the server would else restart when its first client leaves, and lose the next one.
exec xvfb-run -a -s "-screen 0 1280x800x24 -noreset" \
  paraview -qwindowgeometry 1280x800+0+0 --dr \
    --plugin-search-paths="$PV_PLUGIN_PATH" --plugins=SurfaceBooleans \
    --test-directory="${TMPDIR:-/tmp}" --test-script="$here/window.xml" --exit
