// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/progress_bar.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace sbox::bench {
namespace {

constexpr int kBarCharacters = 30;

}  // namespace

ProgressBar::ProgressBar(std::string label, int total)
    : label_(std::move(label)), total_(total), on_terminal_(isatty(STDERR_FILENO) != 0) {
  draw();
}

ProgressBar::~ProgressBar() {
  if (on_terminal_) {
    std::fputs("\r\033[K", stderr);
  }
}

void ProgressBar::step() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++done_;
  draw();
}

void ProgressBar::draw() const {
  if (!on_terminal_ || total_ < 1) {
    return;
  }
  const int filled = kBarCharacters * done_ / total_;
  std::fprintf(stderr, "\r\033[K%s [%s%s] %d/%d", label_.c_str(),
               std::string(static_cast<size_t>(filled), '#').c_str(),
               std::string(static_cast<size_t>(kBarCharacters - filled), '.').c_str(), done_,
               total_);
  std::fflush(stderr);
}

}  // namespace sbox::bench
