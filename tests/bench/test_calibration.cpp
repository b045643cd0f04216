// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox-bench/calibration.h"

using namespace sbox;
using namespace sbox::bench;

namespace {

Answer answerWith(double confidence, bool right, bool accepted) {
  Answer answer;
  answer.result.has_pose = true;
  answer.result.confidence = confidence;
  answer.result.verdict = accepted ? Verdict::Accepted : Verdict::Rejected;
  answer.error = PoseError{0, 0, right};
  return answer;
}

}  // namespace

TEST_CASE("confidences are binned with what was right", "[bench][calibration]") {
  const Answer answers[] = {answerWith(0.05, false, false), answerWith(0.92, true, true),
                            answerWith(0.94, false, true), answerWith(1.0, true, true), Answer{}};
  std::vector<const Answer*> list;
  for (const Answer& answer : answers) {
    list.push_back(&answer);
  }
  const Reliability all = reliability(list);
  CHECK(all.answers == 4);  // The last has no pose.
  CHECK(all.brier == Approx((0.05 * 0.05 + 0.08 * 0.08 + 0.94 * 0.94) / 4));
  int counted = 0;
  for (const ReliabilityBin& bin : all.bins) {
    counted += bin.answers;
    if (bin.from == 0.9) {
      CHECK(bin.answers == 2);
      CHECK(bin.right == 1);
      CHECK(bin.accepted == 2);
      CHECK(bin.accepted_right == 1);
      CHECK(bin.mean_confidence == Approx(0.93));
    }
  }
  CHECK(counted == 4);
  CHECK(all.bins.front().answers == 1);
  CHECK(all.bins.back().answers == 1);
  CHECK(std::isnan(reliability({}).brier));
}
