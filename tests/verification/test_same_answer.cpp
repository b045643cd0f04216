// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "catch.h"
#include "sbox/verification/same_answer.h"

using namespace sbox;

namespace {

/// Wall points on a square of ten metres, in a map of that size.
MapFeatures square() {
  MapFeatures map;
  map.width = map.height = 10;
  for (int i = 0; i <= 10; ++i) {
    for (const Eigen::Vector2d& place : {Eigen::Vector2d(i, 0), Eigen::Vector2d(i, 10),
                                         Eigen::Vector2d(0, i), Eigen::Vector2d(10, i)}) {
      map.wall_points.push_back({place, {1, 0}, 0});
    }
  }
  return map;
}

Fit shifted(double x, double probability) {
  Fit fit;
  fit.b_in_a.translation = {x, 0};
  fit.probability = probability;
  return fit;
}

/// A drift field over the square that moves its right edge by this.
DriftField stretched(double metres) {
  DriftField field;
  field.origin = {0, 0};
  field.spacing = 10;
  field.columns = 2;
  field.displacements = {{0, 0}, {metres, 0}};
  return field;
}

}  // namespace

TEST_CASE("fits that lay the walls on the same places are one answer", "[same_answer]") {
  const MapFeatures map = square();
  std::vector<Fit> fits = {shifted(0, 0.4), shifted(3, 0.3), shifted(0.5, 0.2)};
  mergeAnswers(map, map, fits);
  REQUIRE(fits.size() == 2);
  // Of one answer the first fit stays.
  CHECK(fits[0].b_in_a.translation.x() == 0);
  CHECK(fits[1].b_in_a.translation.x() == 3);
}

TEST_CASE("the more the maps are bent, the further apart are fits of one answer", "[same_answer]") {
  const MapFeatures map = square();
  std::vector<Fit> fits = {shifted(0, 0.5), shifted(1, 0.3)};
  SECTION("straight") {
    mergeAnswers(map, map, fits);
    CHECK(fits.size() == 2);
  }
  SECTION("bent") {
    fits[0].drift = fits[1].drift = stretched(0.3);
    mergeAnswers(map, map, fits);
    REQUIRE(fits.size() == 1);
    CHECK(fits[0].probability == 0.5);
  }
  SECTION("one of them bent") {
    const size_t which = GENERATE(0U, 1U);
    fits[which].drift = stretched(0.3);
    mergeAnswers(map, map, fits);
    CHECK(fits.size() == 1);
  }
}

TEST_CASE("the distance of fits is that of the walls once bent", "[same_answer]") {
  MapFeatures map = square();
  Fit bent = shifted(0, 0.5);
  bent.drift = stretched(1);
  const Fit straight = shifted(1, 0.5);
  map.wall_points = {{{10, 5}, {1, 0}, 0}};
  CHECK(distanceWhenBent(map, map, bent, straight) == Approx(0).margin(1e-12));
  map.wall_points = {{{5, 5}, {1, 0}, 0}};
  CHECK(distanceWhenBent(map, map, bent, straight) == Approx(0.5));
  // Nothing of b lies on a.
  CHECK(distanceWhenBent(map, map, shifted(50, 1), straight) ==
        std::numeric_limits<double>::infinity());
}
