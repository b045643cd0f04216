// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include "sbox/core/pose.h"

namespace sbox::test {

/// Root mean square of how far poses lie from the truth, after the best rigid fit; metres.
inline double poseError(const std::vector<Pose2D>& poses, const std::vector<Pose2D>& truth) {
  const auto count = static_cast<double>(poses.size());
  const auto place = [](const Pose2D& pose) { return std::complex<double>(pose.x, pose.y); };
  std::complex<double> mean, true_mean, turn;
  for (size_t i = 0; i < poses.size(); ++i) {
    mean += place(poses[i]) / count;
    true_mean += place(truth[i]) / count;
  }
  for (size_t i = 0; i < poses.size(); ++i) {
    turn += (place(truth[i]) - true_mean) * std::conj(place(poses[i]) - mean);
  }
  turn /= std::abs(turn);
  double squares = 0;
  for (size_t i = 0; i < poses.size(); ++i) {
    squares += std::norm(place(truth[i]) - true_mean - turn * (place(poses[i]) - mean));
  }
  return std::sqrt(squares / count);
}

}  // namespace sbox::test
