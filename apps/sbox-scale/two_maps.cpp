// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-scale/two_maps.h"

#include <algorithm>
#include <cstdio>

#include "sbox-scale/building.h"
#include "sbox-scale/merge_run.h"
#include "sbox/io/save_map.h"

namespace sbox::scale {
namespace {

/// Metres between where the corners of map b were placed and where they belong, at most.
double placementError(const nlohmann::json& pair, const Pose2D& truth, double side) {
  if (!pair["pose"].is_object()) {
    return -1;
  }
  const Pose2D found(pair["pose"]["x"], pair["pose"]["y"], pair["pose"]["phi"]);
  double error = 0;
  for (const Point2D& corner :
       {Point2D(0, 0), Point2D(side, side), Point2D(side, 0), Point2D(0, side)}) {
    error = std::max(error, (found.composePoint(corner) - truth.composePoint(corner)).norm());
  }
  return error;
}

}  // namespace

void printTwoMapsHeader() {
  std::printf("%6s %6s %8s %6s | %6s %8s %8s %6s %6s %6s %6s | %-9s %7s\n", "cells", "known",
              "seconds", "MiB", "load", "features", "matching", "verif.", "refin.", "fusion",
              "save", "verdict", "error m");
}

void measureTwoMaps(const std::string& command, int side, double known_side,
                    const std::filesystem::path& folder) {
  const double metres = side * cell_size, radius = known_side * cell_size / 2;
  const Building building(static_cast<int>(1.6 * std::min<double>(side, known_side)) + 400, 1);
  // What is seen of the building lies round the middle of the map, half of it in both.
  const Pose2D middle{-metres / 2, -metres / 2, 0};
  const Pose2D a = Pose2D(radius, radius, 0) + middle;
  const Pose2D b = Pose2D(1.8 * radius, 1.2 * radius, 0.35) + middle;
  saveMap(building.mapAt("a", a, side, radius), folder / "a.gridmap");
  saveMap(building.mapAt("b", b, side, radius), folder / "b.gridmap");
  const MergeRun run = runMerge(command, folder, {"a.gridmap", "b.gridmap"});
  if (!run.report.is_object()) {
    std::printf("%6d %6.0f  exit code %d after %.2f s\n", side, known_side, run.exit_code,
                run.seconds);
    return;
  }
  const auto& seconds = run.report["seconds"];
  const auto stage = [&](const char* name) { return seconds[name].get<double>(); };
  const auto& pair = run.report["pairs"][0];
  std::printf("%6d %6.0f %8.2f %6.0f | %6.2f %8.2f %8.2f %6.2f %6.2f %6.2f %6.2f | %-9s %7.3f\n",
              side, known_side, run.seconds, run.peak_mib, stage("load"), stage("features"),
              stage("matching"), stage("verification"), stage("refinement"), stage("fusion"),
              stage("save"), pair["verdict"].get<std::string>().c_str(),
              placementError(pair, inverse(a) + b, metres));
  std::fflush(stdout);
}

}  // namespace sbox::scale
