#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the fuzzers in build/fuzz and runs each for a bounded time, from the inputs that are kept in
# tests/fuzz/corpus. An input that breaks a rule is left in build/fuzz/found, and the run fails.
#
# usage: tests/fuzz/run.sh [SECONDS each, default 20] [NAMES of fuzzers, default all]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

seconds=${1:-20}
names=("${@:2}")
if [[ ${#names[@]} -eq 0 ]]; then
  for folder in tests/fuzz/corpus/*/; do
    names+=("$(basename "$folder")")
  done
fi

cmake --preset fuzz --log-level=WARNING > /dev/null
cmake --build --preset fuzz --parallel "$(nproc)" --target "${names[@]/#/fuzz-}"
found=$PWD/build/fuzz/found
mkdir -p "$found"

fuzz() {
  local name=$1 work
  work=$(mktemp -d)
  # What a run learns goes into the first folder, which is not the one that is kept.
  if build/fuzz/tests/fuzz/"fuzz-$name" "$work" "tests/fuzz/corpus/$name" \
    -seed=1 -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3072 -max_len=4096 \
    -artifact_prefix="$found/$name-" -print_final_stats=1 > "$work.log" 2>&1; then
    printf 'fuzz-%s: %s inputs tried, none broke a rule\n' "$name" \
      "$(sed -n 's/^stat::number_of_executed_units: *//p' "$work.log")"
    rm -rf "$work" "$work.log"
  else
    tail -n 40 "$work.log" >&2
    printf 'fuzz-%s: an input breaks a rule, see %s\n' "$name" "$found" >&2
    rm -rf "$work" "$work.log"
    return 1
  fi
}
export -f fuzz
export seconds found
printf '%s\n' "${names[@]}" | xargs -P "$(nproc)" -I{} bash -c 'fuzz {}'
