// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The whole merge of two or three small grids of any cells at any pose: it ends, every number it
// gives is one, and it can be reported.
#include <fuzzer/FuzzedDataProvider.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "fuzz/input_folder.h"
#include "sbox/merge.h"
#include "sbox/report/report_html.h"
#include "sbox/report/report_json.h"
#include "sbox/report/tf_text.h"

using namespace sbox;

namespace {

using Cell = mrpt::maps::COccupancyGridMap2D::cellType;

void fill(Map& map, int x0, int y0, int x1, int y1, Cell value) {
  for (int y = std::max(y0, 0); y < std::min(y1, map.height()); ++y) {
    for (int x = std::max(x0, 0); x < std::min(x1, map.width()); ++x) {
      map.grid.getRow(y)[x] = value;
    }
  }
}

/// Rectangles of one value over each other, so that there are walls; then single cells.
Map anyMap(FuzzedDataProvider& input, const std::string& name) {
  const double resolutions[] = {0.05, 0.1, 0.2};
  const Pose2D corner{input.ConsumeFloatingPointInRange<double>(-1000, 1000),
                      input.ConsumeFloatingPointInRange<double>(-1000, 1000),
                      input.ConsumeFloatingPointInRange<double>(-4, 4)};
  Map map = makeMap(name, input.ConsumeIntegralInRange(1, 48), input.ConsumeIntegralInRange(1, 48),
                    input.PickValueInArray(resolutions), corner);
  for (int i = input.ConsumeIntegralInRange(0, 12); i > 0; --i) {
    const int x = input.ConsumeIntegralInRange(-2, 48), y = input.ConsumeIntegralInRange(-2, 48);
    fill(map, x, y, x + input.ConsumeIntegralInRange(1, 48),
         y + input.ConsumeIntegralInRange(1, 48), input.ConsumeIntegral<Cell>());
  }
  for (int i = input.ConsumeIntegralInRange(0, 8); i > 0; --i) {
    const int x = input.ConsumeIntegralInRange(0, 47), y = input.ConsumeIntegralInRange(0, 47);
    fill(map, x, y, x + 1, y + 1, input.ConsumeIntegral<Cell>());
  }
  return map;
}

void requirePose(const Pose2D& pose, const PoseCovariance& covariance) {
  fuzz::require(std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.phi));
  fuzz::require(covariance.allFinite());
}

void requireNumbers(const MergeResult& result) {
  for (const MapOutcome& map : result.maps) {
    requirePose(map.placement.pose, map.placement.covariance);
  }
  for (const MapPair& pair : result.pairs) {
    const PairResult& found = pair.result;
    requirePose(found.pose_b_in_a, found.covariance);
    fuzz::require(found.confidence >= 0 && found.confidence <= 1);
    fuzz::require(std::isfinite(found.overlap_m2) && found.overlap_m2 >= 0);
    fuzz::require(!found.reason.empty());
    fuzz::require(found.verdict != Verdict::Accepted || found.has_pose);
    for (const Candidate& candidate : found.alternatives) {
      requirePose(candidate.pose_b_in_a, PoseCovariance::Zero());
      fuzz::require(candidate.confidence >= 0 && candidate.confidence <= 1);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider input(data, size);
  MergeOptions options;
  options.method = input.PickValueInArray({Method::Boxes, Method::Paper});
  options.fusion.rule = input.PickValueInArray({FusionRule::LogOdds, FusionRule::Table});
  options.all_groups = input.ConsumeBool();
  options.threads = 1;
  // Coarser than one would, which reaches the same code in less time.
  options.paper.hough.theta_step = 0.1;
  options.paper.boxes.max_boxes = 60;
  std::vector<Map> maps{anyMap(input, "a")};
  const bool same_twice = input.ConsumeBool();
  maps.push_back(same_twice ? maps[0] : anyMap(input, "b"));
  if (input.ConsumeBool()) {
    maps.push_back(anyMap(input, "c"));
  }
  MergeResult result;
  try {
    result = mergeMaps(maps, options);
  } catch (const std::length_error&) {
    return 0;  // The merged map would be too large.
  }
  requireNumbers(result);
  fuzz::require(!reportJson(result, {"merged.yaml"}).empty());
  // Drawing takes longer than merging.
  constexpr int draw_one_in = 64;
  if (input.ConsumeIntegralInRange(1, draw_one_in) == draw_one_in) {
    fuzz::require(!reportHtml(maps, result, {"merged.yaml"}, 1).empty());
  }
  fuzz::require(!tfYaml(result).empty());
  return 0;
}
