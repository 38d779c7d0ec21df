#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Usage: play.sh SCRIPT.xml FOLDER [OPTION OF PARAVIEW...]   Plays recorded clicks in ParaView's window, on a display of its own. ParaView ends with
# an error where a click finds no widget. The script has to print PASSED at its end, as it does in ParaView's Python shell after
# looking at the result. An error message is a failure, too, unless the script has a line <!-- Expected message: ... -->; such
# a message has to come.
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
sed -n 's/^<!-- Expected message: \(.*\) -->$/\1/p' "$script" >"$folder/expected.txt"
while read -r message; do
  grep -qF "$message" "$folder/log.txt" || { echo "Nobody said: $message"; status=1; }
done <"$folder/expected.txt"
if [ "$status" -ne 0 ] || ! grep -q "^PASSED" "$folder/log.txt" || grep -q "^FAILED" "$folder/log.txt" \
  || grep "ERR|" "$folder/log.txt" | grep -v "ERR| ERROR: In .*, line [0-9]*$" | grep -qvFf "$folder/expected.txt"; then
  echo "The playback of $script failed (exit status $status)."
  exit 1
fi
