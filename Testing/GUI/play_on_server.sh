#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Usage: play_on_server.sh SCRIPT.xml FOLDER   As play.sh, with the window connected to a server of two processes, each of
# which has a piece of all data.
set -e
folder=$2
mkdir -p "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
port=$("${PYTHON:-/usr/bin/python3}" -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
# On a display, too: the window would else ask whether to go on without rendering there. In a group of its own, to be ended.
setsid xvfb-run -a -s "-noreset" mpirun --oversubscribe --mca mpi_yield_when_idle 1 -np 2 pvserver --server-port="$port" >"$folder/server.txt" 2>&1 &
server=$!
trap 'kill -- -$server 2>/dev/null || true' EXIT
seconds=0
until grep -q "Accepting connection" "$folder/server.txt"; do
  seconds=$((seconds + 1))
  if [ "$seconds" -gt 60 ]; then
    cat "$folder/server.txt"
    echo "The server did not start."
    exit 1
  fi
  sleep 1
done
status=0
"${0%/*}/play.sh" "$1" "$folder" --server-url="cs://localhost:$port" || status=$?
if [ "$status" -ne 0 ] || grep -q "ERR|" "$folder/server.txt"; then
  cat "$folder/server.txt"
  exit 1
fi
