// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/pair_evidence.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sbox/core/pose_errors.h"

namespace sbox {
namespace {

/// No calibration is so good that it may rule out or settle anything for ever.
constexpr double kLeastProbability = 1e-6, kLeastNone = 1e-4;

/// Where the calculation of a covariance failed: a metre and six degrees.
PoseCovariance vagueCovariance() { return Eigen::Vector3d(1, 1, 0.01).asDiagonal(); }

/// By Cholesky's decomposition: determinants cancel out where frames lie far away.
bool isPositiveDefinite(const PoseCovariance& covariance) {
  return covariance.allFinite() && Eigen::LLT<PoseCovariance>(covariance).info() == Eigen::Success;
}

/// The covariance of `from` as that of `to`: the same error of the middle of b, along b's axes.
PoseCovariance carriedByMiddle(const PoseCovariance& covariance, const Pose2D& from,
                               const Pose2D& to, const Point2D& middle_b) {
  const Eigen::Vector2d middle(middle_b.x, middle_b.y);
  const Eigen::Matrix3d jacobian = leverTo(-(Eigen::Rotation2Dd(to.phi) * middle)) *
                                   turnedAxes(to.phi - from.phi) *
                                   leverTo(Eigen::Rotation2Dd(from.phi) * middle);
  return jacobian * covariance * jacobian.transpose();
}

/// The mean of that by the middle of b and that by the middle of a, so that the order of the maps
/// does not matter.
PoseCovariance carriedOver(const PoseCovariance& covariance, const Pose2D& from, const Pose2D& to,
                           const Footprint& a, const Footprint& b) {
  const PoseCovariance by_b = carriedByMiddle(covariance, from, to, b.centre);
  const PoseCovariance by_a = inverseCovariance(
      inverse(to),
      carriedByMiddle(inverseCovariance(from, covariance), inverse(from), inverse(to), a.centre));
  const PoseCovariance mean = (by_a + by_b) / 2;
  return (mean + mean.transpose()) / 2;
}

/// The factor by which the odds of belonging together change where this share of all pairs does,
/// instead of half.
double oddsFactor(double share) { return std::min(1.0, share / (1 - share)); }

/// How many of the pairs belong together, if this share does.
double expectedCount(const std::vector<PairEvidence>& pairs, double share) {
  const double factor = oddsFactor(share);
  double sum = 0;
  for (const PairEvidence& pair : pairs) {
    double right = 0;
    for (const EdgeCandidate& candidate : pair.candidates) {
      right += factor * candidate.probability;
    }
    sum += right / (right + pair.none);
  }
  return sum;
}

}  // namespace

bool isSamePose(const PoseGap& gap, const Footprint& a, const Footprint& b,
                const SamePoseOptions& options) {
  return gap.turn <= options.turn &&
         gap.distance <= options.distance + options.distance_share * (a.radius + b.radius) / 2;
}

double trustOnAgreement(const PairEvidence& pair, int candidate) {
  if (pair.accepted == candidate) {
    return 1;
  }
  const double right =
      pair.candidates[static_cast<size_t>(candidate)].probability * std::exp(kLogCoincidence);
  return right / (right + pair.none);
}

PairEvidence evidenceOf(const MapPair& pair, const Footprint& a, const Footprint& b) {
  PairEvidence evidence{pair.a, pair.b, -1, {}, 1};
  const PairResult& result = pair.result;
  if (!result.has_pose) {
    return evidence;
  }
  evidence.accepted = result.verdict == Verdict::Accepted ? 0 : -1;
  const PoseCovariance covariance =
      isPositiveDefinite(result.covariance) ? result.covariance : vagueCovariance();
  evidence.candidates.push_back({result.pose_b_in_a, covariance, result.confidence});
  for (const Candidate& other : result.alternatives) {
    evidence.candidates.push_back(
        {other.pose_b_in_a, carriedOver(covariance, result.pose_b_in_a, other.pose_b_in_a, a, b),
         other.confidence});
  }
  double sum = 0;
  for (EdgeCandidate& candidate : evidence.candidates) {
    candidate.probability = std::clamp(candidate.probability, kLeastProbability, 1.0);
    sum += candidate.probability;
  }
  evidence.none = std::max(1 - sum, kLeastNone);
  return evidence;
}

void normalise(PairEvidence& pair) {
  double sum = pair.none;
  for (const EdgeCandidate& candidate : pair.candidates) {
    sum += candidate.probability;
  }
  pair.none /= sum;
  for (EdgeCandidate& candidate : pair.candidates) {
    candidate.probability /= sum;
  }
}

void weighByBaseRate(std::vector<PairEvidence>& pairs) {
  constexpr int most_rounds = 100;
  const auto count = static_cast<double>(pairs.size());
  double share = 0.5;
  for (int round = 0; round < most_rounds; ++round) {
    // As if one more pair that belongs together had been seen, and one that does not.
    share = (1 + expectedCount(pairs, share)) / (2 + count);
  }
  const double factor = oddsFactor(share);
  for (PairEvidence& pair : pairs) {
    for (EdgeCandidate& candidate : pair.candidates) {
      candidate.probability *= factor;
    }
    normalise(pair);
  }
}

}  // namespace sbox
