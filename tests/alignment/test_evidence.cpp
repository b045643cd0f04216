// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "drawing.h"
#include "sbox/alignment/evidence.h"
#include "scattered_map.h"

using namespace sbox;
using Eigen::Vector2d;
using test::ScatteredMap;

namespace {

/// Depths are counted along straight and diagonal steps, 5 % off at most, and rounded.
struct Depth {
  double least, most;

  explicit Depth(double exact) : least(0.95 * exact - 0.008), most(1.05 * exact + 0.008) {}
};

/// What depends on depth lies between these.
struct Bounds {
  double least = 0, most = 0;

  void add(const Bounds& other) {
    least += other.least;
    most += other.most;
  }
};

struct CountedWalls {
  double known = 0, agree = 0;
  Bounds conflict;

  void add(const CountedWalls& other) {
    known += other.known;
    agree += other.agree;
    conflict.add(other.conflict);
  }
};

/// What one map's walls and free points say, each asked by itself.
struct Counted {
  CountedWalls all, straight;
  Bounds shallow_conflict, deep_conflict;
  double free_free = 0;
  Bounds free_shallow;
  Eigen::Matrix2d facing = Eigen::Matrix2d::Zero();  ///< In the frame of the map that is asked.
};

/// The middle of the fields' cell that holds a point: places are told apart no finer.
Vector2d cellMiddle(const WallFields& fields, const Vector2d& p) {
  const Vector2d place = (p - fields.origin) / fields.resolution;
  return fields.origin +
         Vector2d(std::floor(place.x()) + 0.5, std::floor(place.y()) + 0.5) * fields.resolution;
}

bool isInside(const WallFields& fields, const Vector2d& p) {
  const Vector2d place = (p - fields.origin) / fields.resolution;
  return place.minCoeff() >= 0 && place.x() < fields.width && place.y() < fields.height;
}

/// Distance to the nearest cell that is not free, metres.
double depthAt(const StateGrid& grid, const Vector2d& p) {
  const int cx = static_cast<int>(std::floor(p.x() / grid.resolution));
  const int cy = static_cast<int>(std::floor(p.y() / grid.resolution));
  if (grid.at(cx, cy) != CellState::Free) {
    return 0;
  }
  double nearest = 1e9;
  for (int y = -1; y <= grid.height; ++y) {
    for (int x = -1; x <= grid.width; ++x) {
      if (grid.at(x, y) != CellState::Free) {
        nearest = std::min(nearest, grid.resolution * std::hypot(x - cx, y - cy));
      }
    }
  }
  return nearest;
}

double nearestWall(const MapFeatures& map, const Vector2d& p, const Vector2d& normal) {
  double nearest = 1e9;
  for (const WallPoint& wall : map.wall_points) {
    if (test::facesAlike(wall.normal, normal)) {
      nearest = std::min(nearest, (wall.position - p).norm());
    }
  }
  return nearest;
}

Counted count(const ScatteredMap& from, const ScatteredMap& to, const RigidTransform& transform,
              const EvidenceOptions& options = {}) {
  Counted sum;
  const WallFields& fields = to.features.fields;
  const Eigen::Rotation2Dd turn(transform.heading);
  for (const WallPoint& wall : from.features.wall_points) {
    const Vector2d p = transform * wall.position;
    if (!isInside(fields, p)) {
      continue;
    }
    const Vector2d middle = cellMiddle(fields, p), normal = turn * wall.normal;
    const double exact = nearestWall(to.features, middle, normal);
    const double distance = std::round(exact / WallFields::unit) * WallFields::unit;
    const double depth = depthAt(to.grid, middle);
    const double agree =
        exact <= 2 ? std::exp(-0.5 * distance * distance / (options.kernel * options.kernel)) : 0.0;
    sum.facing += agree * normal * normal.transpose();
    const Depth about(depth);
    const Bounds conflict = {conflictWeight(about.least, options) * (1 - agree),
                             conflictWeight(about.most, options) * (1 - agree)};
    const CountedWalls one = {depth > 0 ? 1 : agree, agree, conflict};
    sum.all.add(one);
    if (wall.line_length >= options.straight_from) {
      sum.straight.add(one);
      sum.shallow_conflict.add({about.most <= options.shallow_until ? conflict.least : 0,
                                about.least <= options.shallow_until ? conflict.most : 0});
      sum.deep_conflict.add({deepWeight(about.least, options) * (1 - agree),
                             deepWeight(about.most, options) * (1 - agree)});
    }
  }
  for (const Vector2d& free : from.features.free_points) {
    const Vector2d p = transform * free;
    const double there = isInside(fields, p) ? depthAt(to.grid, cellMiddle(fields, p)) : 0;
    if (there > 0) {
      const double here = depthAt(from.grid, cellMiddle(from.features.fields, free));
      const Depth about(std::min(there, here));
      sum.free_free += 1;
      sum.free_shallow.add({about.most <= options.shallow_until ? 1.0 : 0.0,
                            about.least <= options.shallow_until ? 1.0 : 0.0});
    }
  }
  return sum;
}

/// Headings a few degrees from a multiple of a sector; see scatteredMap().
RigidTransform randomTransform(std::mt19937& random) {
  std::uniform_real_distribution<double> shift(-3, 3), degrees(-5, 5);
  const double heading =
      std::uniform_int_distribution<int>(-4, 4)(random) * M_PI / 4 + degrees(random) * M_PI / 180;
  // The middle of the one map comes near to the middle of the other.
  const Vector2d middle(4, 3);
  return {heading,
          middle + Vector2d(shift(random), shift(random)) - Eigen::Rotation2Dd(heading) * middle};
}

/// What is found lies between bounds counted in points that stand for so much each.
void checkBounds(double found, double of_point, const Bounds& there, const Bounds& back) {
  CHECK(found >= of_point * (there.least + back.least) - 1e-6);
  CHECK(found <= of_point * (there.most + back.most) + 1e-6);
}

/// What is found, in metres, is what was counted in points of 0.2 m.
void checkSums(const WallSums& found, const CountedWalls& there, const CountedWalls& back) {
  const auto near = [](double points) { return Approx(0.2 * points).epsilon(1e-3).margin(0.01); };
  CHECK(found.agree == near(there.agree + back.agree));
  CHECK(found.known == near(there.known + back.known));
  checkBounds(found.conflict, 0.2, there.conflict, back.conflict);
}

/// What is deep in maps as small as these.
EvidenceOptions shallowRooms() {
  EvidenceOptions options;
  options.shallow_until = 0.7;
  options.deep_from = 0.8;
  options.deep_full = 1.2;
  return options;
}

void checkAlike(const Evidence& left, const Evidence& right, double tolerance) {
  const auto near = [&](double value) { return Approx(value).epsilon(0).margin(tolerance); };
  CHECK(left.known == near(right.known));
  CHECK(left.agree == near(right.agree));
  CHECK(left.conflict == near(right.conflict));
  CHECK(left.straight.known == near(right.straight.known));
  CHECK(left.straight.agree == near(right.straight.agree));
  CHECK(left.straight.conflict == near(right.straight.conflict));
  CHECK(left.shallow_conflict == near(right.shallow_conflict));
  CHECK(left.deep_conflict == near(right.deep_conflict));
  CHECK(left.free_free == near(right.free_free));
  CHECK(left.free_shallow == near(right.free_shallow));
}

}  // namespace

