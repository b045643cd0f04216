// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <cmath>

#include "catch.h"
#include "drawing.h"
#include "sbox/core/rigid_fit.h"
#include "sbox/paper/kalman_step.h"

using namespace sbox;

namespace {

/// Box b is 0.4 m longer along its first side and 0.2 m shorter along its second than box a, and
/// one corner is off; it stands at `angle` to the axes of map b.
MatchedBoxes unequalBoxes(double angle) {
  MatchedBoxes boxes;
  boxes.corners_a = {{{0, 0}, {6, 0}, {6, 4}, {0, 4}}};
  boxes.corners_b = {{{0, 0}, {6.4, 0}, {6.4, 3.8}, {0, 3.8}}};
  const Transform turn(Pose2D(10, 5, angle));
  for (Point2D& corner : boxes.corners_b) {
    corner = turn(corner);
  }
  return boxes;
}

Pose2D fitOfThree(const MatchedBoxes& boxes, size_t first) {
  std::vector<Point2D> from, to;
  for (size_t k = 0; k < 3; ++k) {
    from.push_back(boxes.corners_a[(first + k) % 4]);
    to.push_back(boxes.corners_b[(first + k) % 4]);
  }
  return fitRigid(from, to);
}

double smallestEigenvalue(const PoseCovariance& covariance) {
  return Eigen::SelfAdjointEigenSolver<PoseCovariance>(covariance).eigenvalues()[0];
}

}  // namespace

TEST_CASE("the step is what eqs. 6 to 14 say, cell by cell", "[paper]") {
  for (const double angle : {0.0, 0.6, -2.0}) {
    const MatchedBoxes boxes = unequalBoxes(angle);
    const Pose2D t = fitOfThree(boxes, 0);
    const KalmanStep step(boxes, t);
    for (const Point2D& x : {Point2D(1, 2), Point2D(-20, 7), Point2D(3, 2)}) {
      const KalmanEstimate e = step.at(x);

      // Eq. 6.
      const Point2D prediction = t.composePoint(x);
      CHECK(e.prediction.x() == Approx(prediction.x));
      CHECK(e.prediction.y() == Approx(prediction.y));

      // Eqs. 7 and 8, the variance as the mean of squares.
      double mean_x = 0, mean_y = 0, var_x = 0, var_y = 0;
      for (size_t j = 0; j < 4; ++j) {
        const Point2D p = fitOfThree(boxes, j).composePoint(x);
        mean_x += p.x / 4;
        mean_y += p.y / 4;
      }
      for (size_t j = 0; j < 4; ++j) {
        const Point2D p = fitOfThree(boxes, j).composePoint(x);
        var_x += (p.x - mean_x) * (p.x - mean_x) / 4;
        var_y += (p.y - mean_y) * (p.y - mean_y) / 4;
      }
      const Eigen::Matrix2d p = Eigen::Vector2d(var_x, var_y).asDiagonal();
      CHECK((e.prediction_covariance - p).norm() < 1e-9);

      // Eqs. 9 to 11, both lines.
      const Point2D centre_a(3, 2), centre_b = Pose2D(10, 5, angle).composePoint({3.2, 1.9});
      const Point2D moved_centre = t.composePoint(centre_a);
      CHECK(e.observation.x() == Approx(centre_b.x + prediction.x - moved_centre.x));
      CHECK(e.observation.y() == Approx(centre_b.y + prediction.y - moved_centre.y));

      // Eq. 12: 0.5 x 0.4 m and 0.5 x 0.2 m along the box, squared, turned into map axes.
      Eigen::Matrix2d axes;
      axes << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
      const Eigen::Matrix2d r =
          axes * Eigen::Vector2d(0.2 * 0.2, 0.1 * 0.1).asDiagonal() * axes.transpose();
      CHECK((e.observation_covariance - r).norm() < 1e-9);

      // Eqs. 13 and 14.
      const Eigen::Matrix2d k = r * (r + p).inverse();
      CHECK((e.gain - k).norm() < 1e-9);
      const Eigen::Vector2d estimate =
          k * e.prediction + (Eigen::Matrix2d::Identity() - k) * e.observation;
      CHECK((e.estimate - estimate).norm() < 1e-9);

      // The usual form with the gain G = P (P + R)^-1 says the same.
      const Eigen::Matrix2d g = p * (p + r).inverse();
      CHECK((e.estimate - (e.prediction + g * (e.observation - e.prediction))).norm() < 1e-9);
      CHECK((e.covariance - (Eigen::Matrix2d::Identity() - g) * p).norm() < 1e-9);
    }
  }
}

