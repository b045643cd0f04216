// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "drawing.h"
#include "sbox/matching/feature_votes.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

/// Corners and boxes anywhere in 12 m x 9 m, in one frame of that direction.
MapFeatures randomFeatures(unsigned seed, double direction, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto mask = [&] {
    return static_cast<QuarterMask>(std::uniform_int_distribution<int>(0, 15)(random));
  };
  MapFeatures map;
  map.width = 12;
  map.height = 9;
  FrameFeatures frame;
  frame.frame.direction = direction;
  const Eigen::Rotation2Dd to_frame(-direction);
  for (int i = 0; i < count; ++i) {
    WallCorner corner;
    corner.position = to_frame * Vector2d(between(0, 12), between(0, 9));
    // Few kinds, so that many pairs look alike.
    corner.free_sides = std::uniform_int_distribution<int>(0, 1)(random) == 0 ? 3 : 12;
    corner.arms = std::uniform_int_distribution<int>(0, 1)(random) == 0 ? 3 : 9;
    frame.corners.push_back(corner);
    WallBox box;
    box.size_x = between(1, 6);
    box.size_y = between(1, 6);
    box.facing_in = mask();
    box.centre = to_frame * Vector2d(between(0, 12), between(0, 9));
    box.corners.fill(box.centre);  // Not what is voted by.
    frame.boxes.push_back(box);
  }
  map.frames.push_back(frame);
  return map;
}

/// A pair of features that look alike: where it puts the middle of map b in a's frame axes.
struct Vote {
  Vector2d place;
  double weight;
};

/// Turned one quarter turn at a time.
Vector2d quarterTurned(Vector2d p, int turns) {
  for (int i = 0; i < turns; ++i) {
    p = Vector2d(-p.y(), p.x());
  }
  return p;
}

/// One vote for each pair of the things for which looksAlike(i, j), weighed by how often both were
/// used.
template <typename LooksAlike, typename Place>
void collect(size_t count_a, size_t count_b, const LooksAlike& looksAlike, const Place& place,
             std::vector<Vote>& votes) {
  for (size_t i = 0; i < count_a; ++i) {
    for (size_t j = 0; j < count_b; ++j) {
      if (!looksAlike(i, j)) {
        continue;
      }
      int uses_i = 0, uses_j = 0;
      for (size_t other = 0; other < count_b; ++other) {
        uses_i += looksAlike(i, other) ? 1 : 0;
      }
      for (size_t other = 0; other < count_a; ++other) {
        uses_j += looksAlike(other, j) ? 1 : 0;
      }
      votes.push_back({place(i, j), 1 / std::sqrt(1.0 * uses_i * uses_j)});
    }
  }
}

std::vector<Vote> votesOfAllPairs(const MapFeatures& map_a, const MapFeatures& map_b, int turns,
                                  const VoteOptions& options) {
  const FrameFeatures &a = map_a.frames[0], &b = map_b.frames[0];
  const Vector2d middle_b =
      Eigen::Rotation2Dd(-b.frame.direction) * Vector2d(map_b.width / 2, map_b.height / 2);
  std::vector<Vote> votes;
  collect(
      a.corners.size(), b.corners.size(),
      [&](size_t i, size_t j) {
        return a.corners[i].free_sides == turned(b.corners[j].free_sides, turns) &&
               a.corners[i].arms == turned(b.corners[j].arms, turns);
      },
      [&](size_t i, size_t j) -> Vector2d {
        return a.corners[i].position + quarterTurned(middle_b - b.corners[j].position, turns);
      },
      votes);
  collect(
      a.boxes.size(), b.boxes.size(),
      [&](size_t i, size_t j) {
        const WallBox &box_a = a.boxes[i], &box_b = b.boxes[j];
        const double x = turns % 2 == 0 ? box_b.size_x : box_b.size_y;
        const double y = turns % 2 == 0 ? box_b.size_y : box_b.size_x;
        const auto fits = [&](double size_a, double size_b) {
          return std::abs(size_a - size_b) <= options.size_tolerance + options.size_ratio * size_a;
        };
        return box_a.facing_in == turned(box_b.facing_in, turns) && fits(box_a.size_x, x) &&
               fits(box_a.size_y, y);
      },
      [&](size_t i, size_t j) -> Vector2d {
        return a.boxes[i].centre + quarterTurned(middle_b - b.boxes[j].centre, turns);
      },
      votes);
  return votes;
}

double weightWithin(const std::vector<Vote>& votes, const Vector2d& place, double reach) {
  double sum = 0;
  for (const Vote& vote : votes) {
    sum += (vote.place - place).cwiseAbs().maxCoeff() <= reach ? vote.weight : 0;
  }
  return sum;
}

/// The same floor, seen whole by both robots.
MapFeatures seen(const test::Floor& floor, const Pose2D& map_in_world) {
  return extractFeatures(test::exploreMap(floor, map_in_world, 0.1));
}

}  // namespace

