// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Score and best pair (paper, section 3.2, eq. 5).
#pragma once

#include <optional>
#include <vector>

#include "sbox/paper/agreement.h"

namespace sbox {

/// From boxes to the best pair.
struct BestPairOptions {
  int min_agreeing = 8;  ///< Agreeing matches that make a transform a candidate.
  double least_distance =
      0.05;  ///< The sum in eq. 5 counts as no less, metres: a perfect fit is 0.
  RoughMatchOptions rough_match;  ///< Boxes of equal sides.
  AgreementOptions agreement;     ///< The filter.
};

/// The pair of boxes whose transform is the answer.
struct BestPair {
  RoughMatch match;     ///< The two boxes.
  int shift = 0;        ///< Corner i of box a lies on corner i + shift of box b.
  Pose2D pose_a_in_b;   ///< The transform T, from three of the corners.
  Agreement agreement;  ///< What else agrees with it.
  double score = 0;     ///< Eq. 5, in metres.
  bool enough = false;  ///< Whether enough matches agree: the paper's condition for an answer.
};

/// Eq. 5: the smaller area over the sum of the agreeing matches' largest corner distances.
[[nodiscard]] double score(const SuppositionalBox& box_a, const SuppositionalBox& box_b,
                           const Agreement& agreement, double least_distance);

/// The candidate with the best score; where no transform has enough agreement, the one with the
/// most (then the best score), so that a refusal can be explained. Nothing if no boxes match even
/// roughly.
[[nodiscard]] std::optional<BestPair> findBestPair(const std::vector<SuppositionalBox>& boxes_a,
                                                   const std::vector<SuppositionalBox>& boxes_b,
                                                   const BestPairOptions& options = {});

}  // namespace sbox
