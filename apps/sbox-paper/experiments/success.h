// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Table 3: how often each method finds the transform, by the area that the robots saw.
#pragma once

#include <string>
#include <vector>

#include "sbox-bench/run_method.h"

namespace sbox::paper {

/// What one method makes of the pairs of one area class.
struct SuccessCount {
  int pairs = 0;
  int right = 0;    ///< Accepted and right.
  int wrong = 0;    ///< Accepted and wrong.
  int refused = 0;  ///< Not accepted.
};

/// One row of Table 3.
struct SuccessRow {
  std::string group;                 ///< "E5", or "large" and "small" for the sums.
  std::vector<SuccessCount> counts;  ///< One a method.
};

struct SuccessTable {
  std::vector<std::string> methods;
  std::vector<SuccessRow> rows;
};

/// Runs the methods over a folder of pairs that have something in common. Groups whose maps know
/// more than 250 m^2 in the median are large, the others small; both sums close the table.
[[nodiscard]] SuccessTable runSuccess(const bench::LoadedFolder& loaded, int threads);

}  // namespace sbox::paper
