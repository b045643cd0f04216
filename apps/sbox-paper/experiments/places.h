// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Figure 13 and beyond: rooms, a long corridor of like rooms, walls at any angle, real maps, and a
// corridor that nobody can tell the place in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sbox-paper/robot_pair.h"
#include "sbox/core/map.h"
#include "sbox/core/pair_result.h"

namespace sbox::paper {

struct PlacesOptions {
  std::string datasets;    ///< Folder that holds worlds/, office/ and sena/.
  std::uint32_t seed = 1;  ///< Of the first pair of robots.
  int seeds = 5;           ///< Pairs of robots in each world.
  int threads = 0;         ///< 0: one a core.
};

/// One pair of maps of a place.
struct PlaceAnswer {
  std::string place;
  bool real = false;       ///< From a real robot's log.
  bool decidable = true;   ///< False: accepting is wrong, and "ambiguous" the right answer.
  std::uint32_t seed = 0;  ///< Of the simulation; 0 for maps from files.
  Map map_a;
  Map map_b;
  double overlap = 0;               ///< Share of the smaller map's known area.
  PairResult answer;                ///< By the default method.
  PairResult paper;                 ///< By the published method.
  std::optional<bool> right;        ///< Whether the default method's pose is; none: no pose.
  std::optional<bool> paper_right;  ///< The same for the published method.
  double excess = 0;  ///< Error of the default method's pose over the rigid floor, metres.
};

/// Place by place, seed by seed.
[[nodiscard]] std::vector<PlaceAnswer> runPlaces(const PlacesOptions& options);

}  // namespace sbox::paper
