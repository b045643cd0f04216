// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What every map-joining method looks like to the benchmark: work per map, done once a map, and
// work per pair.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "sbox/core/map.h"
#include "sbox/core/pair_result.h"

namespace sbox::bench {

/// What a method keeps of a map; its type is the method's own business.
using Features = std::shared_ptr<const void>;

/// A method under test. Both functions are pure, so that pairs can run in parallel.
struct Method {
  std::string name;                              ///< What the command line and the tables call it.
  std::function<Features(const Map&)> features;  ///< The work per map.
  std::function<PairResult(const Features& a, const Features& b)> match;  ///< The work per pair.
};

/// A method of `extract(map) -> T` and `match(T, T) -> PairResult`.
template <class Extract, class Match>
[[nodiscard]] Method makeMethod(std::string name, Extract extract, Match match) {
  using Kept = decltype(extract(std::declval<const Map&>()));
  return {
      std::move(name),
      [extract](const Map& map) -> Features { return std::make_shared<const Kept>(extract(map)); },
      [match](const Features& a, const Features& b) -> PairResult {
        return match(*static_cast<const Kept*>(a.get()), *static_cast<const Kept*>(b.get()));
      }};
}

}  // namespace sbox::bench
