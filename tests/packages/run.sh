#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the Debian packages, unpacks them into a scratch folder and uses what they hold there.
# Nothing is installed.
#
# usage: tests/packages/run.sh SOURCE_FOLDER BUILD_FOLDER
set -euo pipefail
source=$1
build=$2

fail() {
  echo "packages: $*" >&2
  exit 1
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
cpack --config "$build/CPackConfig.cmake" -B "$scratch"

commands=(sbox-merge_*.deb)
library=(libsbox-dev_*.deb)
dpkg-deb --extract "${commands[0]}" commands
dpkg-deb --extract "${library[0]}" library

[[ $(dpkg-deb --field "${commands[0]}" Depends) == *libmrpt-maps* ]] ||
  fail "sbox-merge does not ask for MRPT"
for package in "${commands[0]}" "${library[0]}"; do
  ! dpkg-deb --field "$package" Description | grep --quiet '^  ' ||
    fail "the description of $package is set as verbatim text"
done
commands/usr/bin/sbox-merge --out merged.gridmap --quiet \
  --in "$source"/datasets/sena/robot_{a,c}.gridmap.gz
[[ -s merged.gridmap ]] || fail "the command of the package merged nothing"
for file in share/man/man1/sbox-merge.1 share/bash-completion/completions/sbox-merge \
    share/doc/sbox-merge/copyright; do
  [[ -s commands/usr/$file ]] || fail "sbox-merge lacks $file"
done
if [[ -e library/usr/lib/cmake/sbox/sbox-slam-targets.cmake ]]; then
  # Logs go to the program with SLAM, which looks for the files.
  commands/usr/bin/sbox-merge --in no.rawlog no_other.rawlog 2> said.txt || true
  grep --quiet "no.rawlog: .*no such file" said.txt || fail "logs: $(cat said.txt)"
fi
[[ ! -e commands/usr/include ]] || fail "sbox-merge holds headers"
for file in include/sbox/merge.h lib/cmake/sbox/sbox-config.cmake share/doc/libsbox-dev/copyright; do
  [[ -s library/usr/$file ]] || fail "libsbox-dev lacks $file"
done
[[ ! -e library/usr/bin ]] || fail "libsbox-dev holds commands"

# All headers of the library compile together, with nothing but what its CMake package asks for.
component=""
if [[ -e library/usr/lib/cmake/sbox/sbox-slam-targets.cmake ]]; then
  component=slam
fi
mkdir headers
(cd library/usr/include && find sbox -name '*.h' | sort | sed 's/.*/#include <&>/') > headers/all.cpp
cat > headers/CMakeLists.txt << END
cmake_minimum_required(VERSION 3.18)
project(headers LANGUAGES CXX)
find_package(sbox REQUIRED COMPONENTS $component)
add_library(headers OBJECT all.cpp)
target_link_libraries(headers PRIVATE sbox::${component:-sbox})
END
cmake -G Ninja -S headers -B headers/build -DCMAKE_PREFIX_PATH="$scratch/library/usr" \
  --log-level=WARNING
cmake --build headers/build || fail "the headers of libsbox-dev do not compile together"

# Every package that the library's CMake package looks for comes with it.
depends=$(dpkg-deb --field "${library[0]}" Depends)
while read -r wanted; do
  package=$(tr '[:upper:]' '[:lower:]' <<< "$wanted")
  case $package in
    threads) ;;
    *) [[ $depends == *"lib${package%3}"*-dev* ]] || fail "libsbox-dev does not ask for $wanted" ;;
  esac
done < <(sed -n 's/.*find_dependency(\([A-Za-z0-9-]*\).*/\1/p' library/usr/lib/cmake/sbox/sbox-config.cmake)
