// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/rough_match.h"

#include <cmath>

namespace sbox {

bool sidesAgree(const SuppositionalBox& box_a, const SuppositionalBox& box_b,
                double side_tolerance) {
  return std::abs(box_a.height - box_b.height) <= side_tolerance &&
         std::abs(box_a.width - box_b.width) <= side_tolerance;
}

std::vector<RoughMatch> findRoughMatches(const std::vector<SuppositionalBox>& boxes_a,
                                         const std::vector<SuppositionalBox>& boxes_b,
                                         const RoughMatchOptions& options) {
  std::vector<RoughMatch> matches;
  for (size_t a = 0; a < boxes_a.size(); ++a) {
    for (size_t b = 0; b < boxes_b.size(); ++b) {
      if (sidesAgree(boxes_a[a], boxes_b[b], options.side_tolerance)) {
        if (matches.size() >= static_cast<size_t>(options.max_matches)) {
          return matches;
        }
        matches.push_back({static_cast<int>(a), static_cast<int>(b)});
      }
    }
  }
  return matches;
}

}  // namespace sbox
