#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes merge.png in this folder, the picture at the top of README.md: the matched boxes of two
# robots' maps, and one map over the other, as `sbox-merge --pictures` draws them.
#
# usage: datasets/sena/picture.sh     Needs Debian's imagemagick, and sbox-merge built.
set -euo pipefail
folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$folder/../../build/release/apps/sbox-merge/sbox-merge" --quiet \
  --in "$folder/robot_a.gridmap.gz" "$folder/robot_c.gridmap.gz" \
  --out "$work/merged.gridmap" --pictures "$work"
convert \( "$work/boxes_robot_a_robot_c.png" -resize x760 \) \
  \( "$work/overlay_robot_a_robot_c.png" -resize x760 \) \
  -background white -gravity center +append +dither -colors 64 -strip "PNG8:$folder/merge.png"
