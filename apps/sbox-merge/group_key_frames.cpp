// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/group_key_frames.h"

#include <vector>

#include "sbox/fusion/join_key_frames.h"
#include "sbox/mapping/map_key_frames.h"

namespace sbox::app {

KeyFrames groupKeyFrames(const Inputs& inputs, const MergeResult& result,
                         const MergedGroup& group) {
  std::vector<PlacedKeyFrames> members;
  for (const int member : group.members) {
    const auto index = static_cast<size_t>(member);
    members.push_back({&inputs.key_frames[index], result.maps[index].placement.pose});
  }
  return joinKeyFrames(members);
}

void remapGroups(const Inputs& inputs, const Arguments& arguments, MergeResult& result) {
  for (MergedGroup& group : result.merged) {
    group.map = mapKeyFrames(group.map.name, groupKeyFrames(inputs, result, group),
                             arguments.merge.mapping);
  }
}

}  // namespace sbox::app
