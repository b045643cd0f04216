// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/candidate_transforms.h"

#include <vector>

#include "sbox/core/rigid_fit.h"

namespace sbox {

std::array<Pose2D, 4> candidateTransforms(const SuppositionalBox& box_a,
                                          const SuppositionalBox& box_b) {
  const std::vector<Point2D> from(box_a.corners.begin(), box_a.corners.begin() + 3);
  std::array<Pose2D, 4> transforms;
  for (size_t k = 0; k < 4; ++k) {
    transforms[k] =
        fitRigid(from, {box_b.corners[k], box_b.corners[(k + 1) % 4], box_b.corners[(k + 2) % 4]});
  }
  return transforms;
}

}  // namespace sbox
