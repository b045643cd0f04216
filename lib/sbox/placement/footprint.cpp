// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/footprint.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/parallel.h"
#include "sbox/core/state_grid.h"

namespace sbox {
namespace {

constexpr int kMostCells = 48;      ///< In a row or column.
constexpr double kLeastCell = 0.5;  ///< Metres.

void markKnown(const StateGrid& grid, int block, Footprint& footprint) {
  std::vector<int> counts(footprint.cells.size(), 0);
  for (int y = 0; y < grid.height; ++y) {
    const CellState* row =
        grid.cells.data() + static_cast<size_t>(y) * static_cast<size_t>(grid.width);
    int* count =
        counts.data() + static_cast<size_t>(y / block) * static_cast<size_t>(footprint.width);
    for (int x = 0; x < grid.width; ++x) {
      count[x / block] += row[x] != CellState::Unknown ? 1 : 0;
    }
  }
  const int half = (block * block + 1) / 2;
  for (size_t i = 0; i < counts.size(); ++i) {
    footprint.cells[i] = counts[i] >= half ? 1 : 0;
  }
}

}  // namespace

Footprint footprintOf(const Map& map) {
  Footprint footprint;
  const StateGrid grid = classifyCells(map);
  if (grid.empty()) {
    return footprint;
  }
  const int longest = std::max(grid.width, grid.height);
  const int block = std::max({1, (longest + kMostCells - 1) / kMostCells,
                              static_cast<int>(std::lround(kLeastCell / grid.resolution))});
  footprint.cell = block * grid.resolution;
  footprint.corner_in_map = grid.corner_in_map;
  footprint.width = (grid.width + block - 1) / block;
  footprint.height = (grid.height + block - 1) / block;
  footprint.cells.resize(static_cast<size_t>(footprint.width) *
                         static_cast<size_t>(footprint.height));
  markKnown(grid, block, footprint);
  Point2D sum(0, 0);
  for (size_t i = 0; i < footprint.cells.size(); ++i) {
    if (footprint.cells[i] != 0) {
      const auto width = static_cast<size_t>(footprint.width);
      const size_t column = i % width, row = i / width;
      const Point2D in_grid((static_cast<double>(column) + 0.5) * footprint.cell,
                            (static_cast<double>(row) + 0.5) * footprint.cell);
      footprint.known.push_back(footprint.corner_in_map.composePoint(in_grid));
      sum += footprint.known.back();
    }
  }
  if (footprint.known.empty()) {
    footprint.centre = footprint.corner_in_map.composePoint(
        Point2D(grid.width * grid.resolution / 2, grid.height * grid.resolution / 2));
    return footprint;
  }
  const auto count = static_cast<double>(footprint.known.size());
  footprint.centre = Point2D(sum.x / count, sum.y / count);
  double squares = 0;
  for (const Point2D& point : footprint.known) {
    squares += (point - footprint.centre).sqrNorm();
  }
  footprint.radius = std::sqrt(squares / count);
  return footprint;
}

std::vector<Footprint> footprintsOf(const std::vector<Map>& maps, int threads) {
  std::vector<Footprint> footprints(maps.size());
  parallelFor(static_cast<int>(maps.size()), threads, [&](int i) {
    footprints[static_cast<size_t>(i)] = footprintOf(maps[static_cast<size_t>(i)]);
  });
  return footprints;
}

std::vector<Point2D> commonPoints(const Footprint& a, const Footprint& b,
                                  const Pose2D& pose_b_in_a) {
  std::vector<Point2D> common;
  const Pose2D a_in_grid = inverse(a.corner_in_map);
  const Pose2D b_in_grid = a_in_grid + pose_b_in_a;
  const double c = std::cos(b_in_grid.phi), s = std::sin(b_in_grid.phi);
  for (const Point2D& point : b.known) {
    const double x = (b_in_grid.x + c * point.x - s * point.y) / a.cell;
    const double y = (b_in_grid.y + s * point.x + c * point.y) / a.cell;
    if (x >= 0 && y >= 0 && x < a.width && y < a.height &&
        a.cells[static_cast<size_t>(y) * static_cast<size_t>(a.width) + static_cast<size_t>(x)] !=
            0) {
      common.push_back(pose_b_in_a.composePoint(point));
    }
  }
  return common;
}

double overlapShare(const Footprint& a, const Footprint& b, const Pose2D& pose_b_in_a) {
  if (a.known.empty() || b.known.empty()) {
    return 0;
  }
  // From both sides, so that the order of the maps does not matter.
  const double common =
      (static_cast<double>(commonPoints(a, b, pose_b_in_a).size()) * b.cell * b.cell +
       static_cast<double>(commonPoints(b, a, inverse(pose_b_in_a)).size()) * a.cell * a.cell) /
      2;
  const double area_a = static_cast<double>(a.known.size()) * a.cell * a.cell;
  const double area_b = static_cast<double>(b.known.size()) * b.cell * b.cell;
  return std::min(1.0, common / std::min(area_a, area_b));
}

PoseGap gapBetween(const Footprint& a, const Footprint& b, const Pose2D& pose_b_in_a,
                   const Pose2D& other_b_in_a) {
  const auto apart = [](const Pose2D& left, const Pose2D& right, const Point2D& middle) {
    return (left.composePoint(middle) - right.composePoint(middle)).norm();
  };
  PoseGap gap;
  gap.distance = (apart(pose_b_in_a, other_b_in_a, b.centre) +
                  apart(inverse(pose_b_in_a), inverse(other_b_in_a), a.centre)) /
                 2;
  gap.turn = std::abs(wrapAngle(pose_b_in_a.phi - other_b_in_a.phi));
  return gap;
}

}  // namespace sbox
