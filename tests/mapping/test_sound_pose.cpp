// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "catch.h"
#include "sbox/mapping/sound_pose.h"

using mrpt::poses::CPose3D;
using sbox::isSound;

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A turned pose with one entry of its matrix changed.
CPose3D withEntry(int row, int column, double value) {
  CPose3D pose(1, 2, 3, 0.4, -0.2, 0.1);
  auto turn = pose.getRotationMatrix();
  turn(row, column) = value;
  pose.setRotationMatrix(turn);
  return pose;
}

}  // namespace

TEST_CASE("a pose is sound if it is finite and turns by a rotation", "[mapping]") {
  CHECK(isSound(CPose3D()));
  CHECK(isSound(CPose3D(-1e4, 2, 3, 3.1, 1.5, -3)));
  CHECK_FALSE(isSound(CPose3D(kNoNumber, 0, 0)));
  CHECK_FALSE(isSound(CPose3D(0, 0, std::numeric_limits<double>::infinity())));
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      for (const double value : {kNoNumber, -1e300, 1.5}) {
        CHECK_FALSE(isSound(withEntry(row, column, value)));
      }
    }
  }
  mrpt::math::CMatrixDouble33 mirror;
  mirror.setIdentity();
  mirror(2, 2) = -1;
  CPose3D mirrored;
  mirrored.setRotationMatrix(mirror);
  CHECK_FALSE(isSound(mirrored));
}
