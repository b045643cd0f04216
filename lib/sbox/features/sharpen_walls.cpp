// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/sharpen_walls.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sbox {
namespace {

/// Where free space ends on a line across a wall.
struct Edge {
  double along = 0;   ///< Place along the wall, metres.
  double offset = 0;  ///< Of the edge from the wall, to the free side, metres.
};

class EdgeFinder {
 public:
  EdgeFinder(const StateGrid& cells, const SharpenOptions& options)
      : cells_(cells), options_(options) {}

  /// The edges across the wall through `base`, at places `first` to `last` along it; those far from
  /// their median are left out.
  [[nodiscard]] const std::vector<Edge>& across(const Eigen::Vector2d& base,
                                                const Eigen::Vector2d& normal, double first,
                                                double last) {
    const Eigen::Vector2d along(normal.y(), -normal.x());
    edges_.clear();
    for (double place = first; place <= last; place += 2 * cells_.resolution) {
      if (const std::optional<double> offset = edgeAt(base + place * along, normal)) {
        edges_.push_back({place, *offset});
      }
    }
    dropOutliers();
    return edges_;
  }

 private:
  /// Offset at which free space ends, coming from the free side.
  [[nodiscard]] std::optional<double> edgeAt(const Eigen::Vector2d& base,
                                             const Eigen::Vector2d& normal) const {
    const double step = cells_.resolution / 4;
    bool was_free = false;
    for (double offset = options_.reach; offset >= -options_.reach; offset -= step) {
      const Eigen::Vector2d cell = (base + offset * normal) / cells_.resolution;
      const bool is_free = cells_.at(static_cast<int>(std::floor(cell.x())),
                                     static_cast<int>(std::floor(cell.y()))) == CellState::Free;
      if (was_free && !is_free) {
        return offset + step / 2;
      }
      was_free = is_free;
    }
    return std::nullopt;
  }

  void dropOutliers() {
    if (edges_.empty()) {
      return;
    }
    offsets_.clear();
    for (const Edge& edge : edges_) {
      offsets_.push_back(edge.offset);
    }
    const auto middle = offsets_.begin() + static_cast<std::ptrdiff_t>(offsets_.size() / 2);
    std::nth_element(offsets_.begin(), middle, offsets_.end());
    const double limit = std::max(options_.outlier, 1.5 * cells_.resolution);
    edges_.erase(
        std::remove_if(edges_.begin(), edges_.end(),
                       [&](const Edge& edge) { return std::abs(edge.offset - *middle) > limit; }),
        edges_.end());
  }

  const StateGrid& cells_;
  const SharpenOptions& options_;
  std::vector<Edge> edges_;
  std::vector<double> offsets_;
};

void sharpenLine(EdgeFinder& finder, const SharpenOptions& options, WallLine& line) {
  const Eigen::Vector2d normal = line.normal(), along = line.direction();
  const Eigen::Vector2d middle = 0.5 * (line.from + line.to);
  const double half = 0.5 * line.length();
  const std::vector<Edge>& edges = finder.across(middle, normal, -half, half);
  if (edges.size() < 3) {
    return;
  }
  double mean_along = 0, mean_offset = 0;
  for (const Edge& edge : edges) {
    mean_along += edge.along;
    mean_offset += edge.offset;
  }
  mean_along /= static_cast<double>(edges.size());
  mean_offset /= static_cast<double>(edges.size());
  double spread = 0, product = 0;
  for (const Edge& edge : edges) {
    spread += (edge.along - mean_along) * (edge.along - mean_along);
    product += (edge.along - mean_along) * (edge.offset - mean_offset);
  }
  const double slope = spread > 0 ? product / spread : 0;
  const auto shift = [&](double place) {
    return std::clamp(mean_offset + slope * (place - mean_along), -options.reach, options.reach);
  };
  line.from = middle - half * along + shift(-half) * normal;
  line.to = middle + half * along + shift(half) * normal;
}

}  // namespace

void sharpenWalls(const StateGrid& cells, Walls& walls, const SharpenOptions& options) {
  EdgeFinder finder(cells, options);
  for (WallLine& line : walls.lines) {
    sharpenLine(finder, options, line);
  }
  for (WallPoint& point : walls.points) {
    const std::vector<Edge>& edges =
        finder.across(point.position, point.normal, -options.along, options.along);
    if (edges.empty()) {
      continue;
    }
    double sum = 0;
    for (const Edge& edge : edges) {
      sum += edge.offset;
    }
    point.position += sum / static_cast<double>(edges.size()) * point.normal;
  }
}

}  // namespace sbox
