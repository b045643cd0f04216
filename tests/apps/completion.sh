#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What the shell offers at the end of some command lines.
#
# usage: tests/apps/completion.sh SBOX_MERGE COMPLETION_FILE
# Not -e: the shell completes without it, and compopt fails outside of a real completion.
set -uo pipefail
command=$1
# shellcheck source=/dev/null
source "$2"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
touch a.gridmap b.yaml
mkdir pictures

failures=0
# offers WORDS... = EXPECTED...: the last of WORDS is the one to be completed.
offers() {
  COMP_WORDS=("$command")
  while [[ $1 != = ]]; do
    COMP_WORDS+=("$1")
    shift
  done
  shift
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _sbox_merge "$command" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
  local offered expected
  offered=$(printf '%s\n' "${COMPREPLY[@]}" | sort | paste -s -d' ')
  expected=$(printf '%s\n' "$@" | sort | paste -s -d' ')
  if [[ $offered != "$expected" ]]; then
    echo "after ${COMP_WORDS[*]:1}: offered [$offered], expected [$expected]" >&2
    failures=$((failures + 1))
  fi
}

offers --fus = --fusion
offers --in a.gridmap --pic = --pictures
offers --fusion "" = logodds observations table
offers --fusion t = table
offers --in "" = a.gridmap b.yaml pictures
offers --in a.gridmap b = b.yaml
offers --pictures "" = pictures
offers --config pic = pictures
offers --threads "" =
offers --quiet --all = --all-groups

# Without a word, everything that --help names.
COMP_WORDS=("$command" "")
COMP_CWORD=1
_sbox_merge "$command" "" "$command"
while read -r option; do
  [[ " ${COMPREPLY[*]} " == *" $option "* ]] ||
    { echo "$option is not offered" >&2; failures=$((failures + 1)); }
done < <("$command" --help | sed -nE 's/^ +(-[a-z], *)?(--[a-z-]+).*/\2/p')
exit $((failures > 0))
