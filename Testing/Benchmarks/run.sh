#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
#
# What `make bench` runs: installs the peers into bench-venv in the build directory, of which nothing else in the project
# knows, and compares. PEERS=all adds the peers whose licences allow non-commercial use only. Arguments go to compare.py,
# compare_distances.py and compare_points.py.
set -eu

here=$(dirname "$(readlink -f "$0")")
cd "$here/../.."
build=${BUILD:-build}
venv=$build/bench-venv

if [ ! -f "$build/env.sh" ]; then
  echo "$build/env.sh is missing: run 'make build' first." >&2
  exit 1
fi
if ! /usr/bin/python3 -m venv "$venv"; then
  echo "Python cannot make a private environment: install the package python3-venv." >&2
  exit 1
fi

set -- --environment "$build/env.sh" --output "$build/bench.json" "$@"
requirements="-r $here/requirements.txt"
if [ "${PEERS:-permissive}" = all ]; then
  requirements="$requirements -r $here/requirements-noncommercial.txt"
  set -- --peers all "$@"
fi
# shellcheck disable=SC2086 # each word of it is an argument of its own
"$venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps $requirements

if ! ldconfig -p | grep -q libusb-1.0; then # Open3D links it
  if [ "$(id -u)" -eq 0 ]; then
    apt-get install -y -qq --no-install-recommends libusb-1.0-0
  else
    echo "Open3D cannot take part: install the package libusb-1.0-0." >&2
  fi
fi

PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE
status=0
"$venv/bin/python" "$here/compare.py" "$@" || status=$?
"$venv/bin/python" "$here/compare_distances.py" "$@" || { second=$?; [ "$status" -eq 0 ] && status=$second; }
"$venv/bin/python" "$here/compare_points.py" "$@" || { third=$?; [ "$status" -eq 0 ] && status=$third; }
exit "$status"
