// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// sbox-scale: time and memory that sbox-merge takes as maps grow.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "sbox-scale/building.h"
#include "sbox/io/save_map.h"
#include "sbox/stopwatch.h"

namespace {

namespace fs = std::filesystem;
using sbox::Pose2D;
using sbox::scale::Building;
using sbox::scale::cell_size;

struct Run {
  int exit_code = 0;
  double seconds = 0;
  double peak_mib = 0;  ///< Of resident memory.
  nlohmann::json report;
};

/// The command on a.gridmap and b.gridmap in the folder, with all that it writes by default.
Run runMerge(const std::string& command, const fs::path& folder) {
  const sbox::Stopwatch stopwatch;
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.c_str()) == 0) {
      execl(command.c_str(), "sbox-merge", "--in", "a.gridmap", "b.gridmap", "--report", "r.json",
            "-q", nullptr);
    }
    _exit(127);
  }
  Run run;
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  run.seconds = stopwatch.seconds();
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.peak_mib = static_cast<double>(usage.ru_maxrss) / 1024;
  std::ifstream file(folder / "r.json");
  run.report = nlohmann::json::parse(file, nullptr, false);
  return run;
}

/// Metres between where the corners of map b were placed and where they belong, at most.
double placementError(const nlohmann::json& pair, const Pose2D& truth, double side) {
  if (!pair["pose"].is_object()) {
    return -1;
  }
  const Pose2D found(pair["pose"]["x"], pair["pose"]["y"], pair["pose"]["phi"]);
  double error = 0;
  for (const sbox::Point2D& corner : {sbox::Point2D(0, 0), sbox::Point2D(side, side),
                                      sbox::Point2D(side, 0), sbox::Point2D(0, side)}) {
    error = std::max(error, (found.composePoint(corner) - truth.composePoint(corner)).norm());
  }
  return error;
}

void measure(const std::string& command, int side, double known_side, const fs::path& folder) {
  const double metres = side * cell_size, radius = known_side * cell_size / 2;
  const Building building(static_cast<int>(1.6 * std::min<double>(side, known_side)) + 400, 1);
  // What is seen of the building lies round the middle of the map, half of it in both.
  const Pose2D middle{-metres / 2, -metres / 2, 0};
  const Pose2D a = Pose2D(radius, radius, 0) + middle;
  const Pose2D b = Pose2D(1.8 * radius, 1.2 * radius, 0.35) + middle;
  sbox::saveMap(building.mapAt("a", a, side, radius), folder / "a.gridmap");
  sbox::saveMap(building.mapAt("b", b, side, radius), folder / "b.gridmap");
  const Run run = runMerge(command, folder);
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
              placementError(pair, sbox::inverse(a) + b, metres));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::string command =
      (fs::canonical("/proc/self/exe").parent_path().parent_path() / "sbox-merge" / "sbox-merge")
          .string();
  std::vector<int> sides{500, 1000, 2000, 5000, 10000};
  double known = 0;
  CLI::App app("Time and memory that sbox-merge takes to merge two maps of so many cells a side",
               "sbox-scale");
  app.add_option("--sides", sides, "Cells a side (default 500 1000 2000 5000 10000)");
  app.add_option("--known", known, "Cells across what is known of each map (default: the side)");
  app.add_option("--command", command, "The sbox-merge to measure (default: that of this build)");
  CLI11_PARSE(app, argc, argv);
  try {
    std::string folder = (fs::temp_directory_path() / "sbox-scale-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
      throw std::runtime_error("no temporary folder can be made");
    }
    std::printf("%6s %6s %8s %6s | %6s %8s %8s %6s %6s %6s %6s | %-9s %7s\n", "cells", "known",
                "seconds", "MiB", "load", "features", "matching", "verif.", "refin.", "fusion",
                "save", "verdict", "error m");
    for (const int side : sides) {
      measure(command, side, known > 0 ? known : side, folder);
    }
    fs::remove_all(folder);
  } catch (const std::exception& error) {
    std::cerr << "sbox-scale: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
