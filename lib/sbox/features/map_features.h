// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All that is known of one map before it meets another (section 3.1).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sbox/core/feature_set.h"
#include "sbox/core/map.h"
#include "sbox/core/state_grid.h"
#include "sbox/features/axis_lines.h"
#include "sbox/features/free_contours.h"
#include "sbox/features/sharpen_walls.h"
#include "sbox/features/wall_boxes.h"
#include "sbox/features/wall_corners.h"
#include "sbox/features/wall_fields.h"
#include "sbox/features/wall_frames.h"
#include "sbox/features/wall_lines.h"

namespace sbox {

/// Options of the stage, step by step.
struct FeatureOptions {
  StateOptions states;              ///< Free, occupied or unknown.
  double working_resolution = 0.1;  ///< Finer maps are read in cells of this size, metres.
  double free_spacing = 0.4;        ///< Between the free points, metres; wider where a map is ...
  double most_free_points = 2.5e5;  ///< ... so large that it would have more of them.
  ContourOptions contours;          ///< Outlines of free space.
  WallLineOptions walls;            ///< Lines and points on them.
  SharpenOptions sharpen;           ///< Their place in the map's own cells.
  FrameOptions frames;              ///< Directions that many walls share.
  AxisLineOptions axis_lines;       ///< Lines along those.
  CornerOptions corners;            ///< Where two of them meet.
  BoxLimits boxes;                  ///< What four of them enclose.
  FieldOptions fields;              ///< Distances to walls.
};

/// Lines, corners and boxes along one frame's axes.
struct FrameFeatures {
  WallFrame frame;                  ///< Its axes.
  AxisLines lines;                  ///< By the side they face.
  std::vector<WallCorner> corners;  ///< Right angles.
  std::vector<WallBox> boxes;       ///< Suppositional boxes.
};

/// Everything is in the grid frame: origin at the corner of the cropped grid, axes along its rows
/// and columns, metres.
struct MapFeatures {
  FeatureSet feature_set;  ///< For reports and pictures; in the map frame.
  Pose2D grid_in_map;      ///< The grid frame in the map frame.
  double resolution = 0;   ///< Of the map's own cells, metres.
  double width = 0;        ///< Of the known part, metres.
  double height = 0;       ///< Of the known part, metres.
  /// Scattered, so that the first n are spread evenly; no more than the fields can tell apart.
  std::vector<WallPoint> wall_points;
  std::vector<ByteAngle> wall_directions;    ///< Of each wall point's normal.
  double point_spacing = 0;                  ///< Length of wall that each stands for, metres.
  std::vector<Eigen::Vector2d> free_points;  ///< On a square lattice in free space; scattered too.
  double free_point_area = 0;                ///< Area that each stands for, square metres.
  std::vector<FrameFeatures> frames;         ///< The strongest first.
  double slope_spread = 0;   ///< How bent the map is in itself: slopeSpread() of the first frame.
  WallFields fields;         ///< To ask how far a wall is from anywhere.
  std::uint64_t digest = 0;  ///< Of the working cells, for comesFirst().

  /// Whether there is no wall to match.
  [[nodiscard]] bool empty() const { return wall_points.empty(); }
  /// The middle of the known part.
  [[nodiscard]] Eigen::Vector2d middle() const { return {width / 2, height / 2}; }
  /// Of all wall, metres.
  [[nodiscard]] double wallLength() const {
    return point_spacing * static_cast<double>(wall_points.size());
  }
  /// Of all wall for each of the first `count` wall points, which then stand for all, metres.
  [[nodiscard]] double wallLengthPerPoint(size_t count) const {
    return wallLength() / static_cast<double>(std::max<size_t>(count, 1));
  }
  /// Of all free space for each of the first `count` free points, which then stand for all, square
  /// metres.
  [[nodiscard]] double freeAreaPerPoint(size_t count) const {
    return freeArea() / static_cast<double>(std::max<size_t>(count, 1));
  }
  /// Of all free space, square metres.
  [[nodiscard]] double freeArea() const {
    return free_point_area * static_cast<double>(free_points.size());
  }
};

/// An order of maps that does not depend on how they were given; equal maps have none.
[[nodiscard]] bool comesFirst(const MapFeatures& one, const MapFeatures& other);

/// The features of a map's known part, step by step as section 3.1 has them; of a map without a
/// wall that has free space beside it they are empty(). Throws std::length_error where the known
/// part has more cells than can be worked on.
[[nodiscard]] MapFeatures extractFeatures(const Map& map, const FeatureOptions& options = {});

}  // namespace sbox
