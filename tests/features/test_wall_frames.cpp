// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "sbox/features/wall_frames.h"

using namespace sbox;

namespace {

WallLine lineAt(double degrees, double length, double wall_share = 1) {
  const double angle = degrees * M_PI / 180;
  return {{1, 2}, {1 + length * std::cos(angle), 2 + length * std::sin(angle)}, wall_share};
}

double degrees(const WallFrame& frame) { return frame.direction * 180 / M_PI; }

/// Between two directions modulo a quarter turn, in degrees.
double apart(double left, double right) {
  const double off = std::abs(std::remainder(left - right, 90));
  return off;
}

}  // namespace

TEST_CASE("walls along and across a direction make one frame", "[features]") {
  for (const double direction : {0.0, 0.2, 17.0, 45.0, 63.4, 89.9}) {
    const std::vector<WallLine> lines{lineAt(direction, 5), lineAt(direction + 90, 3),
                                      lineAt(direction - 180, 4), lineAt(direction - 90, 2)};
    const auto frames = findFrames(lines);
    INFO(direction << " degrees");
    REQUIRE(frames.size() == 1);
    CHECK(apart(degrees(frames[0]), direction) < 0.3);
    CHECK(frames[0].direction >= 0);
    CHECK(frames[0].direction < M_PI / 2);
    CHECK(frames[0].weight == Approx(1));
  }
}

TEST_CASE("a wing at an odd angle is a frame of its own", "[features]") {
  const auto frames = findFrames({lineAt(10, 6), lineAt(10, 6), lineAt(40, 6), lineAt(130, 2)});
  REQUIRE(frames.size() == 2);
  CHECK(apart(degrees(frames[0]), 10) < 0.3);
  CHECK(apart(degrees(frames[1]), 40) < 0.3);
  // Squared lengths: 72 against 40.
  CHECK(frames[0].weight == Approx(72.0 / 112).margin(0.01));
  CHECK(frames[0].weight + frames[1].weight == Approx(1));
}

TEST_CASE("near directions are one frame, weak ones none, and there are not too many",
          "[features]") {
  CHECK(findFrames({lineAt(10, 6), lineAt(16, 5)}).size() == 1);
  CHECK(findFrames({lineAt(10, 6), lineAt(40, 2)}).size() == 1);
  const std::vector<WallLine> star{lineAt(5, 6), lineAt(25, 6), lineAt(45, 6), lineAt(65, 6)};
  CHECK(findFrames(star).size() == 3);
  FrameOptions options;
  options.max_frames = 1;
  CHECK(findFrames(star, options).size() == 1);
}

TEST_CASE("the edge of the unknown has no direction", "[features]") {
  const auto frames = findFrames({lineAt(10, 5), lineAt(50, 20, 0.1)});
  REQUIRE(frames.size() == 1);
  CHECK(apart(degrees(frames[0]), 10) < 0.3);
  CHECK(findFrames({lineAt(50, 20, 0.1)}).empty());
  CHECK(findFrames({}).empty());
}

TEST_CASE("the first frame is the direction that most squared length speaks for", "[features]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(0, 360), length(0.5, 6);
  for (int round = 0; round < 20; ++round) {
    std::vector<WallLine> lines;
    for (int i = 0; i < 12; ++i) {
      lines.push_back(lineAt(angle(random), length(random)));
    }
    const auto support = [&](double direction) {
      double sum = 0;
      for (const WallLine& line : lines) {
        const Eigen::Vector2d along = line.to - line.from;
        const double off = apart(std::atan2(along.y(), along.x()) * 180 / M_PI, direction);
        sum += along.squaredNorm() * std::exp(-0.5 * off * off / (2.0 * 2.0));
      }
      return sum;
    };
    double most = 0;
    for (double direction = 0; direction < 90; direction += 0.05) {
      most = std::max(most, support(direction));
    }
    const auto frames = findFrames(lines);
    REQUIRE(!frames.empty());
    CHECK(support(degrees(frames[0])) > 0.98 * most);
  }
}
