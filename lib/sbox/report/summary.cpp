// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/summary.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/number_text.h"

namespace sbox {
namespace {

/// "b.gridmap in a.gridmap: POSE".
std::string placeText(const MergeResult& result, int map, int reference, const Pose2D& pose) {
  return result.maps[static_cast<size_t>(map)].name + " in " +
         result.maps[static_cast<size_t>(reference)].name + ": " + poseText(pose);
}

std::string confidenceText(double confidence) { return "confidence " + fixedDigits(confidence, 2); }

int groupOf(const MergeResult& result, int map) {
  return result.maps[static_cast<size_t>(map)].placement.group;
}

/// What the poses of all maps say of a pair: "; by all maps ...".
std::string settlementText(const PairSettlement& settlement) {
  const std::string which =
      settlement.candidate == 0 ? "it" : "alternative " + std::to_string(settlement.candidate);
  return "; by all maps " + which + (settlement.agrees ? " is right within " : " is off by ") +
         fixedDigits(settlement.distance, 2) + " m, " +
         fixedDigits(settlement.turn * 180 / M_PI, 1) + " deg";
}

/// "b.gridmap in a.gridmap: VERDICT: REASON (best candidate ...)".
std::string pairText(const MergeResult& result, const MapPair& pair) {
  const PairResult& found = pair.result;
  std::string text = result.maps[static_cast<size_t>(pair.b)].name + " in " +
                     result.maps[static_cast<size_t>(pair.a)].name + ": " +
                     toString(found.verdict) + ", " + found.reason;
  if (found.has_pose) {
    text += " (best candidate " + poseText(found.pose_b_in_a) + ", " +
            confidenceText(found.confidence) + ")";
  }
  const bool is_one_of_many = result.maps.size() > 2;
  if (is_one_of_many && pair.settlement) {
    text += settlementText(*pair.settlement);
  }
  if (found.verdict == Verdict::Accepted && groupOf(result, pair.a) != groupOf(result, pair.b)) {
    text += is_one_of_many ? "; not taken: no other pair bears it out"
                           : "; not taken: --initial speaks against it";
  }
  return text;
}

/// The most confident pair of a map, if it is in any.
const MapPair* bestPair(const MergeResult& result, int map) {
  const MapPair* best = nullptr;
  for (const MapPair& pair : result.pairs) {
    const bool of_map = pair.a == map || pair.b == map;
    if (of_map && (best == nullptr || pair.result.confidence > best->result.confidence)) {
      best = &pair;
    }
  }
  return best;
}

/// "FILE: " for what was written there; nothing for what was not written.
std::string fileText(const std::vector<std::string>& files, size_t merged) {
  return merged < files.size() ? files[merged] + ": " : "";
}

std::string countText(size_t merged, const MergeResult& result) {
  return std::to_string(merged) + " of " + std::to_string(result.maps.size()) + " maps merged";
}

std::vector<std::string> groupLines(const MergeResult& result, const MergedGroup& group) {
  std::vector<std::string> lines;
  for (const int map : group.members) {
    if (map != group.reference) {
      const Pose2D& pose = result.maps[static_cast<size_t>(map)].placement.pose;
      lines.push_back(placeText(result, map, group.reference, pose));
    }
  }
  return lines;
}

std::string timeText(const StageSeconds& seconds) {
  const auto part = [](const char* name, double value) {
    return std::string(", ") + name + " " + fixedDigits(value, 3);
  };
  return "seconds: total " + fixedDigits(seconds.total, 3) + part("load", seconds.load) +
         part("features", seconds.features) + part("matching", seconds.matching) +
         part("verification", seconds.verification) + part("refinement", seconds.refinement) +
         part("fusion", seconds.fusion) + part("save", seconds.save);
}

}  // namespace

std::string poseText(const Pose2D& pose) {
  return "x " + fixedDigits(pose.x, 3) + " m, y " + fixedDigits(pose.y, 3) + " m, phi " +
         fixedDigits(pose.phi * 180 / M_PI, 2) + " deg";
}

std::vector<std::string> summaryLines(const MergeResult& result,
                                      const std::vector<std::string>& merged_files) {
  if (result.maps.size() == 2 && result.pairs.size() == 1) {
    if (result.merged.empty()) {
      return {countText(0, result) + ", " + pairText(result, result.pairs[0])};
    }
    const std::string place = groupLines(result, result.merged[0]).at(0);
    return {fileText(merged_files, 0) + countText(2, result) + ", " + place + " (" +
            confidenceText(result.pairs[0].result.confidence) + ")"};
  }
  std::vector<std::string> lines;
  std::vector<bool> told(result.maps.size(), false);
  for (size_t i = 0; i < result.merged.size(); ++i) {
    const MergedGroup& group = result.merged[i];
    lines.push_back(fileText(merged_files, i) + countText(group.members.size(), result) + " in " +
                    result.maps[static_cast<size_t>(group.reference)].name);
    for (const std::string& line : groupLines(result, group)) {
      lines.push_back(line);
    }
    for (const int map : group.members) {
      told[static_cast<size_t>(map)] = true;
    }
  }
  if (result.merged.empty()) {
    lines.push_back(countText(0, result));
  }
  for (size_t map = 0; map < told.size(); ++map) {
    if (told[map]) {
      continue;
    }
    std::string together = result.maps[map].name;
    for (size_t other = map + 1; other < told.size(); ++other) {
      if (groupOf(result, static_cast<int>(map)) == groupOf(result, static_cast<int>(other))) {
        together += ", " + result.maps[other].name;
        told[other] = true;
        told[map] = true;
      }
    }
    if (told[map]) {
      lines.push_back(together + ": left out, a group of their own");
      continue;
    }
    const MapPair* best = bestPair(result, static_cast<int>(map));
    if (best != nullptr) {
      lines.push_back(result.maps[map].name + ": left out; " + pairText(result, *best));
    }
  }
  return lines;
}

std::vector<std::string> warningLines(const MergeResult& result) {
  std::vector<std::string> lines;
  for (const OverruledGuess& overruled : result.overruled) {
    lines.push_back(result.maps[static_cast<size_t>(overruled.map)].name + " lies " +
                    fixedDigits(overruled.distance, 1) + " m and " +
                    fixedDigits(overruled.turn * 180 / M_PI, 0) +
                    " deg from where it was said to, beside " +
                    result.maps[static_cast<size_t>(overruled.beside)].name);
  }
  return lines;
}

std::vector<std::string> detailLines(const MergeResult& result) {
  std::vector<std::string> lines;
  for (const MapOutcome& map : result.maps) {
    lines.push_back(map.name + ": " + std::to_string(map.width) + " x " +
                    std::to_string(map.height) + " cells of " + fixedDigits(map.resolution, 3) +
                    " m, " + std::to_string(map.features.lines.size()) + " lines, " +
                    std::to_string(map.features.vertical_points.size()) + " vertical points, " +
                    std::to_string(map.features.boxes.size()) + " boxes");
  }
  for (const MapPair& pair : result.pairs) {
    lines.push_back(pairText(result, pair));
  }
  for (const MergedGroup& merged : result.merged) {
    lines.push_back("group " + std::to_string(merged.group) +
                    " merged: " + std::to_string(merged.map.width()) + " x " +
                    std::to_string(merged.map.height()) + " cells, " +
                    fixedDigits(100 * merged.conflict_share, 1) + " % in conflict");
    for (size_t i = 0; i < merged.shifts.size(); ++i) {
      lines.push_back(result.maps[static_cast<size_t>(merged.members[i])].name + ": bent by " +
                      fixedDigits(merged.shifts[i], 2) + " m");
    }
  }
  lines.push_back(timeText(result.seconds));
  return lines;
}

}  // namespace sbox
