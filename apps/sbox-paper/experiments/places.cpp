// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/experiments/places.h"

#include "sbox-bench/method_list.h"
#include "sbox-bench/run_method.h"
#include "sbox-paper/answers.h"
#include "sbox/core/parallel.h"

namespace sbox::paper {
namespace {

struct Place {
  const char* name;
  bool decidable;
};

constexpr Place kWorlds[] = {
    {"rooms", true}, {"corridor", true}, {"angled", true}, {"symmetric", false}};

PlaceAnswer simulated(const PlacesOptions& options, const Place& place, std::uint32_t seed) {
  RobotPair robots = simulateWorld(options.datasets + "/worlds", place.name, Slam::Icp, seed);
  PlaceAnswer result;
  result.place = place.name;
  result.decidable = place.decidable;
  result.seed = seed;
  result.answer = solve(defaultMethod(), robots.maps[0], robots.maps[1]);
  result.paper = solve(bench::methodByName("paper"), robots.maps[0], robots.maps[1]);
  if (robots.truth) {
    result.overlap = robots.truth->overlap;
    if (result.answer.has_pose) {
      const PairError error = errorOf(result.answer.pose_b_in_a, *robots.truth);
      result.right = error.right;
      result.excess = error.excess;
    }
    if (result.paper.has_pose) {
      result.paper_right = errorOf(result.paper.pose_b_in_a, *robots.truth).right;
    }
  }
  result.map_a = std::move(robots.maps[0]);
  result.map_b = std::move(robots.maps[1]);
  return result;
}

/// The pairs of a folder with a pairs.json.
std::vector<PlaceAnswer> fromFiles(const std::string& folder, const std::string& name, bool real) {
  const bench::LoadedFolder loaded = bench::loadFolder(bench::readPairFolder(folder));
  const auto answers = bench::runMethod(defaultMethod(), loaded);
  const auto papers = bench::runMethod(bench::methodByName("paper"), loaded);
  std::vector<PlaceAnswer> results;
  for (size_t i = 0; i < answers.size(); ++i) {
    PlaceAnswer& result = results.emplace_back();
    const bench::AnnotatedPair& pair = loaded.folder.pairs[i];
    result.place = name + ", " + pair.a + " and " + pair.b;
    result.real = real;
    result.map_a = loaded.maps[static_cast<size_t>(loaded.map_of_pair[i].first)];
    result.map_b = loaded.maps[static_cast<size_t>(loaded.map_of_pair[i].second)];
    result.answer = answers[i].result;
    result.paper = papers[i].result;
    if (answers[i].error) {
      result.right = answers[i].error->right;
      result.excess = answers[i].error->excess_cells * loaded.folder.resolution;
    }
    if (papers[i].error) {
      result.paper_right = papers[i].error->right;
    }
  }
  return results;
}

}  // namespace

std::vector<PlaceAnswer> runPlaces(const PlacesOptions& options) {
  constexpr auto kCount = static_cast<int>(std::size(kWorlds));
  std::vector<PlaceAnswer> results(static_cast<size_t>(kCount * options.seeds));
  parallelFor(kCount * options.seeds, options.threads, [&](int i) {
    const auto seed = options.seed + 10 * static_cast<std::uint32_t>(i % options.seeds);
    results[static_cast<size_t>(i)] = simulated(options, kWorlds[i / options.seeds], seed);
  });
  for (PlaceAnswer& result : fromFiles(options.datasets + "/office", "office", false)) {
    results.push_back(std::move(result));
  }
  for (PlaceAnswer& result : fromFiles(options.datasets + "/sena", "faculty", true)) {
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace sbox::paper
