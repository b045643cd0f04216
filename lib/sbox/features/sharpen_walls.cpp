// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/sharpen_walls.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "sbox/core/round.h"

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
      : cells_(cells), options_(options) {
    const double step = cells.resolution / kStepsPerCell;
    for (double offset = options.reach; offset >= -options.reach; offset -= step) {
      steps_.push_back(offset);
      steps_in_cells_.push_back(offset / cells.resolution);
    }
  }

  /// The edges across the wall through `base`, at places `first` to `last` along it; those far from
  /// their median are left out.
  [[nodiscard]] const std::vector<Edge>& across(const Eigen::Vector2d& base,
                                                const Eigen::Vector2d& normal, double first,
                                                double last) {
    const Eigen::Vector2d along(normal.y(), -normal.x());
    edges_.clear();
    for (double place = first; place <= last; place += 2 * cells_.resolution) {
      if (const std::optional<double> offset =
              edgeAt((base + place * along) / cells_.resolution, normal)) {
        edges_.push_back({place, *offset});
      }
    }
    dropOutliers();
    return edges_;
  }

 private:
  static constexpr size_t kStepsPerCell = 4;

  struct Cell {
    int x, y;
  };

  /// Offset at which free space ends, coming from the free side. `base` is in cells.
  [[nodiscard]] std::optional<double> edgeAt(const Eigen::Vector2d& base,
                                             const Eigen::Vector2d& normal) const {
    const auto place = [&](size_t step) {
      return Eigen::Vector2d(base + steps_in_cells_[step] * normal);
    };
    const double margin = options_.reach / cells_.resolution + 1;
    if (base.x() > margin && base.x() < cells_.width - margin && base.y() > margin &&
        base.y() < cells_.height - margin) {
      // Most walls: within the grid, to round down is to cut off.
      return firstEdge(
          [&](size_t step) {
            const Eigen::Vector2d cell = place(step);
            return Cell{static_cast<int>(cell.x()), static_cast<int>(cell.y())};
          },
          [&](const Cell& cell) {
            return cells_.cells[static_cast<size_t>(cell.y) * static_cast<size_t>(cells_.width) +
                                static_cast<size_t>(cell.x)] == CellState::Free;
          });
    }
    return firstEdge(
        [&](size_t step) {
          const Eigen::Vector2d cell = place(step);
          return Cell{floorToInt(cell.x()), floorToInt(cell.y())};
        },
        [&](const Cell& cell) { return cells_.at(cell.x, cell.y) == CellState::Free; });
  }

  /// The first step whose cell is not free while that of the step before is, as an offset.
  template <typename CellAt, typename IsFree>
  [[nodiscard]] std::optional<double> firstEdge(const CellAt& cell_at,
                                                const IsFree& free_at) const {
    if (steps_.empty()) {
      return std::nullopt;
    }
    Cell cell = cell_at(0);
    bool was_free = free_at(cell);
    for (size_t step = 0; step + 1 < steps_.size();) {
      const size_t next = std::min(step + kStepsPerCell, steps_.size() - 1);
      const Cell next_cell = cell_at(next);
      const bool next_free = free_at(next_cell);
      // Of one cell, or of two that share a side, there is no third in between.
      const bool no_other = std::abs(next_cell.x - cell.x) + std::abs(next_cell.y - cell.y) <= 1;
      if (!no_other || (was_free && !next_free)) {
        for (size_t i = step + 1; i <= next; ++i) {
          const bool is_free = free_at(cell_at(i));
          if (was_free && !is_free) {
            return steps_[i] + 0.5 * cells_.resolution / kStepsPerCell;
          }
          was_free = is_free;
        }
      }
      step = next;
      cell = next_cell;
      was_free = next_free;
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
  std::vector<double> steps_;           ///< Offsets that are looked at, from the free side on.
  std::vector<double> steps_in_cells_;  ///< The same in cells.
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
