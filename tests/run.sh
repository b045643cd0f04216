#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what the build needs, builds everything in build/release and runs all tests.
#
# usage: tests/run.sh [options for CMake, such as -DSBOX_WERROR=ON]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

cmake/setup.sh
cmake --preset release --log-level=WARNING "$@"
cmake --build --preset release --parallel "$(nproc)"
ctest --preset release --parallel "$(nproc)"
