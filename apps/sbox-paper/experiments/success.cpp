// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/experiments/success.h"

#include <algorithm>
#include <map>

#include "sbox-bench/method_list.h"
#include "sbox-bench/statistics.h"
#include "sbox-paper/answers.h"
#include "sbox/core/state_grid.h"

namespace sbox::paper {
namespace {

constexpr double kLargeFrom = 250;

double knownArea(const Map& map) {
  const StateGrid grid = classifyCells(map);
  const auto unknown = std::count(grid.cells.begin(), grid.cells.end(), CellState::Unknown);
  return static_cast<double>(static_cast<std::ptrdiff_t>(grid.cells.size()) - unknown) *
         grid.resolution * grid.resolution;
}

void add(SuccessCount& count, bench::Outcome outcome) {
  ++count.pairs;
  count.right += outcome == bench::Outcome::Right ? 1 : 0;
  count.wrong += outcome == bench::Outcome::Wrong ? 1 : 0;
  count.refused += outcome == bench::Outcome::Refused ? 1 : 0;
}

}  // namespace

SuccessTable runSuccess(const bench::LoadedFolder& loaded, int threads) {
  std::vector<bench::Method> methods{defaultMethod()};
  for (const char* name : {"paper", "orb", "sift", "hough"}) {
    if (methods.front().name != name) {
      methods.push_back(bench::methodByName(name));
    }
  }
  SuccessTable table;
  std::map<std::string, std::vector<SuccessCount>> by_group;
  std::map<std::string, std::vector<double>> areas;
  for (size_t i = 0; i < loaded.folder.pairs.size(); ++i) {
    const auto& [a, b] = loaded.map_of_pair[i];
    std::vector<double>& of_group = areas[loaded.folder.pairs[i].group];
    of_group.push_back(knownArea(loaded.maps[static_cast<size_t>(a)]));
    of_group.push_back(knownArea(loaded.maps[static_cast<size_t>(b)]));
  }
  bench::RunOptions run;
  run.threads = threads;
  std::vector<SuccessCount> large(methods.size()), small(methods.size());
  for (size_t m = 0; m < methods.size(); ++m) {
    table.methods.push_back(methods[m].name);
    const std::vector<bench::Answer> answers = bench::runMethod(methods[m], loaded, run);
    for (size_t i = 0; i < answers.size(); ++i) {
      const std::string& group = loaded.folder.pairs[i].group;
      auto& counts = by_group[group];
      counts.resize(methods.size());
      add(counts[m], answers[i].outcome);
      add((bench::median(areas[group]) >= kLargeFrom ? large : small)[m], answers[i].outcome);
    }
  }
  for (auto& [group, counts] : by_group) {
    table.rows.push_back({group, counts});
  }
  table.rows.push_back({"large", large});
  table.rows.push_back({"small", small});
  return table;
}

}  // namespace sbox::paper
