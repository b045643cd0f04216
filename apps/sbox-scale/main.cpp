// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// sbox-scale: time and memory that sbox-merge takes as maps grow, in size or in number.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "command_line.h"
#include "sbox-scale/fleet.h"
#include "sbox-scale/two_maps.h"

namespace {

namespace fs = std::filesystem;

void measureSizes(const std::string& command, const std::vector<int>& sides, double known,
                  const fs::path& folder) {
  sbox::scale::printTwoMapsHeader();
  for (const int side : sides) {
    sbox::scale::measureTwoMaps(command, side, known > 0 ? known : side, folder);
  }
}

void measureFleets(const std::string& command, const std::vector<int>& sizes, bool all_pairs,
                   const fs::path& folder) {
  std::vector<std::string> arguments{"--all-groups"};
  if (all_pairs) {
    std::ofstream(folder / "all.ini") << "[retrieval]\npartners = 0\n";
    arguments.insert(arguments.end(), {"--config", "all.ini"});
  }
  sbox::scale::printFleetHeader();
  for (const int size : sizes) {
    sbox::scale::measureFleet(command, sbox::scale::makeFleet(size, folder), folder, arguments);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::string command =
      (fs::canonical("/proc/self/exe").parent_path().parent_path() / "sbox-merge" / "sbox-merge")
          .string();
  std::vector<int> sides{500, 1000, 2000, 5000, 10000};
  std::vector<int> fleets;
  double known = 0;
  bool all_pairs = false;
  CLI::App app("Time and memory that sbox-merge takes as maps grow", "sbox-scale");
  app.add_option("--sides", sides,
                 "Two maps of so many cells a side (default 500 1000 2000 5000 10000)")
      ->check(CLI::Range(100, 100'000));
  app.add_option("--known", known, "Cells across what is known of each map (default: the side)")
      ->check(CLI::Range(0.0, 1e5));
  app.add_option("--fleet", fleets,
                 "So many small maps in one call instead, five of each building: 25 50 100 200")
      ->check(CLI::Range(2, sbox::app::kMost));
  app.add_flag("--all-pairs", all_pairs, "Match all pairs of the fleet, not those that look alike");
  app.add_option("--command", command, "The sbox-merge to measure (default: that of this build)");
  if (const auto exit_code = sbox::app::parseCommandLine(app, argc, argv)) {
    return *exit_code;
  }
  try {
    std::string folder = (fs::temp_directory_path() / "sbox-scale-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
      throw std::runtime_error("no temporary folder can be made");
    }
    if (fleets.empty()) {
      measureSizes(command, sides, known, folder);
    } else {
      measureFleets(command, fleets, all_pairs, folder);
    }
    fs::remove_all(folder);
  } catch (const std::exception& error) {
    std::cerr << "sbox-scale: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
