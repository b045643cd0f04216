// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rough matching (paper, section 3.2): boxes of two maps with equal sides within a generous
// tolerance.
#pragma once

#include <vector>

#include "sbox/paper/boxes.h"

namespace sbox {

/// When boxes could be the same.
struct RoughMatchOptions {
  double side_tolerance = 0.5;  ///< Difference of heights, and of widths, allowed; metres.
  int max_matches = 20000;      ///< Those of the largest boxes are kept.
};

/// Indices of a box of map a and one of map b.
struct RoughMatch {
  int a = 0;  ///< Box of map a.
  int b = 0;  ///< Box of map b.
};

/// Whether heights and widths agree within the tolerance.
[[nodiscard]] bool sidesAgree(const SuppositionalBox& box_a, const SuppositionalBox& box_b,
                              double side_tolerance);

/// All pairs of boxes whose sides agree, in the order of (a, b). As boxes come largest first, a cut
/// at max_matches keeps the largest.
[[nodiscard]] std::vector<RoughMatch> findRoughMatches(const std::vector<SuppositionalBox>& boxes_a,
                                                       const std::vector<SuppositionalBox>& boxes_b,
                                                       const RoughMatchOptions& options = {});

}  // namespace sbox
