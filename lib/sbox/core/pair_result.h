// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sbox/core/pose.h"

namespace sbox {

/// Indices of two maps, the lower first.
using PairIndex = std::pair<int, int>;

/// What may be done with the transform of a pair.
enum class Verdict {
  Accepted,   ///< The transform is right with high probability.
  Ambiguous,  ///< Two distinct transforms explain the maps about as well.
  Rejected    ///< No transform is explained well enough by the cells.
};

/// "accepted", "ambiguous" or "rejected".
[[nodiscard]] const char* toString(Verdict verdict);

/// A transform that was considered, and the probability that it is right.
struct Candidate {
  Pose2D pose_b_in_a;     ///< Frame of map b in the frame of map a.
  double confidence = 0;  ///< In [0, 1].
};

/// Wall time of each stage, in seconds.
struct PairSeconds {
  double matching = 0;      ///< Hypotheses from the features of both maps.
  double verification = 0;  ///< Hypotheses against the cells.
  double refinement = 0;    ///< Transform and covariance.
};

/// What is known about two maps a and b after matching. The best candidate is carried even when it
/// was refused.
struct PairResult {
  Verdict verdict = Verdict::Rejected;  ///< Whether pose_b_in_a may be used.
  std::string reason;                   ///< One sentence: why this verdict.
  bool has_pose = false;                ///< False when no transform could be proposed at all.
  Pose2D pose_b_in_a;                   ///< Frame of map b in the frame of map a.
  PoseCovariance covariance = PoseCovariance::Identity() * 1e6;  ///< Of pose_b_in_a; never zero.
  double confidence = 0;         ///< Probability that pose_b_in_a is right, in [0, 1].
  double overlap_m2 = 0;         ///< Area free in both maps before refinement, square metres.
  std::optional<Pose2D> kalman;  ///< pose_b_in_a by the Kalman step (section 3.3), if it could run.
  std::optional<Pose2D> ceres;   ///< pose_b_in_a by Ceres, if it could run.
  std::vector<std::pair<int, int>> matched_boxes;  ///< Indices into the boxes of a and of b.
  /// Other distinct transforms, most likely first; likelier than pose_b_in_a only where the Kalman
  /// step and Ceres do not agree on that.
  std::vector<Candidate> alternatives;
  PairSeconds seconds;  ///< What it took.
};

}  // namespace sbox
