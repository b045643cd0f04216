#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs the commands of README.md's section on MRPT (its "bash" blocks) in a scratch folder, from
# rawlogs to a localised robot. Ends in 77 (skipped) where MRPT's programs or data are missing.
#
# usage: tests/readme/mrpt.sh SOURCE_FOLDER BUILD_FOLDER
set -euo pipefail
source=$1
build=$2

command -v pf-localization > /dev/null ||
  { echo "skipped: pf-localization (mrpt-apps) is missing"; exit 77; }
[[ -d /usr/share/mrpt/datasets ]] || { echo "skipped: mrpt-common is missing"; exit 77; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
ln -s "$source/lib" lib
mkdir build
ln -s "$build" build/release

# Without the installation of what was just found to be there.
awk '/^```/ { inside = substr($0, 4) == "bash"; next } inside && !/^apt-get/' \
  "$source/README.md" > commands.sh
grep --quiet pf-localization commands.sh ||
  { echo "README.md does not show how to go on with pf-localization" >&2; exit 1; }
PATH=$build/apps/sbox-merge:$PATH
bash -euo pipefail commands.sh < /dev/null > output.txt 2>&1 || { tail output.txt >&2; exit 1; }

for file in merged.gridmap merged.simplemap merged_robot1.simplemap report.json; do
  [[ -s $file ]] || { echo "the commands of README.md did not make $file" >&2; exit 1; }
done
# The built-in settings of SLAM are such that MRPT's own programs take them, too.
for slam in icp rbpf; do
  $slam-slam "lib/sbox/slam/settings/$slam-slam.ini" robot1.rawlog < /dev/null > $slam.txt 2>&1 ||
    { tail $slam.txt >&2; exit 1; }
  [[ -s $slam-slam-log/log_estimated_path.txt ]] || { echo "$slam-slam found no path" >&2; exit 1; }
done
# At the end the robot knows where it is: within 0.5 m of where SLAM over the whole drive puts it.
found() {
  grep "PDF estimation" localisation.log | tail -n 1 | sed 's/.*PDF estimation: (\(.*\)deg).*/\1/' |
    awk -F , '{ exit !(($1 - 4.27)^2 + ($2 + 18.54)^2 < 0.25 && ($3 + 87.5)^2 < 100) }'
}
# MRPT seeds its filter by the time, and from anywhere it settles in a wrong place now and then.
for _ in 1 2; do
  found || pf-localization lib/sbox/slam/settings/pf-localization.ini > localisation.log
done
found || { echo "pf-localization did not find the robot" >&2; tail -n 1 output.txt >&2; exit 1; }
