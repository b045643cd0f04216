// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rough poses that somebody knows beforehand. They speak for candidates near to them and against
// the others, but with tails so heavy that a wrong guess is overruled by maps that are sure.
#pragma once

#include <optional>
#include <vector>

#include "sbox/placement/footprint.h"
#include "sbox/placement/pair_evidence.h"

namespace sbox {

/// Where a map is thought to lie. All guesses share one frame, whichever.
struct InitialGuess {
  int map = 0;           ///< Index of the map.
  Pose2D pose;           ///< Frame of the map in the common frame.
  double sigma_xy = 1;   ///< Standard deviation of x and of y, metres; above 0.
  double sigma_phi = 1;  ///< Standard deviation of the heading, radians; above 0.
};

/// The guess of each map, or null. Throws std::invalid_argument if a guess names a map that does
/// not exist, or one that has a guess already.
[[nodiscard]] std::vector<const InitialGuess*> guessOfEachMap(
    const std::vector<InitialGuess>& guesses, size_t map_count);

/// The pairs of maps that their guesses lay so near to each other that they may overlap, in
/// ascending order. Throws as guessOfEachMap() does.
[[nodiscard]] std::vector<PairIndex> pairsThatMayMeet(const std::vector<InitialGuess>& guesses,
                                                      const std::vector<Footprint>& maps);

/// A map that lies elsewhere than the guesses say.
struct OverruledGuess {
  int map = 0;          ///< Index of the map.
  int beside = 0;       ///< Index of the map beside which its guess puts it elsewhere.
  double distance = 0;  ///< From there, of the maps' middles, metres.
  double turn = 0;      ///< From there, radians.
};

/// What is wrong with the guesses of two maps if b lies at `pose_b_in_a`: nothing within five
/// standard deviations.
[[nodiscard]] std::optional<OverruledGuess> overruledGuess(const InitialGuess& a,
                                                           const InitialGuess& b,
                                                           const Footprint& shape_a,
                                                           const Footprint& shape_b,
                                                           const Pose2D& pose_b_in_a);

/// Weighs the candidates of all pairs of which both maps have a guess, and accepts the likeliest
/// from probability `accept_from` on. Throws as guessOfEachMap() does.
void weighByGuesses(const std::vector<InitialGuess>& guesses, const std::vector<Footprint>& maps,
                    double accept_from, std::vector<PairEvidence>& pairs);

}  // namespace sbox
