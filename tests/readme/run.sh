#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs the commands of README.md as they stand there: what its "sh" blocks hold, in order, in one
# shell and a scratch folder, with the files whose first line names them in its "cpp" and "cmake"
# blocks. Left out are only apps/demo.sh (a test of its own) and tests/run.sh (which runs this).
#
# usage: tests/readme/run.sh SOURCE_FOLDER BUILD_FOLDER
set -euo pipefail
source=$1
build=$2

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
mkdir build home merge_two
ln -s "$build" build/release
ln -s "$source/datasets" datasets

awk '
  /^```/ {
    language = inside ? "" : substr($0, 4)
    inside = !inside
    file = language == "sh" ? "commands.sh" : ""
    next
  }
  inside && (language == "cpp" || language == "cmake") && file == "" { file = $2 }
  inside && file != "" { print > file }
' "$source/README.md"

# The two commands: as lines of their own, and files that can be run.
for command in apps/demo.sh tests/run.sh; do
  grep --quiet --line-regexp --fixed-strings "$command" commands.sh ||
    { echo "README.md does not show the command $command" >&2; exit 1; }
  [[ -x $source/$command ]] || { echo "$command cannot be run" >&2; exit 1; }
  sed -i "\|^$command\$|d" commands.sh
done

HOME=$scratch/home bash -euxo pipefail commands.sh < /dev/null

for file in merged.yaml merged.png report.json page.html poses.yaml options.ini fleet.gridmap both.gridmap; do
  [[ -s $file ]] || { echo "the commands of README.md did not make $file" >&2; exit 1; }
done
