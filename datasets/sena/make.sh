#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the maps and the truth in this folder anew. A real log is cut in time into the runs of three
# robots, MRPT's icp-slam maps each on its own, and the truth is where icp-slam over the whole log
# puts the same scans. The files beside this script were made with MRPT 2.5.8.
#
# usage: datasets/sena/make.sh     Needs Debian's mrpt-apps and mrpt-common, and sbox-dataset built.
set -euo pipefail
folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
sbox_dataset=${folder}/../../build/release/apps/sbox-dataset/sbox-dataset
log="/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# slam NAME FIRST COUNT: the poses of COUNT scans from FIRST in NAME.txt.
slam() {
  "$sbox_dataset" cut --rawlog "$log" --first "$2" --count "$3" --out "$1.rawlog"
  icp-slam "$folder/icp-slam.ini" "$1.rawlog" > "$1.log" < /dev/null
  mv LOG/log_estimated_path.txt "$1.txt"
}
slam whole 0 224
slam robot_a 0 95
slam robot_b 80 90
slam robot_c 150 74

"$sbox_dataset" log --out "$folder" --environment sena --rawlog "$log" --poses whole.txt \
  --part robot_a 0 robot_a.txt --part robot_b 80 robot_b.txt --part robot_c 150 robot_c.txt
