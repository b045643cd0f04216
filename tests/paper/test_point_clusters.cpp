// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "catch.h"
#include "sbox/paper/point_clusters.h"

using namespace sbox;

namespace {

std::vector<VerticalPoint> pointsAt(const std::vector<Point2D>& positions) {
  std::vector<VerticalPoint> points;
  for (const Point2D& p : positions) {
    points.push_back({p, 0, 1});
  }
  return points;
}

}  // namespace

TEST_CASE("Newton's method on eq. 2 lands on the mean", "[paper]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> spread(-50, 50);
  for (int n = 1; n < 20; ++n) {
    std::vector<Point2D> points;
    Point2D mean(0, 0);
    for (int i = 0; i < n; ++i) {
      points.emplace_back(spread(random), spread(random));
      mean = mean + points.back() * (1.0 / n);
    }
    const Point2D best = leastSquaresPoint(points);
    CHECK(best.x == Approx(mean.x).margin(1e-8));
    CHECK(best.y == Approx(mean.y).margin(1e-8));
  }
}

TEST_CASE("eq. 2 has no answer without points", "[paper]") {
  CHECK_THROWS_AS(leastSquaresPoint({}), std::invalid_argument);
  CHECK_THROWS_AS(leastSquaresPoint({{1, 1}}, 0), std::invalid_argument);
}

TEST_CASE("a cloud becomes its mean, and clouds stay apart", "[paper]") {
  ClusterOptions options;
  options.radius = 0.5;
  const auto clusters =
      clusterPoints(pointsAt({{1, 1}, {9, 1}, {1.2, 1}, {1, 1.3}, {9, 1.4}}), options);
  REQUIRE(clusters.size() == 2);
  CHECK(clusters[0].members == std::vector<int>{0, 2, 3});
  CHECK(clusters[0].position.x == Approx(3.2 / 3));
  CHECK(clusters[0].position.y == Approx(3.3 / 3));
  CHECK(clusters[1].members == std::vector<int>{1, 4});
}

TEST_CASE("a chain of points does not become one cluster", "[paper]") {
  ClusterOptions options;
  options.radius = 0.5;
  const auto clusters =
      clusterPoints(pointsAt({{0, 0}, {0.4, 0}, {0.8, 0}, {1.2, 0}, {1.6, 0}}), options);
  CHECK(clusters.size() == 3);
}
