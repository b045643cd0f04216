// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/pictures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <opencv2/core.hpp>

#include "sbox/core/number_text.h"
#include "sbox/core/parallel.h"
#include "sbox/core/state_grid.h"
#include "sbox/report/boxes_picture.h"
#include "sbox/report/drawing/figure.h"
#include "sbox/report/features_picture.h"
#include "sbox/report/map_picture.h"
#include "sbox/report/overlay_picture.h"
#include "sbox/report/pairs_to_show.h"
#include "sbox/report/short_names.h"

namespace sbox {
namespace {

/// The name in at most 18 letters: what does not fit goes from its middle.
std::string legible(const std::string& name) {
  constexpr size_t most = 18, head = 7, tail = 8;
  return name.size() <= most ? name
                             : name.substr(0, head) + "..." + name.substr(name.size() - tail);
}

/// A picture still to be drawn.
struct Plan {
  std::string name;
  std::function<cv::Mat()> draw;
};

std::string overlayTitle(const MapPair& pair, const std::vector<std::string>& names) {
  const Pose2D& pose = pair.result.pose_b_in_a;
  return legible(names[static_cast<size_t>(pair.b)]) + " in " +
         legible(names[static_cast<size_t>(pair.a)]) + ": x " + fixedDigits(pose.x, 2) + " m, y " +
         fixedDigits(pose.y, 2) + " m, phi " + fixedDigits(pose.phi * 180 / M_PI, 1) + " deg (" +
         toString(pair.result.verdict) + ", confidence " + fixedDigits(pair.result.confidence, 2) +
         ")";
}

std::string mergedTitle(const MergedGroup& merged, size_t map_count) {
  return std::to_string(merged.members.size()) + " of " + std::to_string(map_count) +
         " maps merged, cells of " + fixedDigits(merged.map.resolution(), 3) + " m, " +
         fixedDigits(100 * merged.conflict_share, 1) + " % in conflict";
}

std::vector<Plan> planPictures(const std::vector<StateGrid>& grids,
                               const std::vector<std::string>& names, const MergeResult& result) {
  std::vector<Plan> plans;
  for (const MergedGroup& merged : result.merged) {
    const bool main_group = &merged == &result.merged.front();
    plans.push_back({main_group ? "merged" : "merged_group" + std::to_string(merged.group), [&] {
                       return drawMap(classifyCells(merged.map),
                                      mergedTitle(merged, result.maps.size()));
                     }});
  }
  for (size_t i = 0; i < grids.size(); ++i) {
    plans.push_back({"features_" + names[i],
                     [&, i] { return drawFeatures(grids[i], result.maps[i].features, names[i]); }});
  }
  for (const MapPair* pair : pairsToShow(result)) {
    const auto a = static_cast<size_t>(pair->a), b = static_cast<size_t>(pair->b);
    const std::string suffix = names[a] + "_" + names[b];
    plans.push_back({"boxes_" + suffix, [&, a, b, pair] {
                       return drawMatchedBoxes(
                           {&grids[a], &result.maps[a].features.boxes, names[a]},
                           {&grids[b], &result.maps[b].features.boxes, names[b]},
                           pair->result.matched_boxes);
                     }});
    plans.push_back({"overlay_" + suffix, [&, a, b, pair] {
                       return drawOverlay(grids[a], grids[b], pair->result.pose_b_in_a,
                                          overlayTitle(*pair, names), legible(names[a]),
                                          legible(names[b]));
                     }});
  }
  return plans;
}

}  // namespace

std::vector<Picture> drawPictures(const std::vector<Map>& maps, const MergeResult& result,
                                  int threads, const ProgressFunction& progress) {
  std::vector<StateGrid> grids(maps.size());
  parallelFor(static_cast<int>(maps.size()), threads, [&](int i) {
    grids[static_cast<size_t>(i)] = classifyCells(maps[static_cast<size_t>(i)]);
  });
  const std::vector<std::string> names = shortNames(result);
  const std::vector<Plan> plans = planPictures(grids, names, result);

  std::vector<std::string> file_names;
  std::transform(plans.begin(), plans.end(), std::back_inserter(file_names),
                 [](const Plan& plan) { return plan.name; });
  file_names = distinctNames(file_names);
  std::vector<Picture> pictures(plans.size());
  StageProgress pictures_progress(progress, "pictures", static_cast<int>(plans.size()));
  parallelFor(static_cast<int>(plans.size()), threads, [&](int i) {
    pictures_progress.partBegins();
    const auto index = static_cast<size_t>(i);
    pictures[index] = {file_names[index] + ".png", encodePng(plans[index].draw())};
    pictures_progress.partDone();
  });
  return pictures;
}

}  // namespace sbox
