// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

namespace sbox::bench {

/// A bar on stderr that counts steps of a known number; silent where stderr is no terminal.
class ProgressBar {
 public:
  ProgressBar(std::string label, int total);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// One more step is done. May be called from any thread.
  void step();

 private:
  void draw() const;

  std::string label_;
  int total_;
  int done_ = 0;
  bool on_terminal_;
  std::mutex mutex_;
};

}  // namespace sbox::bench
