// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/progress_line.h"

#include <unistd.h>

#include <iostream>

namespace sbox::app {

ProgressLine::ProgressLine(bool wanted, double patience)
    : on_terminal_(wanted && isatty(STDERR_FILENO) == 1), next_(patience) {}

void ProgressLine::show(const std::string& stage, int done, int total) {
  constexpr double pause = 0.1;
  const double now = stopwatch_.seconds();
  if (!on_terminal_ || now < next_) {
    return;
  }
  next_ = now + pause;
  std::cerr << "\r\033[K" << stage << " " << done << " of " << total << std::flush;
  shown_ = true;
}

void ProgressLine::wipe() {
  if (shown_) {
    std::cerr << "\r\033[K" << std::flush;
    shown_ = false;
  }
}

}  // namespace sbox::app
