// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/group_key_frames.h"

#include <algorithm>
#include <utility>

#include "sbox/adjustment/map_adjusted.h"
#include "sbox/core/number_text.h"
#include "sbox/fusion/join_key_frames.h"

namespace sbox::app {
namespace {

std::vector<PlacedKeyFrames> placedKeyFrames(const Inputs& inputs, const MergeResult& result,
                                             const MergedGroup& group) {
  std::vector<PlacedKeyFrames> members;
  for (const int member : group.members) {
    const auto index = static_cast<size_t>(member);
    members.push_back({&inputs.key_frames[index], result.maps[index].placement.pose});
  }
  return members;
}

std::string describe(const AdjustedMap& made) {
  return std::string("key frames ") + (made.adjusted ? "adjusted: " : "left as they were: ") +
         fixedDigits(100 * made.agreement, 1) +
         " % of what the scans saw lies on walls of the map, " +
         fixedDigits(100 * made.joined_agreement, 1) + " % as the maps were placed";
}

}  // namespace

GroupKeyFrames groupKeyFrames(const Inputs& inputs, const MergeResult& result) {
  GroupKeyFrames all;
  for (const MergedGroup& group : result.merged) {
    all.groups.push_back(joinKeyFrames(placedKeyFrames(inputs, result, group)));
  }
  return all;
}

GroupKeyFrames remapGroups(const Inputs& inputs, const Arguments& arguments, MergeResult& result,
                           const ProgressFunction& tell) {
  const MergeOptions& options = arguments.merge;
  GroupKeyFrames all;
  for (MergedGroup& group : result.merged) {
    const auto reference = std::find(group.members.begin(), group.members.end(), group.reference);
    AdjustedMap made = mapAdjusted(group.map.name, placedKeyFrames(inputs, result, group),
                                   static_cast<size_t>(reference - group.members.begin()),
                                   options.mapping, options.adjustment, options.threads, tell);
    all.details.push_back(describe(made));
    group.map = std::move(made.map);
    all.groups.push_back(std::move(made.key_frames));
  }
  return all;
}

}  // namespace sbox::app
