// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/whole_command.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include "sbox-bench/progress_bar.h"
#include "sbox-bench/statistics.h"
#include "sbox/core/stopwatch.h"
#include "sbox/fusion/fuse_maps.h"
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

template <typename Work>
double leastSeconds(int repeat, const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::max(1, repeat); ++i) {
    const Stopwatch stopwatch;
    work();
    least = std::min(least, stopwatch.seconds());
  }
  return least;
}

/// Wall time of what the command does beside features and matching, for a pair that is merged, in
/// seconds.
struct CommandSeconds {
  double load = 0;           ///< Both maps, from the files that the folder has.
  double load_gridmaps = 0;  ///< Both maps, from .gridmap files.
  double fuse = 0;
  double save = 0;  ///< The merged map, as .gridmap.
  double draw = 0;  ///< The merged map, as .png.
};

struct LoadSeconds {
  double file = 0;
  double gridmap = 0;
};

std::vector<LoadSeconds> timeLoading(const LoadedFolder& loaded, const std::string& gridmap,
                                     int repeat) {
  std::vector<LoadSeconds> seconds;
  for (const Map& map : loaded.maps) {
    saveMap(map, gridmap);
    seconds.push_back({leastSeconds(repeat, [&] { static_cast<void>(loadMap(map.name)); }),
                       leastSeconds(repeat, [&] { static_cast<void>(loadMap(gridmap)); })});
  }
  return seconds;
}

/// Nothing for pairs that are refused, of which the command writes no map.
std::vector<std::optional<CommandSeconds>> timeCommand(const FolderAnswers& folder, int repeat) {
  const LoadedFolder& loaded = *folder.loaded;
  const TemporaryFolder temporary;
  const std::string gridmap = temporary.file("map.gridmap"), picture = temporary.file("map.png");
  const std::vector<LoadSeconds> loading = timeLoading(loaded, gridmap, repeat);
  ProgressBar progress("load, fuse, save, draw " + loaded.folder.name,
                       static_cast<int>(folder.answers.size()));
  std::vector<std::optional<CommandSeconds>> seconds;
  for (size_t i = 0; i < folder.answers.size(); ++i) {
    progress.step();
    const PairResult& result = folder.answers[i].result;
    if (result.verdict != Verdict::Accepted) {
      seconds.emplace_back();
      continue;
    }
    const auto a = static_cast<size_t>(loaded.map_of_pair[i].first);
    const auto b = static_cast<size_t>(loaded.map_of_pair[i].second);
    CommandSeconds& of_pair = seconds.emplace_back(CommandSeconds()).value();
    of_pair.load = loading[a].file + loading[b].file;
    of_pair.load_gridmaps = loading[a].gridmap + loading[b].gridmap;
    const std::vector<PlacedMap> placed = {{&loaded.maps[a], Pose2D()},
                                           {&loaded.maps[b], result.pose_b_in_a}};
    Map merged;
    of_pair.fuse = leastSeconds(repeat, [&] { merged = fuseMaps(placed, 0).merged; });
    of_pair.save = leastSeconds(repeat, [&] { saveMap(merged, gridmap); });
    of_pair.draw = leastSeconds(repeat, [&] { saveMap(merged, picture); });
  }
  return seconds;
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

Table ratioTable(const MethodRun& run, int repeat) {
  Ratios load, save, draw, features, pair, fuse, whole, whole_of_gridmaps;
  for (const FolderAnswers& folder : run.folders) {
    const std::vector<std::optional<CommandSeconds>> seconds = timeCommand(folder, repeat);
    for (size_t i = 0; i < seconds.size(); ++i) {
      if (!seconds[i]) {
        continue;
      }
      const CommandSeconds& of_pair = *seconds[i];
      const AnswerSeconds& answer = folder.answers[i].least;
      const double output = of_pair.save + of_pair.draw;
      const double floor = of_pair.load + output;
      const double own = answer.features + answer.pair + of_pair.fuse;
      load.add(of_pair.load, floor);
      save.add(of_pair.save, floor);
      draw.add(of_pair.draw, floor);
      features.add(answer.features, floor);
      pair.add(answer.pair, floor);
      fuse.add(of_pair.fuse, floor);
      whole.add(floor + own, floor);
      const double gridmap_floor = of_pair.load_gridmaps + output;
      whole_of_gridmaps.add(gridmap_floor + own, gridmap_floor);
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
  addRow("load both files", load);
  addRow("save the merged map", save);
  addRow("draw it", draw);
  addRow("features (both maps)", features);
  addRow("pair", pair);
  addRow("fusion", fuse);
  addRow("all of these", whole);
  addRow("all, were the files .gridmap", whole_of_gridmaps);
  return table;
}

}  // namespace sbox::bench
