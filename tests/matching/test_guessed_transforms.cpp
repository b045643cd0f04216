// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/match_pair.h"
#include "sbox/matching/guessed_transforms.h"

using namespace sbox;

namespace {

/// Two halves of a floor that share its middle, in frames of their own.
struct Halves {
  const Pose2D pose_a{2, 1, 0.3}, pose_b{15, -6, -0.9};  ///< Of the frames in the floor.
  MapFeatures a, b;

  Halves() {
    const test::Floor floor = test::officeFloor();
    a = extractFeatures(test::exploreMap(floor, pose_a, 0.1, {{-1, -1}, {16, 15}}));
    b = extractFeatures(test::exploreMap(floor, pose_b, 0.1, {{5, -1}, {25, 15}}));
  }
  [[nodiscard]] GuessedPoses guessOffBy(double x, double turn) const {
    // Guesses may be in any frame.
    const Pose2D frame(100, -50, 2);
    return {frame + pose_a, frame + pose_b + Pose2D(x, 0, turn), 1, 0.08, 0.06};
  }
};

/// Distance of the middle of b, and angle, from where it really is.
std::pair<double, double> offBy(const Halves& halves, const RigidTransform& b_in_a) {
  const Pose2D grid_b_in_grid_a =
      inverse(halves.pose_a + halves.a.grid_in_map) + halves.pose_b + halves.b.grid_in_map;
  const Eigen::Vector2d middle(halves.b.width / 2, halves.b.height / 2);
  const Point2D truth = grid_b_in_grid_a.composePoint({middle.x(), middle.y()});
  const Eigen::Vector2d found = b_in_a * middle;
  return {std::hypot(found.x() - truth.x, found.y() - truth.y),
          std::abs(wrapAngle(b_in_a.heading - grid_b_in_grid_a.phi))};
}

}  // namespace

TEST_CASE("transforms near a guess are near it, dense, and hold the truth where it is near",
          "[guess]") {
  const Halves halves;
  const GuessedPoses guess = halves.guessOffBy(1.2, 0.08);
  const GuessOptions options;
  const std::vector<Hypothesis> near =
      transformsNear(halves.a, halves.b, guess, HeadingOptions(), options);
  double nearest = 1e9;
  for (const Hypothesis& hypothesis : near) {
    const auto [distance, turn] = offBy(halves, hypothesis.b_in_a);
    CHECK(distance < 1.5 * options.deviations * 2.5 + 3);  // Arms of some 20 m.
    CHECK(turn < options.deviations * 0.1 + 0.08 + 1e-9);
    nearest = std::min(nearest, distance + 5 * turn);
  }
  CHECK(nearest < options.spacing);
}

TEST_CASE("a vague guess is searched by no more transforms than allowed", "[guess]") {
  const Halves halves;
  GuessedPoses guess = halves.guessOffBy(0, 0);
  guess.sigma_xy = 1000;
  GuessOptions options;
  options.most = 100;
  const size_t headings = findHeadings(halves.a, halves.b).size();
  const std::vector<Hypothesis> near =
      transformsNear(halves.a, halves.b, guess, HeadingOptions(), options);
  CHECK(near.size() >= 81);
  CHECK(near.size() <= 100 * headings);
}

TEST_CASE("a guess allows what is within its deviations", "[guess]") {
  const Halves halves;
  const GuessedPoses guess = halves.guessOffBy(0, 0);
  const std::vector<Hypothesis> near =
      transformsNear(halves.a, halves.b, guess, HeadingOptions(), {});
  GuessOptions fewer;
  fewer.deviations = 2.3;  // Where no point of the lattice lies.
  const std::vector<Hypothesis> allowed = allowedBy(guess, halves.a, halves.b, near, fewer);
  // The middle of b from the frames of a and b, metres.
  const Eigen::Vector2d middle(halves.b.width / 2, halves.b.height / 2);
  const Point2D in_b = halves.b.grid_in_map.composePoint({middle.x(), middle.y()});
  const Point2D in_a = (inverse(halves.pose_a) + halves.pose_b).composePoint(in_b);
  const double reach =
      2.3 * std::hypot(guess.sigma_xy, guess.sigma_phi_a * std::hypot(in_a.x, in_a.y),
                       guess.sigma_phi_b * std::hypot(in_b.x, in_b.y));
  size_t expected = 0;
  for (const Hypothesis& hypothesis : near) {
    const auto [distance, turn] = offBy(halves, hypothesis.b_in_a);
    expected += distance <= reach && turn <= 2.3 * std::hypot(guess.sigma_phi_a, guess.sigma_phi_b);
  }
  CHECK(allowed.size() == expected);
  CHECK(expected > 0);
  CHECK(expected < near.size());
}

TEST_CASE("the answer is the same with a right guess and with a wrong one", "[guess]") {
  const Halves halves;
  const PairResult without = matchPair(halves.a, halves.b);
  REQUIRE(without.verdict == Verdict::Accepted);
  for (const double off : {0.5, 30.0}) {
    const PairResult with = matchPair(halves.a, halves.b, {}, halves.guessOffBy(off, 0));
    CHECK(with.verdict == Verdict::Accepted);
    CHECK(with.pose_b_in_a.x == Approx(without.pose_b_in_a.x).margin(0.02));
    CHECK(with.pose_b_in_a.y == Approx(without.pose_b_in_a.y).margin(0.02));
    CHECK(with.pose_b_in_a.phi == Approx(without.pose_b_in_a.phi).margin(0.002));
  }
}

TEST_CASE("with a guess, exchanging the maps gives the inverse exactly, too", "[guess]") {
  const Halves halves;
  const GuessedPoses guess = halves.guessOffBy(0.5, 0.02);
  GuessedPoses turned = guess;
  std::swap(turned.pose_a, turned.pose_b);
  std::swap(turned.sigma_phi_a, turned.sigma_phi_b);
  const Pose2D b_in_a = matchPair(halves.a, halves.b, {}, guess).pose_b_in_a;
  const Pose2D a_in_b = inverse(matchPair(halves.b, halves.a, {}, turned).pose_b_in_a);
  CHECK(b_in_a.x == Approx(a_in_b.x).margin(1e-12));
  CHECK(b_in_a.y == Approx(a_in_b.y).margin(1e-12));
  CHECK(b_in_a.phi == Approx(a_in_b.phi).margin(1e-12));
}