TEST_CASE("evidence is what each wall and each free point says by itself", "[alignment]") {
  std::mt19937 random(5);
  const EvidenceOptions options = shallowRooms();
  double agreed = 0, conflicted = 0, shallow = 0, deep = 0, free_shallow = 0, free_deep = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const ScatteredMap a = test::scatteredMap(seed), b = test::scatteredMap(seed + 100, 50);
    const RigidTransform b_in_a = randomTransform(random);
    INFO("seed " << seed);
    const Evidence found = gatherEvidence(a.features, b.features, b_in_a, kAllPoints, options);
    const Counted there = count(b, a, b_in_a, options);
    const Counted back = count(a, b, b_in_a.inverse(), options);
    checkSums(found, there.all, back.all);
    checkSums(found.straight, there.straight, back.straight);
    checkBounds(found.shallow_conflict, 0.2, there.shallow_conflict, back.shallow_conflict);
    checkBounds(found.deep_conflict, 0.2, there.deep_conflict, back.deep_conflict);
    CHECK(found.free_free == Approx(0.5 * 0.16 * (there.free_free + back.free_free)));
    checkBounds(found.free_shallow, 0.5 * 0.16, there.free_shallow, back.free_shallow);
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(b_in_a.heading).toRotationMatrix();
    const Eigen::Matrix2d facing = 0.2 * (there.facing + turn * back.facing * turn.transpose());
    CHECK((found.facing - facing).norm() < 0.02);
    agreed += found.straight.agree;
    conflicted += found.straight.conflict;
    shallow += found.shallow_conflict;
    deep += found.deep_conflict;
    free_shallow += found.free_shallow;
    free_deep += found.free_free - found.free_shallow;
  }
  // Else nothing was tested.
  CHECK(agreed > 5);
  CHECK(conflicted > 10);
  CHECK(shallow > 2);
  CHECK(deep > 5);
  CHECK(free_shallow > 10);
  CHECK(free_deep > 10);
}

