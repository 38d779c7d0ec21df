#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
#
# What `make fuzz` runs: builds the fuzzers with clang and sanitizers, lets each search for the given number of seconds
# from its corpus on, and adds what reaches new code to the corpus. A finding stops it: its file, in build/fuzz/findings,
# belongs into the corpus once it is understood.
set -eu

seconds=$1
here=$(dirname "$(readlink -f "$0")")
build=${BUILD:-build}/fuzz

command -v clang++ >/dev/null || {
  echo "The fuzzers need clang and its libFuzzer: install the packages clang and libclang-rt-14-dev." >&2
  exit 1
}
mkdir -p "$build/findings"
cmake -G Ninja -S "$here" -B "$build" -DCMAKE_CXX_COMPILER=clang++ >"$build/configure.log"
cmake --build "$build"

for source in "$here"/Fuzz*.cxx; do
  name=$(basename "$source" .cxx)
  found=$build/$name-corpus
  mkdir -p "$found" "$here/corpus/$name"
  "$build/$name" "$found" "$here/corpus/$name" -max_len=160 -timeout=30 -max_total_time="$seconds" \
    -artifact_prefix="$build/findings/$name-" -print_final_stats=1
  "$build/$name" -merge=1 "$here/corpus/$name" "$found"
done
