// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// sbox-dataset: makes map pairs with known truth: from a simulated world, from a real log, or from
// other pairs.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <tuple>
#include <vector>

#include "command_line.h"
#include "sbox-dataset/cut_pairs.h"
#include "sbox-dataset/drive.h"
#include "sbox-dataset/fleet.h"
#include "sbox-dataset/logged_runs.h"
#include "sbox-dataset/office.h"
#include "sbox-dataset/rawlog_file.h"
#include "sbox-dataset/route.h"
#include "sbox-dataset/world.h"
#include "sbox-dataset/world_grid.h"
#include "sbox-dataset/write_dataset.h"

namespace {

using namespace sbox::dataset;
using sbox::Pose2D;

struct SimulateArguments {
  std::string world;
  std::vector<std::string> paths;
  std::uint32_t seed = 1;
  bool plan = false;
  bool rawlogs = false;
};

struct OfficeArguments {
  std::uint32_t seed = 1;
  std::string out;
};

struct CutArguments {
  std::string rawlog;
  size_t first = 0;
  size_t count = 0;
  std::string out;
};

struct CutPairsArguments {
  std::string pairs;
  CutOptions options;
};

struct LogArguments {
  std::string rawlog;
  std::string poses;
  std::vector<std::tuple<std::string, size_t, std::string>> parts;
};

struct OutputArguments {
  std::string folder;
  std::string place;
};

std::vector<NamedRun> simulate(const SimulateArguments& arguments, const std::string& place) {
  constexpr double kPlanningCell = 0.05;
  const World world = loadWorld(arguments.world);
  const RoutePlanner planner(worldGrid(world, kPlanningCell));
  std::vector<NamedRun> runs;
  for (const std::string& path : arguments.paths) {
    DriveOptions options;
    options.seed = arguments.seed + static_cast<std::uint32_t>(runs.size());
    Path drawn = loadPath(path);
    if (arguments.plan) {
      drawn = planner.tour(drawn.start_in_world, drawn.points_in_world);
    }
    runs.push_back(
        {std::filesystem::path(path).stem().string(), place, drive(world, drawn, options)});
  }
  return runs;
}

void saveRawlogs(const std::string& folder, const std::vector<NamedRun>& runs) {
  for (const NamedRun& run : runs) {
    const std::string stem = (std::filesystem::path(folder) / run.name).string();
    saveRawlog(run.steps, stem + ".rawlog");
    saveTruePoses(run.steps, stem + ".gt");
  }
}

std::vector<NamedRun> runsOfLog(const LogArguments& arguments, const std::string& place) {
  const LoggedScans log(arguments.rawlog);
  const std::vector<Pose2D> poses_in_world = loadPoses(arguments.poses);
  std::vector<NamedRun> runs;
  for (const auto& [name, first, path] : arguments.parts) {
    runs.push_back({name, place, cutRun(log, poses_in_world, first, loadPoses(path))});
  }
  return runs;
}

void addFolder(CLI::App* command, OutputArguments& output) {
  command->add_option("--out", output.folder, "Folder to write into; made if it is not there")
      ->required()
      ->check(CLI::ExistingDirectory | CLI::NonexistentPath);
}

void addOutput(CLI::App* command, OutputArguments& output) {
  addFolder(command, output);
  command->add_option("--environment", output.place, "What pairs.json calls the place")->required();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Makes map pairs with known truth");
  app.require_subcommand(1);
  OutputArguments output;

  SimulateArguments simulated;
  CLI::App* simulate_command = app.add_subcommand("simulate", "Map a world with simulated robots");
  simulate_command->add_option("--world", simulated.world, "Walls, a text file")->required();
  simulate_command->add_option("--path", simulated.paths, "A robot's path, a text file; repeat")
      ->required();
  simulate_command->add_option("--seed", simulated.seed, "Seed of all noise");
  simulate_command->add_flag("--plan", simulated.plan,
                             "Plan ways round walls between the points of each path");
  simulate_command->add_flag(
      "--rawlogs", simulated.rawlogs,
      "Also write what each robot recorded, NAME.rawlog, and its true poses, "
      "NAME.gt (index x y phi)");
  addOutput(simulate_command, output);

  OfficeArguments office;
  CLI::App* office_command = app.add_subcommand("office", "Make up a random office");
  office_command->add_option("--seed", office.seed, "Which one");
  office_command->add_option("--out", office.out, "The world, a text file")->required();

  FleetOptions fleet;
  CLI::App* fleet_command =
      app.add_subcommand("fleet", "Map many random offices with several robots each");
  fleet_command->add_option("--buildings", fleet.buildings, "Offices (default 10)")
      ->check(CLI::Range(1, sbox::app::kMost));
  fleet_command->add_option("--robots", fleet.robots, "Robots in each (default 5)")
      ->check(CLI::Range(1, sbox::app::kMost));
  fleet_command->add_option("--drift", fleet.drift, "Odometry noise, a factor (default 1)")
      ->check(CLI::Range(0.0, 1000.0));
  fleet_command->add_option("--furniture", fleet.furniture, "Its amount, a factor (default 1)")
      ->check(CLI::Range(0.0, 1000.0));
  fleet_command->add_option("--seed", fleet.seed, "Seed of offices, ways and noise (default 1)");
  addFolder(fleet_command, output);

  CutArguments cut;
  CLI::App* cut_command = app.add_subcommand("cut", "Cut scans out of a log, for a SLAM to map");
  cut_command->add_option("--rawlog", cut.rawlog, "The whole log")->required();
  cut_command->add_option("--first", cut.first, "First scan, from 0")->required();
  cut_command->add_option("--count", cut.count, "Number of scans")->required();
  cut_command->add_option("--out", cut.out, "The part, a rawlog")->required();

  CutPairsArguments halves;
  CLI::App* halves_command = app.add_subcommand(
      "cut-pairs", "Cut the maps of annotated pairs across their main axis, to share less");
  halves_command->add_option("--pairs", halves.pairs, "Folder with a pairs.json")
      ->required()
      ->check(CLI::ExistingDirectory);
  halves_command
      ->add_option("--a-until", halves.options.a_until,
                   "Map a keeps this share of the free space (default 0.65)")
      ->check(CLI::Range(0.0, 1.0));
  halves_command
      ->add_option("--b-from", halves.options.b_from,
                   "Map b keeps what lies behind this share (default 0.35); from a-until on "
                   "nothing is in common")
      ->check(CLI::Range(0.0, 1.0));
  halves_command->add_option("--tilt", halves.options.tilt_deg,
                             "Turns the axis, degrees (default 0)");
  addFolder(halves_command, output);

  LogArguments logged;
  CLI::App* log_command = app.add_subcommand("log", "Map parts of a log by the poses of a SLAM");
  log_command->add_option("--rawlog", logged.rawlog, "The whole log")->required();
  log_command->add_option("--poses", logged.poses, "Poses of the whole log's scans")->required();
  log_command->add_option("--part", logged.parts, "NAME, first scan, poses of the part; repeat")
      ->required();
  addOutput(log_command, output);
  if (const auto exit_code = sbox::app::parseCommandLine(app, argc, argv)) {
    return *exit_code;
  }

  try {
    if (*cut_command) {
      LoggedScans(cut.rawlog).save(cut.first, cut.count, cut.out);
    } else if (*halves_command) {
      cutPairs(halves.pairs, output.folder, halves.options);
    } else if (*office_command) {
      saveWorld(randomOffice(office.seed), office.out);
    } else if (*fleet_command) {
      writeDataset(output.folder, driveFleet(fleet));
    } else {
      const std::vector<NamedRun> runs =
          *simulate_command ? simulate(simulated, output.place) : runsOfLog(logged, output.place);
      writeDataset(output.folder, runs);
      if (*simulate_command && simulated.rawlogs) {
        saveRawlogs(output.folder, runs);
      }
    }
  } catch (const std::exception& error) {
    std::cerr << "sbox-dataset: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
