// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// sbox-paper: the experiments of the paper's section 4, run anew, as one page.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "command_line.h"
#include "sbox-paper/answers.h"
#include "sbox-paper/page/sections.h"
#include "sbox/core/stopwatch.h"
#include "sbox/io/output_files.h"

namespace {

using namespace sbox::paper;

const std::vector<std::string> kExperiments{"rooms", "places", "matches", "success", "offices"};

struct Arguments {
  std::string out = "paper.html";
  std::string datasets = "datasets";
  std::string halmstad;
  std::vector<std::string> only = kExperiments;
  std::uint32_t seed = 1;
  int threads = 0;
  RoomsOptions rooms;
  PlacesOptions places;
  OfficesOptions offices;
};

void addOptions(CLI::App& app, Arguments& arguments) {
  app.add_option("--out", arguments.out, "The page to write")->capture_default_str();
  app.add_option("--datasets", arguments.datasets, "The project's folder of that name")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  app.add_option(
         "--halmstad", arguments.halmstad,
         "Folder of annotated pairs of the Halmstad Robot Maps (a pairs.json); without it the "
         "project's own maps stand in")
      ->check(CLI::ExistingDirectory);
  app.add_option("--only", arguments.only, "Experiments to run (default all)")
      ->check(CLI::IsMember(kExperiments));
  app.add_option("--seed", arguments.seed, "Of everything random")->capture_default_str();
  app.add_option("--threads", arguments.threads, "0: one a core; changes no number")
      ->check(CLI::Range(0, sbox::app::kMost))
      ->capture_default_str();
  app.add_option("--rbpf-pairs", arguments.rooms.rbpf_pairs, "Pairs of maps of rooms by RBPF-SLAM")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  app.add_option("--icp-pairs", arguments.rooms.icp_pairs, "Pairs of maps of rooms by ICP-SLAM")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  app.add_option("--angles", arguments.rooms.angles, "Random rotations of map 2")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--place-seeds", arguments.places.seeds, "Pairs of robots in each world")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  app.add_option("--offices", arguments.offices.offices, "Random offices")
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  app.add_option("--runs", arguments.offices.runs, "Pairs of robots in each office")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--different", arguments.offices.different, "Pairs of maps of different offices")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
}

/// The maps for figure 15 and Table 3.
struct MapPairs {
  sbox::bench::LoadedFolder loaded;
  std::string description;
  std::string option;  ///< As on the command line.
};

MapPairs loadPairs(const Arguments& arguments) {
  MapPairs pairs;
  const bool given = !arguments.halmstad.empty();
  const std::string folder = given ? arguments.halmstad : arguments.datasets + "/sena";
  pairs.loaded = sbox::bench::loadFolder(sbox::bench::readPairFolder(folder), {});
  pairs.description = given ? "the Halmstad Robot Maps given, those of the paper"
                            : "three real maps of one faculty building (datasets/sena), as no "
                              "Halmstad maps were given";
  pairs.option = given ? " --halmstad FOLDER" : "";
  return pairs;
}

class Runner {
 public:
  Runner(const Arguments& arguments, Page& page) : arguments_(arguments), page_(page) {}

  /// The command that runs one experiment alone.
  [[nodiscard]] std::string source(const std::string& experiment,
                                   const std::string& options) const {
    return "sbox-paper --only " + experiment + " --seed " + std::to_string(arguments_.seed) +
           options;
  }

  /// Runs an experiment if it was asked for, and says on stderr how long it took.
  template <typename Experiment>
  void run(const char* name, const Experiment& experiment) const {
    if (std::find(arguments_.only.begin(), arguments_.only.end(), name) == arguments_.only.end()) {
      return;
    }
    const sbox::Stopwatch stopwatch;
    experiment();
    std::fprintf(stderr, "%-8s %7.1f s\n", name, stopwatch.seconds());
  }

  void runAll() const;

 private:
  const Arguments& arguments_;
  Page& page_;
};

std::string option(const char* name, int value) {
  return std::string(" ") + name + " " + std::to_string(value);
}

void Runner::runAll() const {
  run("rooms", [&] {
    RoomsOptions options = arguments_.rooms;
    options.worlds = arguments_.datasets + "/worlds";
    options.seed = arguments_.seed;
    options.threads = arguments_.threads;
    const std::vector<RoomsPair> pairs = runRooms(options);
    const std::string command = source("rooms", option("--rbpf-pairs", options.rbpf_pairs) +
                                                    option("--icp-pairs", options.icp_pairs) +
                                                    option("--angles", options.angles));
    addCoincidenceSection(page_, pairs, command);
    addLengthSections(page_, pairs, command);
  });
  run("places", [&] {
    PlacesOptions options = arguments_.places;
    options.datasets = arguments_.datasets;
    options.seed = arguments_.seed;
    options.threads = arguments_.threads;
    addPlacesSection(page_, runPlaces(options),
                     source("places", option("--place-seeds", options.seeds)));
  });
  run("matches", [&] {
    const MapPairs pairs = loadPairs(arguments_);
    addMatchesSection(page_, countMatches(pairs.loaded, arguments_.threads), pairs.description,
                      source("matches", pairs.option));
  });
  run("success", [&] {
    const MapPairs pairs = loadPairs(arguments_);
    addSuccessSection(page_, runSuccess(pairs.loaded, arguments_.threads), pairs.description,
                      source("success", pairs.option));
  });
  run("offices", [&] {
    OfficesOptions options = arguments_.offices;
    options.seed = arguments_.seed;
    options.threads = arguments_.threads;
    addOfficesSection(
        page_, runOffices(options),
        source("offices", option("--offices", options.offices) + option("--runs", options.runs) +
                              option("--different", options.different)));
  });
}

void run(const Arguments& arguments) {
  // The page's place is claimed first: not to find out in the end that it cannot be written.
  sbox::OutputFiles files;
  const std::string path = files.stage(arguments.out);
  Page page("The map merging paper's experiments, run anew");
  page.paragraph(
      "Chen, Li, Zhao, Liu, \u201cMap Merging with Suppositional Box for Multi-Robot Indoor "
      "Mapping\u201d, "
      "Electronics 2021, 10(7), 815, section 4. \u201cOurs\u201d is the default method of "
      "<code>sbox-merge</code> (<code>" +
      defaultMethod().name +
      "</code>), \u201cpaper\u201d the published method as printed, with its misprints put right. "
      "The paper's own "
      "environments are not published; simulated robots drive through worlds that lie in "
      "<code>datasets/worlds</code>, each with a 270 degree lidar of 8 m range, 0.01 m range noise "
      "and "
      "odometry that drifts. Every number follows from the command above it; the same seed gives "
      "the same "
      "numbers.");
  Runner(arguments, page).runAll();
  std::ofstream file(path, std::ios::binary);
  file << page.html();
  if (!file.flush()) {
    throw std::runtime_error(arguments.out + ": cannot be written");
  }
  files.commit();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Runs the experiments of the suppositional box paper and writes them as one page"};
  Arguments arguments;
  addOptions(app, arguments);
  if (const auto exit_code = sbox::app::parseCommandLine(app, argc, argv)) {
    return *exit_code;
  }
  cv::setNumThreads(1);
  try {
    run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sbox-paper: %s\n", error.what());
    return 1;
  }
  return 0;
}
