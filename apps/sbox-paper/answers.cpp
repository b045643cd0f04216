// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/answers.h"

#include <algorithm>
#include <vector>

#include "sbox-bench/method_list.h"
#include "sbox/fusion/fuse_maps.h"
#include "sbox/io/align_to_axes.h"
#include "sbox/paper/paper_method.h"

namespace sbox::paper {

bench::Method defaultMethod() { return bench::methodByName("boxes"); }

PairResult solve(const bench::Method& method, const Map& a, const Map& b) {
  return method.match(method.features(a), method.features(b));
}

std::optional<Pose2D> plainPaperPose(const Map& a, const Map& b) {
  const PaperOptions options;
  const PaperFeatures of_a = extractPaperFeatures(a, options),
                      of_b = extractPaperFeatures(b, options);
  const auto best = findBestPair(of_a.boxes, of_b.boxes, options.best_pair);
  if (!best) {
    return std::nullopt;
  }
  return of_a.states.corner_in_map + inverse(best->pose_a_in_b) +
         inverse(of_b.states.corner_in_map);
}

Map mergeTwo(const Map& a, const Map& b, const Pose2D& pose_b_in_a) {
  return fuseMaps({{&a, Pose2D()}, {&b, pose_b_in_a}}, 0).merged;
}

Map turnedMap(const Map& map, double angle) {
  Map turned = map;
  turned.corner_in_map = Pose2D(0, 0, angle) + map.corner_in_map;
  return alignToAxes(turned);
}

}  // namespace sbox::paper
