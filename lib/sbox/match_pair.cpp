// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/match_pair.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "sbox/core/number_text.h"
#include "sbox/core/pose_errors.h"
#include "sbox/core/stopwatch.h"

namespace sbox {
namespace {

constexpr size_t kMostAlternatives = 5;

/// Covariance of the pose of the map frame of b in that of a.
PoseCovariance frameCovariance(const MapFeatures& a, const MapFeatures& b,
                               const RefinedPose& refined) {
  // From the pivot to the origin of b's map frame: the heading's error moves it.
  const Pose2D b_in_grid_b = inverse(b.grid_in_map);
  const Eigen::Vector2d arm = Eigen::Rotation2Dd(refined.b_in_a.heading) *
                              (Eigen::Vector2d(b_in_grid_b.x, b_in_grid_b.y) - refined.pivot_b);
  const Eigen::Matrix3d jacobian = turnedAxes(a.grid_in_map.phi) * leverTo(arm);
  return jacobian * refined.covariance * jacobian.transpose();
}

/// Multiplies the odds of the first fit by a factor; the others and "none" share the rest as
/// before.
void multiplyOddsOfFirst(std::vector<Fit>& fits, double factor) {
  const double first = fits.front().probability;
  const double sum = factor * first + 1 - first;
  for (Fit& fit : fits) {
    fit.probability /= sum;
  }
  fits.front().probability *= factor;
}

std::string describeDifference(double metres) {
  return "; the Kalman step and Ceres differ by " + fixedDigits(metres, 1) + " m";
}

/// All fits that were worth judging, the most probable first: those near the guess, if there is
/// one, then of all hypotheses that features propose, then of those that a full search finds; the
/// search ends where it leaves no doubt.
std::vector<Fit> findFits(const MapFeatures& a, const MapFeatures& b, const PairOptions& options,
                          PairSeconds& seconds, const std::optional<GuessedPoses>& guess,
                          int threads) {
  std::vector<Fit> fits;
  // Fits of the hypotheses and of what was found before; whether they leave no doubt.
  const auto isSure = [&](std::vector<Hypothesis> hypotheses, bool is_thorough = false) {
    const Stopwatch stopwatch;
    for (const Fit& fit : fits) {
      hypotheses.push_back({fit.b_in_a, 0});
    }
    fits = rankHypotheses(a, b, hypotheses, options.ranking, is_thorough, threads);
    judge(fits);
    seconds.verification += stopwatch.seconds();
    return !fits.empty() && fits.front().probability >= options.sure;
  };
  // Section 3.2, rough match and eq. 4: corners and boxes vote.
  Stopwatch stopwatch;
  const std::vector<Hypothesis> votes = voteForTransforms(a, b, options.votes);
  seconds.matching += stopwatch.seconds();
  if (guess) {
    stopwatch = Stopwatch();
    std::vector<Hypothesis> near =
        transformsNear(a, b, *guess, options.correlation.headings, options.guess);
    const std::vector<Hypothesis> allowed = allowedBy(*guess, a, b, votes, options.guess);
    near.insert(near.end(), allowed.begin(), allowed.end());
    seconds.matching += stopwatch.seconds();
    if (isSure(std::move(near))) {
      return fits;
    }
  }
  if (isSure(votes)) {
    return fits;
  }
  // What no corner or box proposes.
  stopwatch = Stopwatch();
  std::vector<Hypothesis> searched =
      searchByCorrelation(a, b, options.correlation, options.ranking.evidence, threads);
  // The headings and cells that are tried depend on which map is turned.
  for (const Hypothesis& hypothesis :
       searchByCorrelation(b, a, options.correlation, options.ranking.evidence, threads)) {
    searched.push_back({hypothesis.b_in_a.inverse(), hypothesis.votes});
  }
  seconds.matching += stopwatch.seconds();
  isSure(std::move(searched), true);
  return fits;
}

PairResult matchInOrder(const MapFeatures& a, const MapFeatures& b, const PairOptions& options,
                        const std::optional<GuessedPoses>& guess, int threads) {
  PairResult result;
  if (a.empty() || b.empty()) {
    result.reason = a.empty() && b.empty()
                        ? "neither map has a wall with free space beside it"
                        : "one of the maps has no wall with free space beside it";
    return result;
  }
  std::vector<Fit> fits = findAnswers(a, b, options, result.seconds, guess, threads);
  if (fits.empty()) {
    result.reason = decide(fits, options.verdict).reason;
    return result;
  }
  Fit& best = fits.front();
  const std::vector<BoxMatch> boxes = matchBoxes(a, b, best.b_in_a, best.drift, options.boxes);
  for (const BoxMatch& match : boxes) {
    result.matched_boxes.emplace_back(match.a, match.b);
  }
  // Section 3.3: refinement.
  const Stopwatch stopwatch;
  const RefinedPose refined = refinePose(a, b, best.b_in_a, best.drift, boxes, options.refine);
  if (refined.is_doubtful) {
    multiplyOddsOfFirst(fits, options.refine.difference_odds);
  }
  const Verdicted verdicted = decide(fits, options.verdict);
  result.verdict = verdicted.verdict;
  result.reason = verdicted.reason;
  if (refined.is_doubtful) {
    result.reason += describeDifference(refined.disagreement());
  }
  result.has_pose = true;
  result.confidence = best.probability;
  result.overlap_m2 = best.evidence.free_free;
  result.pose_b_in_a = framePose(a, b, refined.b_in_a);
  result.covariance = frameCovariance(a, b, refined);
  if (refined.kalman) {
    result.kalman = framePose(a, b, *refined.kalman);
  }
  if (refined.ceres) {
    result.ceres = framePose(a, b, *refined.ceres);
  }
  result.seconds.refinement = stopwatch.seconds();
  for (size_t i = 1; i < fits.size() && i <= kMostAlternatives; ++i) {
    result.alternatives.push_back({framePose(a, b, fits[i].b_in_a), fits[i].probability});
  }
  return result;
}

/// The result for (b, a) from that for (a, b).
PairResult exchanged(PairResult result) {
  if (!result.has_pose) {
    return result;
  }
  result.covariance = inverseCovariance(result.pose_b_in_a, result.covariance);
  result.pose_b_in_a = inverse(result.pose_b_in_a);
  for (std::optional<Pose2D>* pose : {&result.kalman, &result.ceres}) {
    if (*pose) {
      *pose = inverse(**pose);
    }
  }
  for (Candidate& alternative : result.alternatives) {
    alternative.pose_b_in_a = inverse(alternative.pose_b_in_a);
  }
  for (std::pair<int, int>& match : result.matched_boxes) {
    std::swap(match.first, match.second);
  }
  return result;
}

}  // namespace

Pose2D framePose(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a) {
  const Pose2D grid_b_in_grid_a(b_in_a.translation.x(), b_in_a.translation.y(), b_in_a.heading);
  Pose2D pose = a.grid_in_map + grid_b_in_grid_a + inverse(b.grid_in_map);
  pose.phi = wrapAngle(pose.phi);
  return pose;
}

std::vector<Fit> findAnswers(const MapFeatures& a, const MapFeatures& b, const PairOptions& options,
                             PairSeconds& seconds, const std::optional<GuessedPoses>& guess,
                             int threads) {
  std::vector<Fit> fits = findFits(a, b, options, seconds, guess, threads);
  mergeAnswers(a, b, fits, options.same);
  judge(fits);
  return fits;
}

PairResult matchPair(const MapFeatures& a, const MapFeatures& b, const PairOptions& options,
                     const std::optional<GuessedPoses>& guess, int threads) {
  // Each pair is matched in one order, whichever way round it is given.
  if (!comesFirst(b, a)) {
    return matchInOrder(a, b, options, guess, threads);
  }
  std::optional<GuessedPoses> turned = guess;
  if (turned) {
    std::swap(turned->pose_a, turned->pose_b);
    std::swap(turned->sigma_phi_a, turned->sigma_phi_b);
  }
  return exchanged(matchInOrder(b, a, options, turned, threads));
}

}  // namespace sbox
