// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/io_floor.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>

#include "sbox-bench/progress_bar.h"
#include "sbox-bench/statistics.h"
#include "sbox/core/stopwatch.h"
#include "sbox/io/load_map.h"
#include "sbox/io/save_map.h"

namespace sbox::bench {
namespace {

namespace fs = std::filesystem;

/// A folder of this process alone, gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(fs::temp_directory_path() / ("sbox-bench-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

double leastSeconds(int repeat, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::max(1, repeat); ++i) {
    const Stopwatch stopwatch;
    work();
    least = std::min(least, stopwatch.seconds());
  }
  return least;
}

/// The times of one stage over all pairs, and what they are to the floor of each.
struct Ratios {
  std::vector<double> milliseconds;
  std::vector<double> ratios;

  void add(double seconds, double floor_seconds) {
    milliseconds.push_back(seconds * 1e3);
    ratios.push_back(seconds / floor_seconds);
  }
};

}  // namespace

std::vector<FloorSeconds> measureFloor(const LoadedFolder& loaded, int repeat) {
  const TemporaryFolder folder;
  const std::string grid_file = folder.file("map.gridmap"), picture_file = folder.file("map.png");
  ProgressBar progress("load, save, draw " + loaded.folder.name,
                       static_cast<int>(loaded.maps.size()));
  std::vector<FloorSeconds> floors;
  for (const Map& map : loaded.maps) {
    FloorSeconds floor;
    floor.save = leastSeconds(repeat, [&] { saveMap(map, grid_file); });
    floor.load = leastSeconds(repeat, [&] { static_cast<void>(loadMap(grid_file)); });
    floor.draw = leastSeconds(repeat, [&] { saveMap(map, picture_file); });
    floors.push_back(floor);
    progress.step();
  }
  return floors;
}

Table ratioTable(const MethodRun& run, const std::vector<std::vector<FloorSeconds>>& floors) {
  Ratios load, save, draw, features, pair, whole;
  for (size_t f = 0; f < run.folders.size(); ++f) {
    const LoadedFolder& loaded = *run.folders[f].loaded;
    for (size_t i = 0; i < run.folders[f].answers.size(); ++i) {
      const auto a = static_cast<size_t>(loaded.map_of_pair[i].first);
      const auto b = static_cast<size_t>(loaded.map_of_pair[i].second);
      const FloorSeconds& of_a = floors[f][a];
      const FloorSeconds& of_b = floors[f][b];
      const FloorSeconds& larger = of_a.save + of_a.draw > of_b.save + of_b.draw ? of_a : of_b;
      const double floor = of_a.load + of_b.load + larger.save + larger.draw;
      const AnswerSeconds& seconds = run.folders[f].answers[i].least;
      load.add(of_a.load + of_b.load, floor);
      save.add(larger.save, floor);
      draw.add(larger.draw, floor);
      features.add(seconds.features, floor);
      pair.add(seconds.pair, floor);
      whole.add(floor + seconds.features + seconds.pair, floor);
    }
  }
  Table table{{run.method + ", to load + save + draw", "ms, median", "max", "ratio, median", "max"},
              {}};
  const auto addRow = [&](const char* name, const Ratios& stage) {
    table.rows.push_back({name, formatNumber(median(stage.milliseconds), 2),
                          formatNumber(maximum(stage.milliseconds), 2),
                          formatNumber(median(stage.ratios), 2),
                          formatNumber(maximum(stage.ratios), 2)});
  };
  addRow("load both", load);
  addRow("save", save);
  addRow("draw", draw);
  addRow("features (both maps)", features);
  addRow("pair", pair);
  addRow("all of these", whole);
  return table;
}

}  // namespace sbox::bench
