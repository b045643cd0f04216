// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "catch.h"
#include "sbox/paper/vertical_points.h"

using namespace sbox;

namespace {

HoughLine line(double theta, double rho) {
  HoughLine result;
  result.theta = theta;
  result.rho = rho;
  return result;
}

}  // namespace

TEST_CASE("perpendicular lines meet in a vertical point", "[paper]") {
  for (const double turn : {0.0, 0.4, 1.2}) {
    const HoughLine p = line(turn, 3), q = line(turn + M_PI / 2, -2);
    const auto points = findVerticalPoints({p, q});
    REQUIRE(points.size() == 1);
    CHECK(points[0].line1 == 0);
    CHECK(points[0].line2 == 1);
    for (const HoughLine& on : {p, q}) {
      const Point2D& z = points[0].position;
      CHECK(z.x * std::cos(on.theta) + z.y * std::sin(on.theta) == Approx(on.rho).margin(1e-12));
    }
  }
}

TEST_CASE("normals that point the other way make no difference", "[paper]") {
  // theta in [0, pi): 2.8 and 2.8 - pi / 2 are perpendicular either way round.
  CHECK(findVerticalPoints({line(2.8, 1), line(2.8 - M_PI / 2, 1)}).size() == 1);
  CHECK(findVerticalPoints({line(2.8 - M_PI / 2, 1), line(2.8, 1)}).size() == 1);
}

TEST_CASE("the right angle has a tolerance", "[paper]") {
  VerticalPointOptions options;
  options.perpendicular_tolerance = 0.05;
  CHECK(findVerticalPoints({line(0, 1), line(M_PI / 2 + 0.04, 1)}, options).size() == 1);
  CHECK(findVerticalPoints({line(0, 1), line(M_PI / 2 + 0.06, 1)}, options).empty());
  CHECK(findVerticalPoints({line(0, 1), line(0, 2)}, options).empty());
}
