#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the maps and the truth in this folder anew, by two simulated robots that drive their paths
# through office.world.
#
# usage: datasets/office/make.sh     Needs sbox-dataset built.
set -euo pipefail
folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

"$folder/../../build/release/apps/sbox-dataset/sbox-dataset" simulate \
  --out "$folder" --environment office --world "$folder/office.world" \
  --path "$folder/robot_a.path" --path "$folder/robot_b.path" --seed 1
