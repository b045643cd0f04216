// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/coincidence.h"

#include <cmath>
#include <optional>

#include "sbox/core/state_grid.h"

namespace sbox::paper {
namespace {

/// Where the map has the wall that should stand at `place`, seen from the side of `normal`: the
/// centre of the first occupied cell behind a free one, projected on the normal.
std::optional<Point2D> wallNear(const StateGrid& grid, const Point2D& place, const Point2D& normal,
                                double search) {
  constexpr double kStep = 0.01;
  bool was_free = false;
  for (double off = search; off >= -search; off -= kStep) {
    const Point2D p = grid.corner_in_map.inverseComposePoint(place + normal * off);
    const int x = static_cast<int>(std::floor(p.x / grid.resolution));
    const int y = static_cast<int>(std::floor(p.y / grid.resolution));
    const CellState state = grid.at(x, y);
    if (state == CellState::Occupied) {
      if (!was_free) {
        return std::nullopt;
      }
      const Point2D centre = grid.corner_in_map.composePoint(
          {(x + 0.5) * grid.resolution, (y + 0.5) * grid.resolution});
      const Point2D to_centre = centre - place;
      return place + normal * (to_centre.x * normal.x + to_centre.y * normal.y);
    }
    was_free = state == CellState::Free;
  }
  return std::nullopt;
}

Point2D turned(const Point2D& direction, double angle) {
  return Pose2D(0, 0, angle).composePoint(direction);
}

}  // namespace

Coincidence wallCoincidence(const RobotPair& pair, const Pose2D& pose_b_in_a,
                            const CoincidenceOptions& options) {
  const std::array<StateGrid, 2> grids{classifyCells(pair.maps[0]), classifyCells(pair.maps[1])};
  Coincidence result;
  double gaps = 0;
  int places = 0;
  const auto followEdge = [&](const LineSegment& edge, double side) {
    const double length = (edge.to - edge.from).norm();
    const Point2D along = (edge.to - edge.from) * (1 / length);
    const Point2D normal(-along.y * side, along.x * side);
    double visible = 0, apart = 0;
    for (double at = options.spacing / 2; at < length; at += options.spacing) {
      const Point2D place = edge.from + along * at;
      const Pose2D in_a = worldInMap(pair.runs[0], place), in_b = worldInMap(pair.runs[1], place);
      const Point2D normal_a = turned(normal, in_a.phi), normal_b = turned(normal, in_b.phi);
      const auto wall_a = wallNear(grids[0], in_a.composePoint(place), normal_a, options.search);
      const auto wall_b = wallNear(grids[1], in_b.composePoint(place), normal_b, options.search);
      if (!wall_a || !wall_b) {
        continue;
      }
      const Point2D gap = pose_b_in_a.composePoint(*wall_b) - *wall_a;
      const double distance = std::abs(gap.x * normal_a.x + gap.y * normal_a.y);
      visible += options.spacing;
      apart += distance > options.apart ? options.spacing : 0;
      gaps += distance;
      ++places;
    }
    if (visible >= options.least_visible) {
      ++result.edges;
      result.apart_edges += apart > visible / 2 ? 1 : 0;
      result.length += visible;
      result.apart += apart;
    }
  };
  for (const LineSegment& wall : pair.world.walls) {
    if ((wall.to - wall.from).norm() >= options.least_edge) {
      followEdge(wall, 1);
      followEdge(wall, -1);
    }
  }
  result.mean_gap = places > 0 ? gaps / places : 0;
  return result;
}

}  // namespace sbox::paper
