// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "drawing.h"
#include "sbox/alignment/drift_field.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

DriftField fieldOf(int columns, int rows, double spacing, const Vector2d& origin,
                   const std::vector<Vector2d>& displacements) {
  DriftField field;
  field.columns = columns;
  field.rows = rows;
  field.spacing = spacing;
  field.origin = origin;
  field.displacements = displacements;
  return field;
}

/// The displacement as a sum over all nodes, each with the share of a tent about it.
Vector2d byTents(const DriftField& field, const Vector2d& point) {
  const auto clamped = [](double place, int count) {
    return std::min(std::max(place, 0.0), count - 1.0);
  };
  const double x = clamped((point.x() - field.origin.x()) / field.spacing, field.columns);
  const double y = clamped((point.y() - field.origin.y()) / field.spacing, field.rows);
  Vector2d sum = Vector2d::Zero();
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      sum += std::max(0.0, 1 - std::abs(x - column)) * std::max(0.0, 1 - std::abs(y - row)) *
             field.displacements[static_cast<size_t>(row * field.columns + column)];
    }
  }
  return sum;
}

/// The floor bent: shifted along y by an arc over its length.
test::Floor bent(test::Floor floor, double by) {
  // In short pieces, as a wall that is bent is not straight.
  std::vector<test::Wall> pieces;
  const auto moved = [&](const Point2D& p) {
    return Point2D(p.x, p.y + by * std::sin(M_PI * p.x / 24));
  };
  for (const test::Wall& wall : floor.walls) {
    for (int i = 0; i < 24; ++i) {
      const Point2D way = wall.to - wall.from;
      pieces.push_back(
          {moved(wall.from + way * (i / 24.0)), moved(wall.from + way * ((i + 1) / 24.0))});
    }
  }
  floor.walls = pieces;
  for (Point2D& place : floor.places) {
    place = moved(place);
  }
  return floor;
}

MapFeatures seen(const test::Floor& floor) {
  return extractFeatures(test::exploreMap(floor, {}, 0.1));
}

/// What lays grid b on grid a where both robots share the world's frame.
RigidTransform gridInGrid(const MapFeatures& a, const MapFeatures& b) {
  const Pose2D pose = inverse(a.grid_in_map) + b.grid_in_map;
  return {pose.phi, {pose.x, pose.y}};
}

}  // namespace

TEST_CASE("a field is bilinear between its nodes and constant beyond", "[alignment]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1), x(-10, 40), y(-10, 30);
  for (const auto& [columns, rows] :
       {std::pair(4, 3), std::pair(1, 5), std::pair(3, 1), std::pair(1, 1)}) {
    std::vector<Vector2d> displacements;
    for (int i = 0; i < columns * rows; ++i) {
      displacements.emplace_back(number(random), number(random));
    }
    const DriftField field = fieldOf(columns, rows, 7, {1, 2}, displacements);
    for (int i = 0; i < 200; ++i) {
      const Vector2d p(x(random), y(random));
      CHECK((field.at(p) - byTents(field, p)).norm() < 1e-12);
    }
    CHECK((field.at({1, 2}) - displacements.front()).norm() < 1e-12);
    CHECK((field.at({1e6, 1e6}) - displacements.back()).norm() < 1e-12);
  }
  CHECK(DriftField().at({3, 4}) == Vector2d::Zero());
}

TEST_CASE("roughness is the change from node to node", "[alignment]") {
  CHECK(DriftField().roughness() == 0);
  CHECK(fieldOf(2, 2, 5, {0, 0}, {{1, 2}, {1, 2}, {1, 2}, {1, 2}}).roughness() == 0);
  CHECK(fieldOf(2, 1, 5, {0, 0}, {{0, 0}, {3, 4}}).roughness() == Approx(5));
  CHECK(fieldOf(1, 2, 5, {0, 0}, {{0, 0}, {3, 4}}).roughness() == Approx(5));
  // Two of the four edges change by 1.
  CHECK(fieldOf(2, 2, 5, {0, 0}, {{0, 0}, {1, 0}, {0, 0}, {1, 0}}).roughness() ==
        Approx(std::sqrt(0.5)));
}

TEST_CASE("a map is not bent against itself", "[alignment]") {
  const MapFeatures office = seen(test::officeFloor());
  const DriftField drift = estimateDrift(office, office, {});
  for (const Vector2d& displacement : drift.displacements) {
    CHECK(displacement.norm() < 0.02);
  }
}

TEST_CASE("an arc is found, and laid the right way round", "[alignment]") {
  const MapFeatures straight = seen(test::officeFloor());
  const MapFeatures arc = seen(bent(test::officeFloor(), 0.5));
  // Where the middle of the bent floor lies 0.5 m too far up, in b it has to go down.
  for (const bool is_b_bent : {true, false}) {
    const MapFeatures &a = is_b_bent ? straight : arc, &b = is_b_bent ? arc : straight;
    const DriftField drift = estimateDrift(a, b, gridInGrid(a, b));
    const auto displacementAt = [&](double x, double y) -> Vector2d {
      return drift.at(Vector2d(x - a.grid_in_map.x, y - a.grid_in_map.y));
    };
    const double sign = is_b_bent ? -1 : 1;
    INFO("b is bent: " << is_b_bent);
    for (const double y : {1.0, 6.0, 13.0}) {
      CHECK(displacementAt(12, y).y() == Approx(0.5 * sign).margin(0.15));
      CHECK(displacementAt(0.5, y).y() == Approx(0).margin(0.2));
      CHECK(displacementAt(23.5, y).y() == Approx(0).margin(0.2));
      CHECK(displacementAt(12, y).x() == Approx(0).margin(0.15));
    }
  }
}

TEST_CASE("maps that do not meet have no drift", "[alignment]") {
  const MapFeatures office = seen(test::officeFloor());
  const DriftField drift = estimateDrift(office, office, {0.3, {1000, 500}});
  for (const Vector2d& displacement : drift.displacements) {
    CHECK(displacement.norm() == 0);
  }
}
