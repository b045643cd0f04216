#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The manual page beside the command has an entry for each option of --help, and formats well.
#
# usage: tests/apps/man_page.sh SBOX_MERGE
set -euo pipefail
command=$1
page=$(dirname "$command")/sbox-merge.1

fail() {
  echo "$page: $*" >&2
  exit 1
}

for section in NAME SYNOPSIS DESCRIPTION OPTIONS FILES EXAMPLES; do
  grep --quiet --line-regexp "\.SH $section" "$page" || fail "has no section $section"
done
count=0
while read -r option; do
  # Headings follow .TP; hyphens are escaped.
  grep --after-context=1 --line-regexp '\.TP' "$page" | sed 's/\\-/-/g; s/\\f[A-Z]//g' |
    grep --quiet --extended-regexp -- "(^|,) *$option( |$)" || fail "has no entry for $option"
  count=$((count + 1))
done < <("$command" --help | sed -nE 's/^ +(-[a-z], *)?(--[a-z-]+).*/\2/p')
[[ $count -ge 10 ]] || fail "--help names only $count options"

if command -v groff > /dev/null; then
  warnings=$(groff -man -ww -Tascii "$page" 2>&1 > /dev/null)
  [[ -z $warnings ]] || fail "$warnings"
fi