TEST_CASE("an overlap alone is that of the whole evidence", "[alignment]") {
  std::mt19937 random(8);
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const MapFeatures a = test::scatteredMap(seed).features;
    const MapFeatures b = test::scatteredMap(seed + 100, 50).features;
    const RigidTransform b_in_a = randomTransform(random);
    const size_t most_points = seed % 2 == 0 ? kAllPoints : 50;
    const Overlap overlap = measureOverlap(a, b, b_in_a, most_points);
    const Evidence evidence = gatherEvidence(a, b, b_in_a, most_points);
    CHECK(overlap.known > 1);
    CHECK(overlap.known == Approx(evidence.known));
    CHECK(overlap.agree == Approx(evidence.agree));
    CHECK(overlap.conflict == Approx(evidence.conflict));
    CHECK(overlap.free_free > 1);
    CHECK(overlap.free_free == Approx(evidence.free_free));
  }
}

TEST_CASE("that places are told apart by cells changes little", "[alignment]") {
  std::mt19937 random(6);
  double found = 0, exact = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const ScatteredMap a = test::scatteredMap(seed, 400), b = test::scatteredMap(seed + 50, 400);
    const RigidTransform b_in_a = randomTransform(random);
    found += gatherEvidence(a.features, b.features, b_in_a).agree;
    for (const WallPoint& wall : b.features.wall_points) {
      const double d = nearestWall(a.features, b_in_a * wall.position,
                                   Eigen::Rotation2Dd(b_in_a.heading) * wall.normal);
      exact += 0.2 * std::exp(-0.5 * d * d / 0.25);
    }
    for (const WallPoint& wall : a.features.wall_points) {
      const double d = nearestWall(b.features, b_in_a.inverse() * wall.position,
                                   Eigen::Rotation2Dd(-b_in_a.heading) * wall.normal);
      exact += 0.2 * std::exp(-0.5 * d * d / 0.25);
    }
  }
  CHECK(found == Approx(exact).epsilon(0.03));
}

TEST_CASE("evidence is the same seen from the other map", "[alignment]") {
  std::mt19937 random(7);
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const MapFeatures a = test::scatteredMap(seed).features;
    const MapFeatures b = test::scatteredMap(seed + 9, 60).features;
    const RigidTransform b_in_a = randomTransform(random);
    const EvidenceOptions options = shallowRooms();
    const Evidence there = gatherEvidence(a, b, b_in_a, kAllPoints, options);
    const Evidence back = gatherEvidence(b, a, b_in_a.inverse(), kAllPoints, options);
    CHECK(there.deep_conflict > 0);
    CHECK(there.free_shallow < there.free_free);
    checkAlike(there, back, 1e-9);
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(b_in_a.heading).toRotationMatrix();
    CHECK((there.facing - turn * back.facing * turn.transpose()).norm() < 1e-9);
  }
}

TEST_CASE("the first points stand for all", "[alignment]") {
  const Map map = test::exploreMap(test::officeFloor(), {2, 1, 0.3}, 0.1);
  const MapFeatures office = extractFeatures(map);
  const RigidTransform off{0.02, {0.3, -0.2}};
  const Evidence all = gatherEvidence(office, office, off);
  const Evidence some = gatherEvidence(office, office, off, 200);
  CHECK(some.agree == Approx(all.agree).epsilon(0.1));
  CHECK(some.known == Approx(all.known).epsilon(0.1));
  CHECK(some.free_free == Approx(all.free_free).epsilon(0.1));
  CHECK(some.free_shallow == Approx(all.free_shallow).epsilon(0.1));
  checkAlike(gatherEvidence(office, office, off, 1000000), all, 0);
  // No points asked: nothing is known, and nothing divided by none.
  const Evidence none = gatherEvidence(office, office, off, 0);
  CHECK(none.known == 0);
  CHECK(none.free_free == 0);
}

TEST_CASE("drift that shifts everything is a shift", "[alignment]") {
  std::mt19937 random(8);
  const MapFeatures a = test::scatteredMap(3).features, b = test::scatteredMap(4).features;
  const RigidTransform b_in_a = randomTransform(random);
  const EvidenceOptions options = shallowRooms();
  const Evidence rigid = gatherEvidence(a, b, b_in_a, kAllPoints, options);
  CHECK(rigid.deep_conflict > 0);
  checkAlike(gatherEvidence(a, b, b_in_a, DriftField(), kAllPoints, options), rigid, 1e-9);
  DriftField drift;
  drift.displacements = {Vector2d(0.7, -0.4)};
  RigidTransform shifted = b_in_a;
  shifted.translation += Vector2d(0.7, -0.4);
  checkAlike(gatherEvidence(a, b, b_in_a, drift, kAllPoints, options),
             gatherEvidence(a, b, shifted, kAllPoints, options), 1e-9);
}

