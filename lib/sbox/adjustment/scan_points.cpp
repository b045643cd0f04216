// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/adjustment/scan_points.h"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "sbox/core/principal_axes.h"

namespace sbox {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// The points of a scan in the order of its beams, in the robot's frame.
Points pointsOf(const mrpt::obs::CObservation2DRangeScan& scan, const Eigen::Vector2d& sensor,
                double max_range) {
  mrpt::maps::CSimplePointsMap map;
  map.insertionOptions.minDistBetweenLaserPoints = 0;
  map.insertionOptions.also_interpolate = false;
  map.insertObservation(scan);
  Points points;
  for (size_t i = 0; i < map.size(); ++i) {
    float x = 0, y = 0;
    map.getPoint(i, x, y);
    const Eigen::Vector2d place(x, y);
    if ((place - sensor).norm() <= max_range) {
      points.push_back(place);
    }
  }
  return points;
}

/// The direction across the surface around a point; none where there is no smooth one.
std::optional<Eigen::Vector2d> normalAt(const Points& points, size_t index,
                                        const ScanPointOptions& options) {
  constexpr size_t most_aside = 4;
  const size_t first = index - std::min(index, most_aside);
  const size_t end = std::min(index + most_aside + 1, points.size());
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  int count = 0;
  for (size_t i = first; i < end; ++i) {
    const Eigen::Vector2d offset = points[i] - points[index];
    if (offset.norm() <= options.neighbours) {
      sum += offset;
      squares += offset * offset.transpose();
      ++count;
    }
  }
  if (count < 3) {
    return std::nullopt;
  }
  const Eigen::Vector2d mean = sum / count;
  const PrincipalAxes axes = principalAxes(squares / count - mean * mean.transpose());
  const double across = std::sqrt(std::max(0.0, axes.smallest));
  const double along = std::sqrt(std::max(0.0, axes.largest));
  if (across > options.thickness || across > 0.5 * along || along == 0) {
    return std::nullopt;
  }
  return axes.smallest_axis;
}

}  // namespace

std::vector<ScanPoint> scanPoints(const mrpt::obs::CSensoryFrame& seen,
                                  const ScanPointOptions& options) {
  std::vector<ScanPoint> kept;
  for (const auto& observation : seen) {
    const auto scan =
        std::dynamic_pointer_cast<const mrpt::obs::CObservation2DRangeScan>(observation);
    // Of a single beam MRPT makes no points, but an error.
    if (!scan || scan->getScanSize() < 2 || !scan->isPlanarScan(options.max_tilt)) {
      continue;
    }
    const Eigen::Vector2d sensor(scan->sensorPose.x(), scan->sensorPose.y());
    const Points points = pointsOf(*scan, sensor, options.max_range);
    Eigen::Vector2d last = Eigen::Vector2d::Constant(HUGE_VAL);
    for (size_t i = 0; i < points.size(); ++i) {
      if ((points[i] - last).norm() < options.spacing) {
        continue;
      }
      if (const auto normal = normalAt(points, i, options)) {
        const double side = normal->dot(sensor - points[i]) < 0 ? -1 : 1;
        kept.push_back({points[i], *normal * side});
        last = points[i];
      }
    }
  }
  return kept;
}

}  // namespace sbox
