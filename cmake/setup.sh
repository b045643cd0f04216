#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the packages that the build needs on Debian 12, Debian 13 or Ubuntu 24.04; says and does
# nothing when they are there. As root, or as a user with sudo.
#
# usage: cmake/setup.sh [--checks]     --checks: also what .ci/run needs beyond the build
set -euo pipefail

packages=(
  catch2
  cmake
  dpkg-dev
  file
  g++
  help2man
  libceres-dev
  libcli11-dev
  libeigen3-dev
  libmrpt-io-dev
  libmrpt-maps-dev
  libmrpt-obs-dev
  libmrpt-slam-dev
  libopencv-dev
  ninja-build
  nlohmann-json3-dev
)
check_packages=(
  chromium
  clang-14
  clang-format-14
  clang-tidy-14
  doxygen
  libclang-rt-14-dev
  mrpt-apps
  mrpt-common
)

fail() {
  echo "setup: $*" >&2
  exit 1
}

case "${1-}" in
  "") ;;
  --checks) packages+=("${check_packages[@]}") ;;
  *) fail "unknown option $1 (usage: cmake/setup.sh [--checks])" ;;
esac

if ! command -v dpkg-query apt-get > /dev/null; then
  fail "this is no Debian or Ubuntu; install by hand what these packages hold: ${packages[*]}"
fi

# Prints the packages of the list that are not installed.
missing() {
  local installed
  installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "$@" 2> /dev/null |
    sed -n 's/^installed //p') || true
  local package
  for package in "$@"; do
    grep --quiet --line-regexp --fixed-strings -- "$package" <<< "$installed" || echo "$package"
  done
}

mapfile -t wanted < <(missing "${packages[@]}")
if [[ ${#wanted[@]} -eq 0 ]]; then
  exit 0
fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  command -v sudo > /dev/null ||
    fail "needs root or sudo to install: ${wanted[*]}"
  as_root=(sudo)
fi
# Some thousand lines that nobody wants to read, unless it fails.
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -o DPkg::Lock::Timeout=300 --quiet "$@" < /dev/null > "$log" 2>&1 ||
    { tail -n 20 "$log" >&2; return 1; }
}

echo "setup: installing ${wanted[*]} and what they need; this takes some minutes"
apt update ||
  echo "setup: the package lists could not be brought up to date; trying with the old ones" >&2
apt install --yes --no-install-recommends "${wanted[@]}" ||
  fail "apt-get could not install ${wanted[*]} (its reason stands above)"

mapfile -t wanted < <(missing "${packages[@]}")
if [[ ${#wanted[@]} -gt 0 ]]; then
  fail "still missing after the installation: ${wanted[*]}"
fi
