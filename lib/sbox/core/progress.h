// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace sbox {

/// Told when a stage has done `done` of its `total` parts; never twice at once. What it throws ends
/// the work.
using ProgressFunction = std::function<void(const std::string& stage, int done, int total)>;

/// Counts the parts of one stage, which may run on any thread.
class StageProgress {
 public:
  /// A stage of `total` parts; an empty `tell` is told nothing.
  StageProgress(ProgressFunction tell, std::string stage, int total)
      : tell_(std::move(tell)), stage_(std::move(stage)), total_(total) {
    report();
  }
  /// Tells again, so that nothing new begins once the work is to end.
  void partBegins() {
    const std::lock_guard<std::mutex> lock(mutex_);
    report();
  }
  /// Counts one part and tells.
  void partDone() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    report();
  }

 private:
  void report() const {
    if (tell_) {
      tell_(stage_, done_, total_);
    }
  }

  ProgressFunction tell_;
  std::string stage_;
  int total_;
  int done_ = 0;
  std::mutex mutex_;
};

}  // namespace sbox
