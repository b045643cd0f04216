// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "drawing.h"
#include "sbox/alignment/wall_alignment.h"
#include "scattered_map.h"

using namespace sbox;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Vector2d middleOf(const MapFeatures& map) { return {map.width / 2, map.height / 2}; }

/// b_in_a after the middle of b was moved and turned.
RigidTransform moved(const RigidTransform& b_in_a, const MapFeatures& b, const Vector3d& by) {
  const double heading = b_in_a.heading + by.z();
  const Vector2d place = b_in_a * middleOf(b) + by.head<2>();
  return {heading, place - Eigen::Rotation2Dd(heading) * middleOf(b)};
}

/// The nearest wall point of `map` to the middle of the fields' cell that holds `p`, of those that
/// face alike; none within reach: null.
const WallPoint* nearestOf(const MapFeatures& map, const Vector2d& p, const Vector2d& normal) {
  const WallFields& fields = map.fields;
  const Vector2d place = (p - fields.origin) / fields.resolution;
  if (place.minCoeff() < 0 || place.x() >= fields.width || place.y() >= fields.height) {
    return nullptr;
  }
  const Vector2d middle =
      fields.origin +
      Vector2d(std::floor(place.x()) + 0.5, std::floor(place.y()) + 0.5) * fields.resolution;
  const WallPoint* nearest = nullptr;
  double least = 2;  // Metres: the fields' reach.
  for (const WallPoint& point : map.wall_points) {
    const double distance = (point.position - middle).norm();
    if (test::facesAlike(point.normal, normal) && distance < least) {
      least = distance;
      nearest = &point;
    }
  }
  return nearest;
}

/// Sum of J^T J over the walls, each differentiated by moving the map.
Matrix3d informationByDifferences(const MapFeatures& a, const MapFeatures& b,
                                  const RigidTransform& b_in_a, const AlignmentOptions& options) {
  Matrix3d sum = Matrix3d::Zero();
  const double squared_kernel = options.kernel * options.kernel;
  const auto add = [&](double length, const Vector2d& offset, const auto& residualOf) {
    constexpr double step = 1e-6;
    Vector3d jacobian;
    for (int k = 0; k < 3; ++k) {
      const Vector3d by = step * Vector3d::Unit(k);
      jacobian[k] =
          (residualOf(moved(b_in_a, b, by)) - residualOf(moved(b_in_a, b, -by))) / (2 * step);
    }
    const double scale = squared_kernel / (squared_kernel + offset.squaredNorm());
    sum += length * scale * scale * jacobian * jacobian.transpose();
  };
  const RigidTransform a_in_b = b_in_a.inverse();
  for (const WallPoint& point : b.wall_points) {
    const Vector2d p = b_in_a * point.position;
    const Vector2d normal = Eigen::Rotation2Dd(b_in_a.heading) * point.normal;
    if (const WallPoint* target = nearestOf(a, p, normal)) {
      add(b.point_spacing / 2, target->position - p, [&](const RigidTransform& transform) {
        return target->normal.dot(transform * point.position);
      });
    }
  }
  for (const WallPoint& point : a.wall_points) {
    const Vector2d p = a_in_b * point.position;
    const Vector2d normal = Eigen::Rotation2Dd(a_in_b.heading) * point.normal;
    if (const WallPoint* source = nearestOf(b, p, normal)) {
      const Vector2d turned = Eigen::Rotation2Dd(b_in_a.heading) * source->normal;
      add(a.point_spacing / 2, b_in_a * source->position - point.position,
          [&](const RigidTransform& transform) {
            return turned.dot(transform * source->position);
          });
    }
  }
  return sum;
}

/// A floor mapped by two robots, and how the one grid lies in the other.
struct Pair {
  MapFeatures a, b;
  RigidTransform b_in_a;
};

Pair seenTwice(unsigned seed, const Pose2D& b_in_world) {
  const test::Floor floor = test::randomFloor(seed);
  Pair pair;
  pair.a = extractFeatures(test::exploreMap(floor, {}, 0.1, {{-1, -1}, {16, 20}}));
  pair.b = extractFeatures(test::exploreMap(floor, b_in_world, 0.1, {{4, -1}, {40, 20}}));
  const Pose2D truth = inverse(pair.a.grid_in_map) + b_in_world + pair.b.grid_in_map;
  pair.b_in_a = {truth.phi, {truth.x, truth.y}};
  return pair;
}