TEST_CASE("equal boxes leave the transform alone, with a covariance above zero", "[paper]") {
  MatchedBoxes boxes = unequalBoxes(0);
  const Pose2D t(3, -7, 0.4);
  for (size_t i = 0; i < 4; ++i) {
    boxes.corners_b[i] = t.composePoint(boxes.corners_a[i]);
  }
  const StateGrid grid = test::freeGrid(120, 80, 0.05);
  const KalmanResult result = refineByKalman(grid, grid, boxes, t);
  // Rounding to cells averages out over the map.
  CHECK(result.pose_a_in_b.x == Approx(t.x).margin(0.005));
  CHECK(result.pose_a_in_b.y == Approx(t.y).margin(0.005));
  CHECK(result.pose_a_in_b.phi == Approx(t.phi).margin(0.001));
  CHECK(smallestEigenvalue(result.covariance) > 0);
}

TEST_CASE("the sum is the rigid transform nearest to the rounded field", "[paper]") {
  const MatchedBoxes boxes = unequalBoxes(0.6);
  const Pose2D t = fitOfThree(boxes, 0);
  StateGrid grid = test::freeGrid(40, 30, 0.2);
  grid.cells[5] = CellState::Unknown;
  const KalmanStep step(boxes, t);
  std::vector<Point2D> from, to;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (grid.at(x, y) == CellState::Unknown) {
        continue;
      }
      const Point2D p((x + 0.5) * 0.2, (y + 0.5) * 0.2);
      const Eigen::Vector2d e = step.at(p).estimate;
      from.push_back(p);
      to.emplace_back((std::floor(e.x() / 0.2) + 0.5) * 0.2, (std::floor(e.y() / 0.2) + 0.5) * 0.2);
    }
  }
  const Pose2D expected = fitRigid(from, to);
  const KalmanResult result = refineByKalman(grid, grid, boxes, t);
  CHECK(result.pose_a_in_b.x == Approx(expected.x));
  CHECK(result.pose_a_in_b.y == Approx(expected.y));
  CHECK(result.pose_a_in_b.phi == Approx(expected.phi));
  CHECK(smallestEigenvalue(result.covariance) > 0);
}

TEST_CASE("the covariance grows away from the box", "[paper]") {
  // The same boxes seen from frames whose origin lies at the box and 100 m off.
  const StateGrid grid = test::freeGrid(40, 30, 0.2);
  MatchedBoxes near = unequalBoxes(0.1), far = near;
  for (Point2D& corner : far.corners_a) {
    corner = corner + Point2D(100, 0);
  }
  const auto spread = [&](const MatchedBoxes& boxes) {
    return refineByKalman(grid, grid, boxes, fitOfThree(boxes, 0))
        .covariance.topLeftCorner<2, 2>()
        .trace();
  };
  CHECK(spread(far) > 10 * spread(near));
}

TEST_CASE("the shift brings corners into correspondence", "[paper]") {
  const SuppositionalBox box = describeBox({{{0, 0}, {6, 0}, {6, 4}, {0, 4}}});
  const MatchedBoxes boxes = matchedBoxes(box, box, 3);
  CHECK(boxes.corners_b[0].y == 4);
  CHECK(boxes.corners_b[1].y == 0);
  CHECK(boxes.corners_b[1].x == 0);
}
