// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Many random offices: how many pairs of maps are merged rightly, and whether maps of different
// offices are kept apart.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sbox-paper/robot_pair.h"
#include "sbox/core/pair_result.h"

namespace sbox::paper {

struct OfficesOptions {
  int offices = 20;
  int runs = 5;            ///< Pairs of robots in each office.
  int different = 100;     ///< Pairs of maps from different offices.
  std::uint32_t seed = 1;  ///< Of the first office; the others follow.
  int threads = 0;         ///< 0: one a core.
};

/// What one method makes of a pair.
struct OfficeAnswer {
  PairResult result;
  PairError error;  ///< Unset where there is no pose or no truth.

  [[nodiscard]] bool accepted() const { return result.verdict == Verdict::Accepted; }
};

/// One pair of robots in one office.
struct OfficeRun {
  std::uint32_t office = 0;
  std::uint32_t run = 0;
  RobotPair robots;
  std::vector<OfficeAnswer> answers;  ///< One a method.
  double not_coinciding = 0;  ///< Share of wall edges under the first method's pose; 0: no pose.
};

/// Two maps of different offices.
struct DifferentPair {
  std::string a;
  std::string b;
  std::vector<PairResult> answers;  ///< One a method.
};

struct OfficesResult {
  std::vector<std::string> methods;  ///< The default one first.
  std::vector<OfficeRun> runs;
  std::vector<DifferentPair> different;

  /// Runs that one method accepted and has right, or not right.
  [[nodiscard]] int accepted(size_t method, bool right) const;
  /// Pairs of different offices that one method accepted.
  [[nodiscard]] int differentAccepted(size_t method) const;
};

[[nodiscard]] OfficesResult runOffices(const OfficesOptions& options);

}  // namespace sbox::paper