double errorOf(const Pair& pair, const RigidTransform& found) {
  double error = 0;
  for (const Vector2d& p : {Vector2d(0, 0), Vector2d(pair.b.width, 0), Vector2d(0, pair.b.height),
                            Vector2d(pair.b.width, pair.b.height)}) {
    error = std::max(error, (found * p - pair.b_in_a * p).norm());
  }
  return error;
}

}  // namespace

TEST_CASE("walls near the truth are laid on each other", "[alignment]") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> shift(-0.6, 0.6), turn(-0.05, 0.05);
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Pair pair = seenTwice(seed, {2, 1, 0.7 * seed});
    for (int i = 0; i < 5; ++i) {
      const RigidTransform start =
          moved(pair.b_in_a, pair.b, {shift(random), shift(random), turn(random)});
      const RigidTransform found = alignWalls(pair.a, pair.b, start);
      INFO("seed " << seed << " start off by " << errorOf(pair, start));
      CHECK(errorOf(pair, found) < 0.15);
      // A narrower kernel goes on from there.
      AlignmentOptions tight;
      tight.kernel = 0.3;
      CHECK(errorOf(pair, alignWalls(pair.a, pair.b, found, tight)) < 0.1);
    }
  }
}

TEST_CASE("aligning a to b is the inverse of aligning b to a", "[alignment]") {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Pair pair = seenTwice(seed, {2, 1, 2.0});
    const RigidTransform start = moved(pair.b_in_a, pair.b, {0.3, -0.2, 0.02});
    AlignmentOptions options;
    options.most_points = 1000000;
    const RigidTransform there = alignWalls(pair.a, pair.b, start, options);
    const RigidTransform back = alignWalls(pair.b, pair.a, start.inverse(), options).inverse();
    CHECK((there * middleOf(pair.b) - back * middleOf(pair.b)).norm() < 0.02);
    CHECK(std::abs(there.heading - back.heading) < 0.002);
  }
}

TEST_CASE("what is aligned stays, and what does not meet stays where it was", "[alignment]") {
  const MapFeatures office = extractFeatures(test::exploreMap(test::officeFloor(), {}, 0.1));
  const RigidTransform itself = alignWalls(office, office, {});
  CHECK(itself.translation.norm() < 1e-3);
  CHECK(std::abs(itself.heading) < 1e-4);
  const RigidTransform apart{0.4, {1000, 0}};
  const RigidTransform left = alignWalls(office, office, apart);
  CHECK((left.translation - apart.translation).norm() < 1e-9);
  CHECK(left.heading == Approx(0.4));
}

TEST_CASE("two parallel walls are moved across, not along", "[alignment]") {
  MapFeatures map;
  map.width = 24;
  map.height = 2.5;
  map.point_spacing = 0.2;
  for (int i = 0; i < 120; ++i) {
    map.wall_points.push_back({{0.2 * i + 0.1, 0}, {0, 1}});
    map.wall_points.push_back({{0.2 * i + 0.1, 2.5}, {0, -1}});
    map.wall_directions.insert(map.wall_directions.end(), {ByteAngle{64}, ByteAngle{192}});
  }
  map.fields = makeFields(test::freeGrid(240, 25, 0.1), map.wall_points);
  const RigidTransform found = alignWalls(map, map, {0, {0.8, 0.4}});
  CHECK(found.translation.x() == Approx(0.8).margin(1e-3));
  CHECK(found.translation.y() == Approx(0).margin(1e-3));
  CHECK(std::abs(found.heading) < 1e-4);
}

TEST_CASE("the information is that of each wall, differentiated by moving the map", "[alignment]") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shift(-2, 2), degrees(-4, 4);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const MapFeatures a = test::scatteredMap(seed, 100).features;
    const MapFeatures b = test::scatteredMap(seed + 20, 70).features;
    const double heading = static_cast<int>(seed) * M_PI / 4 + degrees(random) * M_PI / 180;
    const RigidTransform b_in_a{heading, middleOf(a) + Vector2d(shift(random), shift(random)) -
                                             Eigen::Rotation2Dd(heading) * middleOf(b)};
    const AlignmentOptions options;
    const Matrix3d found = wallInformation(a, b, b_in_a, options);
    const Matrix3d expected = informationByDifferences(a, b, b_in_a, options);
    INFO("seed " << seed << "\n" << found << "\n" << expected);
    CHECK(expected(0, 0) > 1);
    CHECK((found - expected).norm() < 1e-4 * expected.norm());
  }
}
