// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sbox/core/stopwatch.h"

namespace sbox::app {

/// One line on stderr that says how far the work is; shown on a terminal only, once it has taken
/// `patience` seconds, and wiped at the end.
class ProgressLine {
 public:
  /// `wanted` false: shows nothing ever.
  explicit ProgressLine(bool wanted, double patience = 1);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { wipe(); }

  void show(const std::string& stage, int done, int total);
  void wipe();

 private:
  bool on_terminal_;
  bool shown_ = false;
  double next_;  ///< Seconds from which the line may change again.
  Stopwatch stopwatch_;
};

}  // namespace sbox::app
