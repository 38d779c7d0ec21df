#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
#
# What `make sanitize` runs: builds the kernel and its tests with the sanitizers given, without ParaView, and runs them.
# With "thread" only the tests that use threads.
set -eu

sanitizers=$1
here=$(dirname "$(readlink -f "$0")")
build=${BUILD:-build}/sanitize-$sanitizers

mkdir -p "$build"
cmake -G Ninja -S "$here" -B "$build" "-DSANITIZERS=$sanitizers" >"$build/configure.log"
cmake --build "$build" -j "$(nproc)"
ctest --test-dir "$build" -j "$(nproc)" --output-on-failure
