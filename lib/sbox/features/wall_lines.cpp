// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/wall_lines.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace sbox {
namespace {

/// A contour in metres with what is found along it.
struct Outline {
  const FreeContour& cells;
  double resolution;

  [[nodiscard]] size_t size() const { return cells.size(); }
  [[nodiscard]] Eigen::Vector2d at(size_t i) const {
    const ContourCell& cell = cells[i % cells.size()];
    return Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5) * resolution;
  }
};

/// Indices of the contour's corners after simplification, ascending.
std::vector<size_t> cornerIndices(const FreeContour& contour, double tolerance_cells) {
  std::vector<cv::Point> walk, corners;
  walk.reserve(contour.size());
  for (const ContourCell& cell : contour) {
    walk.emplace_back(cell.x, cell.y);
  }
  cv::approxPolyDP(walk, corners, tolerance_cells, true);
  // Corners are cells of the walk in its order, from anywhere on.
  std::vector<size_t> indices;
  const auto first = std::find(walk.begin(), walk.end(), corners.front());
  auto i = static_cast<size_t>(first - walk.begin());
  size_t steps = 0;
  for (const cv::Point& corner : corners) {
    while (walk[i % walk.size()] != corner && steps < walk.size()) {
      ++i;
      ++steps;
    }
    indices.push_back(i % walk.size());
  }
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

/// Total least squares line through the cells first .. last (cyclic, both included), shifted from
/// the cells' centres to their edge on the wall's side.
WallLine fitLine(const Outline& outline, size_t first, size_t last) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double at_wall = 0;
  for (size_t i = first; i <= last; ++i) {
    mean += outline.at(i);
    at_wall += outline.cells[i % outline.size()].at_wall ? 1 : 0;
  }
  const auto count = static_cast<double>(last - first + 1);
  mean /= count;
  double xx = 0, xy = 0, yy = 0;
  for (size_t i = first; i <= last; ++i) {
    const Eigen::Vector2d d = outline.at(i) - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d begin = outline.at(first), end = outline.at(last);
  if (along.dot(end - begin) < 0) {
    along = -along;
  }
  const Eigen::Vector2d to_wall(along.y(), -along.x());
  const Eigen::Vector2d base = mean + 0.5 * outline.resolution * to_wall;
  return {base + along * along.dot(begin - mean), base + along * along.dot(end - mean),
          at_wall / count};
}

/// Normal of the outline at cell i from the cells `reach` before and behind it.
Eigen::Vector2d localNormal(const Outline& outline, size_t i, size_t reach) {
  reach = std::min(reach, (outline.size() - 1) / 2);
  const Eigen::Vector2d along = outline.at(i + reach) - outline.at(i + outline.size() - reach);
  const double length = along.norm();
  return length > 0 ? Eigen::Vector2d(-along.y() / length, along.x() / length)
                    : Eigen::Vector2d::Zero();
}

void addPoints(const Outline& outline, const std::vector<const WallLine*>& line_of,
               const WallLineOptions& options, std::vector<WallPoint>& points) {
  const auto reach =
      static_cast<size_t>(std::max(1.0, std::round(options.tangent_reach / outline.resolution)));
  double since_last = options.point_spacing / 2;
  for (size_t i = 0; i < outline.size(); ++i) {
    since_last += (outline.at(i + 1) - outline.at(i)).norm();
    if (since_last < options.point_spacing) {
      continue;
    }
    since_last -= options.point_spacing;
    if (!outline.cells[i].at_wall) {
      continue;
    }
    if (const WallLine* line = line_of[i]) {
      const Eigen::Vector2d along = line->direction();
      points.push_back({line->from + along * along.dot(outline.at(i) - line->from), line->normal(),
                        line->length()});
      continue;
    }
    const Eigen::Vector2d normal = localNormal(outline, i, reach);
    if (!normal.isZero()) {
      points.push_back({outline.at(i) - 0.5 * outline.resolution * normal, normal, 0});
    }
  }
}

}  // namespace

Walls findWalls(const std::vector<FreeContour>& contours, double resolution,
                const WallLineOptions& options) {
  Walls walls;
  for (const FreeContour& contour : contours) {
    const Outline outline{contour, resolution};
    const std::vector<size_t> corners = cornerIndices(contour, options.tolerance / resolution);
    std::vector<WallLine> lines;
    std::vector<std::pair<size_t, size_t>> spans;
    for (size_t k = 0; k < corners.size(); ++k) {
      const size_t first = corners[k];
      const size_t last =
          k + 1 < corners.size() ? corners[k + 1] : corners.front() + contour.size();
      if ((outline.at(last) - outline.at(first)).norm() >= options.min_length) {
        lines.push_back(fitLine(outline, first, last));
        spans.emplace_back(first, last);
      }
    }
    std::vector<const WallLine*> line_of(contour.size(), nullptr);
    for (size_t k = 0; k < lines.size(); ++k) {
      for (size_t i = spans[k].first; i <= spans[k].second; ++i) {
        line_of[i % contour.size()] = &lines[k];
      }
    }
    addPoints(outline, line_of, options, walls.points);
    walls.lines.insert(walls.lines.end(), lines.begin(), lines.end());
  }
  return walls;
}

}  // namespace sbox
