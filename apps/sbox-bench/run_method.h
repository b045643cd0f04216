// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs a method over a folder of pairs: features once a map, then every pair, judged.
#pragma once

#include <optional>
#include <vector>

#include "sbox-bench/judge.h"
#include "sbox-bench/load_folder.h"
#include "sbox-bench/method.h"
#include "sbox-bench/normalised_error.h"
#include "sbox/core/pair_result.h"

namespace sbox::bench {

/// How to run a method.
struct RunOptions {
  int threads = 1;  ///< Maps and pairs in parallel; 0: one a core. Answers do not depend on it.
  int repeat = 1;   ///< Runs of each stage, for its time.
};

/// Wall time of each stage for one pair, in seconds.
struct AnswerSeconds {
  double features = 0;  ///< Of both maps.
  double matching = 0;
  double verification = 0;
  double refinement = 0;
  double pair = 0;  ///< The whole call for the pair, without the features.
};

/// A method's answer to a pair and what it is worth.
struct Answer {
  PairResult result;
  Pose2D corner_a_in_corner_b;     ///< The transform in the annotation's frames, metres.
  std::optional<PoseError> error;  ///< None for negative pairs and answers without a pose.
  Outcome outcome = Outcome::Refused;
  std::optional<NormalisedError> normalised_error;  ///< None without covariance.
  bool candidate_right = false;  ///< The pose or one of the alternatives is right.
  AnswerSeconds least;           ///< Least over the repeats, stage by stage.
  AnswerSeconds middle;          ///< Median over the repeats, stage by stage.

  /// Whether the pose, accepted or not, is right.
  [[nodiscard]] bool poseRight() const { return error && error->right; }
};

/// The answers of one method, pair by pair in the folder's order.
[[nodiscard]] std::vector<Answer> runMethod(const Method& method, const LoadedFolder& loaded,
                                            const RunOptions& options = {});

}  // namespace sbox::bench
