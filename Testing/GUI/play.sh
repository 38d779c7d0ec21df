#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Usage: play.sh SCRIPT.xml FOLDER [OPTION OF PARAVIEW...]   Plays recorded clicks in ParaView's window, on a display of its own. ParaView ends with
# an error where a click finds no widget. The script has to print PASSED at its end, as it does in ParaView's Python shell after
# looking at the result; an error message of a filter is a failure too.
set -e
script=$1
folder=$2
shift 2
mkdir -p "$folder"
# Scripts import what the other tests have, and write there.
export SURFACEBOOLEANS_TESTS=${0%/*}/.. SURFACEBOOLEANS_FOLDER=$folder
status=0
# -noreset: the server would else restart when its first client leaves, and lose the next one.
xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" \
  paraview --dr --plugin-search-paths="$PV_PLUGIN_PATH" --plugins=SurfaceBooleans \
    --test-directory="$folder" --test-script="$script" "$@" --exit >"$folder/log.txt" 2>&1 || status=$?
cat "$folder/log.txt"
if [ "$status" -ne 0 ] || ! grep -q "^PASSED" "$folder/log.txt" || grep -qE "ERR\||^FAILED" "$folder/log.txt"; then
  echo "The playback of $script failed (exit status $status)."
  exit 1
fi
