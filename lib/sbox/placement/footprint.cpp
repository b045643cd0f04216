// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/footprint.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sbox/core/known_part.h"
#include "sbox/core/parallel.h"

namespace sbox {
namespace {

constexpr int kMostCells = 48;      ///< In a row or column.
constexpr double kLeastCell = 0.5;  ///< Metres.

/// Marks the coarse cells at least half of whose cells are known.
void markKnown(const Map& map, const StateLimits& limits, const KnownPart& part, int block,
               Footprint& footprint) {
  const int half = (block * block + 1) / 2;
  std::vector<int> known_in_column(static_cast<size_t>(part.width));
  std::uint8_t* marked = footprint.cells.data();
  for (int y = 0; y < part.height; y += block) {
    std::fill(known_in_column.begin(), known_in_column.end(), 0);
    for (int i = y; i < std::min(y + block, part.height); ++i) {
      const auto* row = map.grid.getRow(part.y_first + i) + part.x_first;
      for (size_t x = 0; x < known_in_column.size(); ++x) {
        known_in_column[x] += limits.knows(row[x]) ? 1 : 0;
      }
    }
    for (int x = 0; x < part.width; x += block) {
      const auto column = known_in_column.begin() + x;
      const int known = std::accumulate(column, column + std::min(block, part.width - x), 0);
      *marked++ = known >= half ? 1 : 0;
    }
  }
}

/// Calls take(point) for each known point of map b, in its frame, that map a knows too.
template <typename Take>
void forEachCommon(const Footprint& a, const Footprint& b, const Pose2D& pose_b_in_a,
                   const Take& take) {
  const Pose2D b_in_grid = inverse(a.corner_in_map) + pose_b_in_a;
  const double c = std::cos(b_in_grid.phi), s = std::sin(b_in_grid.phi);
  for (const Point2D& point : b.known) {
    const double x = (b_in_grid.x + c * point.x - s * point.y) / a.cell;
    const double y = (b_in_grid.y + s * point.x + c * point.y) / a.cell;
    if (x >= 0 && y >= 0 && x < a.width && y < a.height &&
        a.cells[static_cast<size_t>(y) * static_cast<size_t>(a.width) + static_cast<size_t>(x)] !=
            0) {
      take(point);
    }
  }
}

}  // namespace

Footprint footprintOf(const Map& map, const StateOptions& states) {
  Footprint footprint;
  const StateLimits limits = stateLimits(states);
  const KnownPart part = knownPart(map, limits);
  if (part.width == 0) {
    return footprint;
  }
  const double resolution = map.resolution();
  const int longest = std::max(part.width, part.height);
  const int block = std::max({1, (longest + kMostCells - 1) / kMostCells,
                              static_cast<int>(std::lround(kLeastCell / resolution))});
  footprint.cell = block * resolution;
  footprint.corner_in_map = cornerInMap(map, part);
  footprint.width = (part.width + block - 1) / block;
  footprint.height = (part.height + block - 1) / block;
  footprint.cells.resize(static_cast<size_t>(footprint.width) *
                         static_cast<size_t>(footprint.height));
  markKnown(map, limits, part, block, footprint);
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
        Point2D(part.width * resolution / 2, part.height * resolution / 2));
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

std::vector<Footprint> footprintsOf(const std::vector<Map>& maps, const StateOptions& states,
                                    int threads) {
  std::vector<Footprint> footprints(maps.size());
  parallelFor(static_cast<int>(maps.size()), threads, [&](int i) {
    footprints[static_cast<size_t>(i)] = footprintOf(maps[static_cast<size_t>(i)], states);
  });
  return footprints;
}

std::vector<Point2D> commonPoints(const Footprint& a, const Footprint& b,
                                  const Pose2D& pose_b_in_a) {
  std::vector<Point2D> common;
  const double c = std::cos(pose_b_in_a.phi), s = std::sin(pose_b_in_a.phi);
  forEachCommon(a, b, pose_b_in_a, [&](const Point2D& point) {
    common.emplace_back(pose_b_in_a.x + point.x * c - point.y * s,
                        pose_b_in_a.y + point.x * s + point.y * c);
  });
  return common;
}

double overlapShare(const Footprint& a, const Footprint& b, const Pose2D& pose_b_in_a) {
  if (a.known.empty() || b.known.empty()) {
    return 0;
  }
  const auto commonArea = [](const Footprint& of, const Footprint& in, const Pose2D& pose) {
    size_t count = 0;
    forEachCommon(in, of, pose, [&](const Point2D&) { ++count; });
    return static_cast<double>(count) * of.cell * of.cell;
  };
  // From both sides, so that the order of the maps does not matter.
  const double common =
      (commonArea(b, a, pose_b_in_a) + commonArea(a, b, inverse(pose_b_in_a))) / 2;
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
