#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
# Installs what building and testing needs beyond a bare Debian 12 or 13. Does nothing, quickly, where all of it is there.
set -e

# On other systems CMake says what it misses.
command -v dpkg-query >/dev/null || exit 0

# ParaView itself, and the -dev packages that find_package(ParaView) asks for but paraview-dev does not pull in.
packages="
  paraview paraview-dev python3-paraview
  g++ make cmake ninja-build dpkg-dev file
  python3-dev
  libopenmpi-dev openmpi-bin libeigen3-dev libutfcpp-dev
  libexpat1-dev liblzma-dev liblz4-dev libdouble-conversion-dev zlib1g-dev
  libocct-foundation-dev libocct-modeling-data-dev libocct-modeling-algorithms-dev libocct-data-exchange-dev
  libocct-ocaf-dev libtbb-dev
  python3-numpy python3-pytest python3-venv libboost-dev libcgal-demo occt-misc
  xvfb xauth
"

# The Qt of ParaView's window, and the part of it that draws ParaView's icons: 5 in Debian 12, 6 from 13 on.
if grep -q '^VERSION_ID="12"' /etc/os-release; then
  packages="$packages qtbase5-dev qttools5-dev libqt5svg5"
else
  packages="$packages qt6-base-dev qt6-tools-dev qt6-tools-dev-tools qt6-documentation-tools qt6-svg-plugins"
fi

# shellcheck disable=SC2086  # one word a package, here and below
installed=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' $packages 2>/dev/null | sed -n 's/^ii *//p' | tr '\n' ' ')
missing=""
for package in $packages; do
  case " $installed" in
    *" $package "*) ;;
    *) missing="$missing $package" ;;
  esac
done
[ -z "$missing" ] && exit 0

if [ "$(id -u)" -ne 0 ]; then
  echo "These packages are missing; install them, then run make again:" >&2
  echo "  sudo apt-get install --no-install-recommends$missing" >&2
  exit 1
fi
export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
apt-get install -y -qq --no-install-recommends $missing
