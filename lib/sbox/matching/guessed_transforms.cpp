// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/matching/guessed_transforms.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sbox/core/round.h"
#include "sbox/features/grid_pose.h"

namespace sbox {
namespace {

/// A guess as the transform between grid frames, by where it puts the middle of map b.
struct GuessedMiddle {
  double heading = 0;
  double turn = 0;  ///< How far off the heading may be, radians.
  Eigen::Vector2d middle_b;
  Eigen::Vector2d middle_in_a;
  double distance = 0;  ///< How far off the middle may be, metres.
};

GuessedMiddle guessedMiddle(const MapFeatures& a, const MapFeatures& b, const GuessedPoses& guess,
                            const GuessOptions& options) {
  const Pose2D pose = gridPose(a, guess.pose_a, b, guess.pose_b);
  GuessedMiddle middle;
  middle.heading = wrapAngle(pose.phi);
  middle.turn = options.deviations * std::hypot(guess.sigma_phi_a, guess.sigma_phi_b);
  middle.middle_b = b.middle();
  const Point2D in_a = pose.composePoint({middle.middle_b.x(), middle.middle_b.y()});
  middle.middle_in_a = {in_a.x, in_a.y};
  // A heading that is off moves what lies far from the frame that it turns about.
  const Point2D in_frame_a = a.grid_in_map.composePoint(in_a);
  const Point2D in_frame_b = b.grid_in_map.composePoint({middle.middle_b.x(), middle.middle_b.y()});
  const double spread = std::hypot(guess.sigma_xy, guess.sigma_phi_a * in_frame_a.norm(),
                                   guess.sigma_phi_b * in_frame_b.norm());
  middle.distance = options.deviations * spread;
  return middle;
}

std::vector<double> headingsNear(const MapFeatures& a, const MapFeatures& b,
                                 const GuessedMiddle& guess, const HeadingOptions& options) {
  const double least = options.step * M_PI / 180;
  std::vector<double> near;
  for (const double heading : findHeadings(a, b, options)) {
    if (std::abs(wrapAngle(heading - guess.heading)) <= std::max(guess.turn, least)) {
      near.push_back(heading);
    }
  }
  if (near.empty()) {
    near.push_back(guess.heading);
  }
  return near;
}

}  // namespace

std::vector<Hypothesis> transformsNear(const MapFeatures& a, const MapFeatures& b,
                                       const GuessedPoses& guess, const HeadingOptions& headings,
                                       const GuessOptions& options) {
  const GuessedMiddle middle = guessedMiddle(a, b, guess, options);
  const int most_steps =
      static_cast<int>((std::sqrt(static_cast<double>(std::max(options.most, 1))) - 1) / 2);
  const int steps =
      std::min(ceilToInt(std::min(middle.distance / options.spacing, 1e6)), most_steps);
  const double spacing = steps > 0 ? middle.distance / steps : options.spacing;
  std::vector<Hypothesis> hypotheses;
  for (const double heading : headingsNear(a, b, middle, headings)) {
    const Eigen::Vector2d turned = Eigen::Rotation2Dd(heading) * middle.middle_b;
    for (int row = -steps; row <= steps; ++row) {
      for (int column = -steps; column <= steps; ++column) {
        const Eigen::Vector2d offset(column * spacing, row * spacing);
        hypotheses.push_back({{heading, middle.middle_in_a + offset - turned}, 0});
      }
    }
  }
  return hypotheses;
}

std::vector<Hypothesis> allowedBy(const GuessedPoses& guess, const MapFeatures& a,
                                  const MapFeatures& b, const std::vector<Hypothesis>& hypotheses,
                                  const GuessOptions& options) {
  const GuessedMiddle middle = guessedMiddle(a, b, guess, options);
  std::vector<Hypothesis> allowed;
  std::copy_if(hypotheses.begin(), hypotheses.end(), std::back_inserter(allowed),
               [&](const Hypothesis& hypothesis) {
                 const RigidTransform& b_in_a = hypothesis.b_in_a;
                 const Eigen::Vector2d off = b_in_a * middle.middle_b - middle.middle_in_a;
                 return off.norm() <= middle.distance &&
                        std::abs(wrapAngle(b_in_a.heading - middle.heading)) <= middle.turn;
               });
  return allowed;
}

}  // namespace sbox
