// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/slam/paired_entries.h"
#include "sbox/slam/stamp_steps.h"
#include "slam/driven_logs.h"

using namespace sbox;
using namespace sbox::test;

namespace {

mrpt::Clock::time_point scanTime(const LogStep& step) { return (*step.seen->begin())->timestamp; }

void checkTimesGoOn(const ScanLog& log) {
  for (size_t i = 0; i < log.steps.size(); ++i) {
    CHECK(scanTime(log.steps[i]) == (*log.steps[i].moved->begin())->timestamp);
    if (i > 0) {
      CHECK(scanTime(log.steps[i]) > scanTime(log.steps[i - 1]));
    }
  }
}

}  // namespace

TEST_CASE("times that go on are left alone", "[stamp_steps]") {
  ScanLog log = stepsOfPairs(pairedLog());
  CHECK_FALSE(stampSteps(log));
  CHECK(scanTime(log.steps[3]) == timeOf(3, true));
}

TEST_CASE("a log without times is given some", "[stamp_steps]") {
  ScanLog log = stepsOfPairs(pairedLog(false));
  CHECK(stampSteps(log));
  checkTimesGoOn(log);
}

TEST_CASE("a log whose actions have no time is given some", "[stamp_steps]") {
  ScanLog log = stepsOfPairs(pairedLog());
  (*log.steps[5].moved->begin())->timestamp = INVALID_TIMESTAMP;
  CHECK(stampSteps(log));
  checkTimesGoOn(log);
}

TEST_CASE("a log with a step back in time is given times", "[stamp_steps]") {
  ScanLog log = stepsOfPairs(pairedLog());
  (*log.steps[5].seen->begin())->timestamp = timeOf(3, true);
  CHECK(stampSteps(log));
  checkTimesGoOn(log);
}

TEST_CASE("a log all at one time is given times", "[stamp_steps]") {
  ScanLog log = stepsOfPairs(pairedLog());
  for (const LogStep& step : log.steps) {
    (*step.seen->begin())->timestamp = timeOf(3, true);
  }
  CHECK(stampSteps(log));
  checkTimesGoOn(log);
}