TEST_CASE("a map agrees with itself and conflicts nowhere", "[alignment]") {
  const MapFeatures office =
      extractFeatures(test::exploreMap(test::officeFloor(), {2, 1, 0.3}, 0.1));
  const Evidence itself = gatherEvidence(office, office, {});
  CHECK(itself.agree > 0.95 * 2 * office.wallLength());
  CHECK(itself.conflict < 0.01 * 2 * office.wallLength());
  CHECK(itself.free_free > 0.95 * office.freeArea());
  const Evidence shifted = gatherEvidence(office, office, {0, {1.5, 1.3}});
  CHECK(shifted.agree < 0.5 * itself.agree);
  CHECK(shifted.conflict > 0.05 * shifted.known);
  const Evidence apart = gatherEvidence(office, office, {0, {500, 0}});
  CHECK(apart.known == 0);
  CHECK(apart.agree == 0);
  CHECK(apart.free_free == 0);
}

TEST_CASE("the middle of a hall is not shallow, a corridor is", "[alignment]") {
  const auto alone = [](double width, double height) {
    const MapFeatures map =
        extractFeatures(test::exploreMap(test::roomFloor(width, height), {}, 0.1));
    return gatherEvidence(map, map, {});
  };
  const Evidence hall = alone(20, 20), corridor = alone(20, 3);
  CHECK(hall.free_free == Approx(20 * 20).epsilon(0.05));
  CHECK(hall.free_shallow == Approx(20 * 20 - 16 * 16).epsilon(0.1));
  CHECK(corridor.free_free == Approx(20 * 3).epsilon(0.1));
  CHECK(corridor.free_shallow == corridor.free_free);
}

TEST_CASE("a wall in the middle of a hall lies deep, one beside its wall does not", "[alignment]") {
  const MapFeatures hall = extractFeatures(test::exploreMap(test::roomFloor(20, 20), {}, 0.1));
  const MapFeatures room = extractFeatures(test::exploreMap(test::roomFloor(6, 6), {}, 0.1));
  const Evidence middle = gatherEvidence(hall, room, {0, {7, 7}});
  CHECK(middle.straight.conflict == Approx(4 * 6).epsilon(0.1));
  CHECK(middle.deep_conflict == Approx(middle.straight.conflict));
  CHECK(middle.shallow_conflict == 0);
  // Two sides lie half a metre off the hall's, and two 6.5 m, as far as these are not near the
  // first.
  const Evidence beside = gatherEvidence(hall, room, {0, {0.5, 0.5}});
  CHECK(beside.shallow_conflict > 3);
  CHECK(beside.shallow_conflict < 9);
  CHECK(beside.deep_conflict == Approx(2 * 3.5).margin(1));
}

TEST_CASE("rooms that fit are told from those that do not", "[alignment]") {
  const MapFeatures office =
      extractFeatures(test::exploreMap(test::officeFloor(), {2, 1, 0.3}, 0.1));
  CHECK(gatherEvidence(office, office, {}).rooms.all == 0);
  const RoomCounts itself = gatherEvidence(office, office, {}, DriftField()).rooms;
  CHECK(itself.all > 3);
  CHECK(itself.misfit == 0);
  const RoomCounts shifted = gatherEvidence(office, office, {0, {1.5, 1.3}}, DriftField()).rooms;
  CHECK(shifted.misfit > 0.3 * shifted.all);
  CHECK(gatherEvidence(office, office, {0, {500, 0}}, DriftField()).rooms.all == 0);
}

TEST_CASE("walls conflict more the deeper they stand in free space", "[alignment]") {
  EvidenceOptions options;
  options.conflict_from = 0.2;
  options.conflict_full = 0.6;
  CHECK(conflictWeight(0.1, options) == 0);
  CHECK(conflictWeight(0.3, options) == Approx(0.25));
  CHECK(conflictWeight(0.6, options) == Approx(1));
  CHECK(conflictWeight(5, options) == 1);
  options.deep_from = 2;
  options.deep_full = 3;
  CHECK(deepWeight(0, options) == 0);
  CHECK(deepWeight(2, options) == 0);
  CHECK(deepWeight(2.25, options) == Approx(0.25));
  CHECK(deepWeight(3, options) == 1);
  options.conflict_from = options.conflict_full;
  CHECK(conflictWeight(0.59, options) == 0);
  CHECK(conflictWeight(0, {0.5, 0, 0}) == 0);
  CHECK(conflictWeight(0.01, {0.5, 0, 0}) == 1);
  CHECK(conflictWeight(0.6, options) == 1);
}
