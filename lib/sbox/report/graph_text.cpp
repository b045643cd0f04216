// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/graph_text.h"

#include <algorithm>

#include "sbox/core/number_text.h"
#include "sbox/core/one_line.h"
#include "sbox/core/pose_errors.h"

namespace sbox {
namespace {

std::string poseNumbers(const Pose2D& pose) {
  return " " + numberText(pose.x) + " " + numberText(pose.y) + " " + numberText(pose.phi);
}

std::string mapNumbers(const MapPair& pair) {
  return " " + std::to_string(pair.a) + " " + std::to_string(pair.b);
}

std::string edgeLine(const MapPair& pair) {
  const auto candidate = static_cast<size_t>(pair.settlement->candidate);
  const Pose2D& pose_b_in_a = candidate == 0 ? pair.result.pose_b_in_a
                                             : pair.result.alternatives[candidate - 1].pose_b_in_a;
  // MRPT takes the difference to the edge along the axes of b.
  const Eigen::Matrix3d turn = turnedAxes(-pose_b_in_a.phi);
  const Eigen::Matrix3d information = turn * pair.settlement->information * turn.transpose();
  std::string line = "EDGE2" + mapNumbers(pair) + poseNumbers(pose_b_in_a);
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) {
      line += " " + numberText(information(row, column));
    }
  }
  return line + "\n";
}

}  // namespace

std::string graphText(const MergeResult& result, const MergedGroup& group) {
  std::string vertices, edges, comments;
  for (const int member : group.members) {
    const MapOutcome& map = result.maps[static_cast<size_t>(member)];
    comments += "# " + std::to_string(member) + ": " + oneLine(map.name) + "\n";
    vertices += "VERTEX2 " + std::to_string(member) + poseNumbers(map.placement.pose) + "\n";
  }
  for (const MapPair& pair : result.pairs) {
    const auto& members = group.members;
    if (!pair.settlement || !std::binary_search(members.begin(), members.end(), pair.a)) {
      continue;
    }
    if (pair.settlement->agrees) {
      edges += edgeLine(pair);
    } else {
      comments += "# pair" + mapNumbers(pair) + " does not agree: off by " +
                  numberText(pair.settlement->distance) + " m, " +
                  numberText(pair.settlement->turn) + " rad\n";
    }
  }
  return "# EDGE2 a b x y phi, then the information xx xy xp yy yp pp\n" + comments + vertices +
         "FIX " + std::to_string(group.reference) + "\n" + edges;
}

}  // namespace sbox
