// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/initial_guess.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sbox {
namespace {

/// What is left of a candidate's odds however far from the guess it lies.
constexpr double kTail = 0.1;
/// By how much a sharp guess multiplies the odds of a candidate where it expects it.
constexpr double kGain = 20;
/// Maps drift, and nobody's frame is exact: metres and radians that every guess may be off.
constexpr double kDrift = 0.5, kDriftTurn = 0.05;

/// Standard deviation of where the middles of both maps lie to each other, and the distance at
/// which the guesses put them, metres.
struct MiddleGap {
  double spread = 0;
  double distance = 0;
};

MiddleGap gapOfMiddles(const InitialGuess& a, const InitialGuess& b, const Footprint& shape_a,
                       const Footprint& shape_b) {
  MiddleGap gap;
  gap.distance = (a.pose.composePoint(shape_a.centre) - b.pose.composePoint(shape_b.centre)).norm();
  // A heading that is off moves what lies far away.
  const double turn = std::hypot(a.sigma_phi, b.sigma_phi);
  gap.spread = std::sqrt(a.sigma_xy * a.sigma_xy + b.sigma_xy * b.sigma_xy +
                         std::pow(turn * gap.distance / 2, 2) + kDrift * kDrift);
  return gap;
}

/// How far a pose is from where the guesses put it.
PoseGap gapToGuess(const InitialGuess& a, const InitialGuess& b, const Footprint& shape_a,
                   const Footprint& shape_b, const Pose2D& pose_b_in_a) {
  return gapBetween(shape_a, shape_b, pose_b_in_a, inverse(a.pose) + b.pose);
}

/// The gap in standard deviations, squared; `spread` is that of MiddleGap.
double squaredDeviations(const PoseGap& gap, const InitialGuess& a, const InitialGuess& b,
                         double spread) {
  const double sigma_turn = std::hypot(a.sigma_phi, b.sigma_phi);
  return std::pow(gap.distance / spread, 2) +
         std::pow(gap.turn, 2) / (sigma_turn * sigma_turn + kDriftTurn * kDriftTurn);
}

double factorOf(const EdgeCandidate& candidate, const InitialGuess& a, const InitialGuess& b,
                const Footprint& shape_a, const Footprint& shape_b) {
  const double spread = gapOfMiddles(a, b, shape_a, shape_b).spread;
  const double squared =
      squaredDeviations(gapToGuess(a, b, shape_a, shape_b, candidate.pose_b_in_a), a, b, spread);
  // A guess that allows everywhere says nothing.
  const double reach = 1 + (shape_a.radius + shape_b.radius) / 2;
  const double sharpness = reach * reach / (reach * reach + spread * spread);
  const double tail = 1 - (1 - kTail) * sharpness;
  return tail + kGain * sharpness * std::exp(-squared / 2);
}

}  // namespace

std::vector<const InitialGuess*> guessOfEachMap(const std::vector<InitialGuess>& guesses,
                                                size_t map_count) {
  std::vector<const InitialGuess*> of_map(map_count, nullptr);
  for (const InitialGuess& guess : guesses) {
    if (guess.map < 0 || static_cast<size_t>(guess.map) >= map_count ||
        of_map[static_cast<size_t>(guess.map)] != nullptr) {
      throw std::invalid_argument("each guess must be of a map, and of each map once");
    }
    of_map[static_cast<size_t>(guess.map)] = &guess;
  }
  return of_map;
}

std::vector<PairIndex> pairsThatMayMeet(const std::vector<InitialGuess>& guesses,
                                        const std::vector<Footprint>& maps) {
  constexpr double deviations = 3;
  const std::vector<const InitialGuess*> of_map = guessOfEachMap(guesses, maps.size());
  std::vector<PairIndex> pairs;
  for (size_t a = 0; a < maps.size(); ++a) {
    for (size_t b = a + 1; of_map[a] != nullptr && b < maps.size(); ++b) {
      if (of_map[b] == nullptr) {
        continue;
      }
      const MiddleGap gap = gapOfMiddles(*of_map[a], *of_map[b], maps[a], maps[b]);
      // What is known of a map reaches about twice its radius.
      if (gap.distance < 2 * (maps[a].radius + maps[b].radius) + deviations * gap.spread) {
        pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
      }
    }
  }
  return pairs;
}

std::optional<OverruledGuess> overruledGuess(const InitialGuess& a, const InitialGuess& b,
                                             const Footprint& shape_a, const Footprint& shape_b,
                                             const Pose2D& pose_b_in_a) {
  const PoseGap gap = gapToGuess(a, b, shape_a, shape_b, pose_b_in_a);
  constexpr double most_deviations = 5;
  if (squaredDeviations(gap, a, b, gapOfMiddles(a, b, shape_a, shape_b).spread) <=
      most_deviations * most_deviations) {
    return std::nullopt;
  }
  return OverruledGuess{b.map, a.map, gap.distance, gap.turn};
}

void weighByGuesses(const std::vector<InitialGuess>& guesses, const std::vector<Footprint>& maps,
                    double accept_from, std::vector<PairEvidence>& pairs) {
  const std::vector<const InitialGuess*> of_map = guessOfEachMap(guesses, maps.size());
  for (PairEvidence& pair : pairs) {
    const InitialGuess* a = of_map[static_cast<size_t>(pair.a)];
    const InitialGuess* b = of_map[static_cast<size_t>(pair.b)];
    if (a == nullptr || b == nullptr || pair.candidates.empty()) {
      continue;
    }
    for (EdgeCandidate& candidate : pair.candidates) {
      candidate.probability *= factorOf(candidate, *a, *b, maps[static_cast<size_t>(pair.a)],
                                        maps[static_cast<size_t>(pair.b)]);
    }
    normalise(pair);
    const auto likeliest =
        std::max_element(pair.candidates.begin(), pair.candidates.end(),
                         [](const EdgeCandidate& left, const EdgeCandidate& right) {
                           return left.probability < right.probability;
                         });
    pair.accepted = likeliest->probability >= accept_from
                        ? static_cast<int>(likeliest - pair.candidates.begin())
                        : -1;
  }
}

}  // namespace sbox