TEST_CASE("bins count the votes of all pairs that look alike", "[matching]") {
  VoteOptions options;
  options.max_hypotheses = 1000000;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const MapFeatures a = randomFeatures(seed, 0.2, 40), b = randomFeatures(seed + 70, 1.1, 30);
    const auto found = voteForTransforms(a, b, options);
    INFO("seed " << seed);
    size_t hypotheses = 0;
    int too_few = 0, too_many = 0, missed = 0, pairs = 0;
    for (int turns = 0; turns < 4; ++turns) {
      const std::vector<Vote> votes = votesOfAllPairs(a, b, turns, options);
      const double heading = 0.2 - 1.1 + turns * M_PI / 2;
      std::vector<Vector2d> places;
      for (const Hypothesis& hypothesis : found) {
        if (std::abs(std::remainder(hypothesis.b_in_a.heading - heading, 2 * M_PI)) > 1e-6) {
          continue;
        }
        ++hypotheses;
        const Vector2d place =
            Eigen::Rotation2Dd(-0.2) * (hypothesis.b_in_a * Vector2d(b.width / 2, b.height / 2));
        places.push_back(place);
        // A bin and its neighbours reach a bin's edge round any point in it, at least, and two at
        // most.
        too_few += hypothesis.votes < weightWithin(votes, place, options.bin) - 1e-9 ? 1 : 0;
        too_many += hypothesis.votes > weightWithin(votes, place, 2 * options.bin) + 1e-9 ? 1 : 0;
      }
      for (const Vote& vote : votes) {
        ++pairs;
        missed += std::any_of(places.begin(), places.end(),
                              [&](const Vector2d& place) {
                                return (place - vote.place).cwiseAbs().maxCoeff() <= options.bin;
                              })
                      ? 0
                      : 1;
      }
    }
    CHECK(pairs > 300);
    CHECK(hypotheses == found.size());
    CHECK(too_few == 0);
    CHECK(too_many == 0);
    CHECK(missed == 0);
  }
}

TEST_CASE("two robots' features vote for how their maps lie", "[matching]") {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const test::Floor floor = test::randomFloor(seed);
    const Pose2D a_in_world(1, 2, 0.1), b_in_world(-3, 4, 2.0);
    const MapFeatures a = seen(floor, a_in_world), b = seen(floor, b_in_world);
    const auto found = voteForTransforms(a, b);
    REQUIRE(!found.empty());
    const Pose2D truth = inverse(a_in_world) + b_in_world;
    const Pose2D b_in_a = inverse(a.grid_in_map) + truth + b.grid_in_map;
    INFO("seed " << seed);
    const RigidTransform& best = found[0].b_in_a;
    CHECK(std::abs(std::remainder(best.heading - b_in_a.phi, 2 * M_PI)) < 0.05);
    CHECK((best * Vector2d(b.width / 2, b.height / 2) -
           RigidTransform{b_in_a.phi, {b_in_a.x, b_in_a.y}} * Vector2d(b.width / 2, b.height / 2))
              .norm() < 1.5 * VoteOptions().bin);
  }
}

TEST_CASE("the most votes come first, and each heading keeps its share", "[matching]") {
  const MapFeatures a = randomFeatures(1, 0.2, 60), b = randomFeatures(2, 0.4, 60);
  VoteOptions options;
  options.max_hypotheses = 100;
  options.min_per_heading = 10;
  const auto found = voteForTransforms(a, b, options);
  CHECK(found.size() == 100);
  CHECK(std::is_sorted(found.begin(), found.end(),
                       [](const Hypothesis& l, const Hypothesis& r) { return l.votes > r.votes; }));
  for (int turns = 0; turns < 4; ++turns) {
    const auto count = std::count_if(found.begin(), found.end(), [&](const Hypothesis& h) {
      return std::abs(std::remainder(h.b_in_a.heading - (-0.2 + turns * M_PI / 2), 2 * M_PI)) <
             1e-6;
    });
    CHECK(count >= 10);
  }
  // What is kept is what has most votes of all that were found.
  options.max_hypotheses = 1000000;
  const auto all = voteForTransforms(a, b, options);
  REQUIRE(all.size() > 100);
  CHECK(all[0].votes == found[0].votes);
  CHECK(found.back().votes <= all[99].votes);
}

TEST_CASE("no features, no votes", "[matching]") {
  const MapFeatures some = randomFeatures(1, 0.2, 10);
  CHECK(voteForTransforms(some, MapFeatures()).empty());
  CHECK(voteForTransforms(MapFeatures(), some).empty());
  MapFeatures bare = some;
  bare.frames[0].corners.clear();
  bare.frames[0].boxes.clear();
  CHECK(voteForTransforms(some, bare).empty());
}

TEST_CASE("maps so large that there would be too many bins get larger ones", "[matching]") {
  const MapFeatures a = randomFeatures(1, 0.2, 60), b = randomFeatures(2, 0.4, 60);
  VoteOptions options;
  options.max_hypotheses = 1000000;
  const size_t found = voteForTransforms(a, b, options).size();
  options.most_bins = 100;
  const size_t found_in_few = voteForTransforms(a, b, options).size();
  // Of each of the four turns; and a bin more along each side.
  CHECK(found_in_few <= 4 * 11 * 11);
  CHECK(found_in_few > 50);
  CHECK(found > 2 * found_in_few);
}
