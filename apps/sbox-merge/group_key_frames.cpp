// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/group_key_frames.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

#include "sbox/adjustment/map_adjusted.h"
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
  std::ostringstream line;
  line << std::fixed << std::setprecision(1) << "key frames "
       << (made.adjusted ? "adjusted: " : "left as they were: ") << 100 * made.agreement
       << " % of what the scans saw lies on walls of the map, " << 100 * made.joined_agreement
       << " % as the maps were placed";
  return line.str();
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
