// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/refinement/mean_transform.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

MapFeatures office() { return extractFeatures(test::drawMap(test::officeWalls(), {}, 0.05)); }

/// A lattice over the office; `displacement` tells that of each node.
template <typename Displacement>
DriftField lattice(const Displacement& displacement) {
  DriftField drift;
  drift.spacing = 8;
  drift.columns = 5;
  drift.rows = 4;
  drift.displacements.clear();
  for (int row = 0; row < drift.rows; ++row) {
    for (int column = 0; column < drift.columns; ++column) {
      drift.displacements.push_back(displacement(Vector2d(8.0 * column, 8.0 * row)));
    }
  }
  return drift;
}

}  // namespace

TEST_CASE("without drift the transform stays", "[refinement]") {
  const MapFeatures map = office();
  const RigidTransform mean = meanTransform(
      map, map, {0, {0.02, -0.03}}, lattice([](const Vector2d&) { return Vector2d(0, 0); }));
  CHECK(mean.heading == Approx(0).margin(1e-9));
  CHECK(mean.translation.x() == Approx(0.02));
  CHECK(mean.translation.y() == Approx(-0.03));
}

TEST_CASE("a drift that is a rigid motion goes into the transform", "[refinement]") {
  const MapFeatures map = office();
  // What the transform lacks to the identity, to first order.
  const RigidTransform wrong{0.01, {0.1, -0.15}};
  const RigidTransform lacking = wrong.inverse();
  const RigidTransform mean = meanTransform(
      map, map, wrong, lattice([&](const Vector2d& p) { return Vector2d(lacking * p - p); }));
  CHECK(std::abs(mean.heading) < 1e-4);
  CHECK(mean.translation.norm() < 2e-3);
}

TEST_CASE("of a drift that bends both ways the mean is taken", "[refinement]") {
  const MapFeatures map = office();
  const RigidTransform start{0, {0, 0}};
  const RigidTransform mean = meanTransform(map, map, start, lattice([](const Vector2d& p) {
                                              return Vector2d(0, p.x() < 13 ? 0.1 : -0.1);
                                            }));
  const Vector2d centre(map.width / 2, map.height / 2);
  CHECK(std::abs((mean * centre - centre).y()) < 0.05);
}

TEST_CASE("maps that share no wall keep the transform", "[refinement]") {
  const MapFeatures map = office();
  const RigidTransform far{0.5, {500, 0}};
  const RigidTransform mean = meanTransform(map, map, far, DriftField());
  CHECK(mean.heading == far.heading);
  CHECK(mean.translation == far.translation);
}
