// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Image keypoints (OpenCV's ORB or SIFT) of the two maps, matched by descriptor, then a rigid
// RANSAC: the idea of multirobot_map_merge (map_merge.h) without its similarity fit. Occupancy
// images have few corners that look unlike each other, so most matches are wrong.
#pragma once

#include <vector>

#include "sbox-bench/method.h"
#include "sbox-bench/methods/rigid_ransac.h"

namespace sbox::bench {

enum class KeypointKind { Orb, Sift };

struct KeypointOptions {
  KeypointKind kind = KeypointKind::Orb;
  double resolution = 0.1;       ///< Cell size of the image, metres: the same for both maps.
  int keypoints = 5000;          ///< The strongest of each map.
  int neighbours = 1;            ///< Nearest descriptors in b that a keypoint of a is matched with.
  double accept_confidence = 0;  ///< OpenCV's stitching confidence, inliers / (8 + 0.3 matches),
                                 ///< from which the answer is accepted; 0: always.
  RansacOptions ransac;
};

/// Named "orb" or "sift".
[[nodiscard]] Method keypointMethod(const KeypointOptions& options);

/// Matches of the two maps' keypoints that are each other's nearest by descriptor, before any
/// RANSAC.
[[nodiscard]] std::vector<PointMatch> mutualKeypointMatches(const Map& a, const Map& b,
                                                            const KeypointOptions& options);

}  // namespace sbox::bench
