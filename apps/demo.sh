#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what the build needs, builds sbox-merge in build/release and merges two maps that two
# robots made of one real building. Map, report and pictures go to build/demo.
#
# usage: apps/demo.sh [options for sbox-merge, such as --method paper]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

cmake/setup.sh

# Ninja tells one line a file where it cannot overwrite its last line.
quiet=()
if [[ ! -t 1 ]]; then
  quiet=(-- --quiet)
fi
mkdir -p build
cmake --preset release --log-level=WARNING > build/demo-configure.log 2>&1 ||
  { cat build/demo-configure.log >&2; exit 1; }
echo "demo: building sbox-merge in build/release; this takes some minutes the first time"
cmake --build --preset release --parallel "$(nproc)" --target sbox-merge "${quiet[@]}"

rm -rf build/demo
mkdir build/demo
code=0
build/release/apps/sbox-merge/sbox-merge \
  --in datasets/sena/robot_a.gridmap.gz datasets/sena/robot_c.gridmap.gz \
  --out build/demo/merged.gridmap --report build/demo/report.json --pictures build/demo/pictures \
  "$@" || code=$?

case $code in
  0) echo "The two maps are one now: build/demo/merged.png" ;;
  3) echo "sbox-merge found no answer it is sure of, and merged nothing; its reason stands above." ;;
  *) exit "$code" ;;
esac
echo "What it saw and why, in build/demo/pictures:"
(cd build/demo/pictures && printf '  %s\n' *.png)
exit "$code"
