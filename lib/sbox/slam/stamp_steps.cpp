// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/stamp_steps.h"

#include <mrpt/core/Clock.h>

namespace sbox {
namespace {

using Time = mrpt::Clock::time_point;

bool timesGoOn(const ScanLog& log) {
  Time last = INVALID_TIMESTAMP;
  for (const LogStep& step : log.steps) {
    for (const auto& action : *step.moved) {
      if (action->timestamp == INVALID_TIMESTAMP) {
        return false;
      }
    }
    for (const auto& observation : *step.seen) {
      if (observation->timestamp == INVALID_TIMESTAMP) {
        return false;
      }
    }
    const Time time = (*step.seen->begin())->timestamp;
    if (last != INVALID_TIMESTAMP && time <= last) {
      return false;
    }
    last = time;
  }
  return true;
}

}  // namespace

bool stampSteps(ScanLog& log) {
  if (timesGoOn(log)) {
    return false;
  }
  constexpr double start = 1e9;
  constexpr double spacing = 0.1;
  for (size_t i = 0; i < log.steps.size(); ++i) {
    const Time time = mrpt::Clock::fromDouble(start + spacing * static_cast<double>(i));
    for (auto& action : *log.steps[i].moved) {
      action->timestamp = time;
    }
    for (const auto& observation : *log.steps[i].seen) {
      observation->timestamp = time;
    }
  }
  return true;
}

}  // namespace sbox
