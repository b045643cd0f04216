// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "sbox/core/pair_result.h"

namespace sbox {

/// What the poses of all maps of a group say of one pair of them.
struct PairSettlement {
  bool agrees = false;  ///< A candidate of the pair lies where the group's poses put it.
  int candidate = 0;    ///< That candidate, else the nearest: 0 for PairResult::pose_b_in_a, k for
                        ///< alternatives[k - 1].
  double distance = 0;  ///< Between that candidate and the group's poses, metres.
  double turn = 0;      ///< Between their headings, radians, >= 0.
  PoseCovariance information = PoseCovariance::Zero();  ///< With which the candidate pulled at the
                                                        ///< poses; zero if it does not agree.
};

/// What is known about the maps with the indices a and b; a < b.
struct MapPair {
  int a = 0;          ///< Index of the first map.
  int b = 0;          ///< Index of the second map.
  PairResult result;  ///< What matching them gave.
  /// None if they share no group, or matching proposed nothing.
  std::optional<PairSettlement> settlement = {};
};

}  // namespace sbox
