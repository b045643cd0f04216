// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <utility>

namespace sbox::dataset {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity();

struct Step {
  int x, y;
  float length;
};

constexpr float kDiagonal = 1.41421356F;
constexpr std::array<Step, 8> kSteps{{{1, 0, 1},
                                      {-1, 0, 1},
                                      {0, 1, 1},
                                      {0, -1, 1},
                                      {1, 1, kDiagonal},
                                      {1, -1, kDiagonal},
                                      {-1, 1, kDiagonal},
                                      {-1, -1, kDiagonal}}};

}  // namespace

RoutePlanner::RoutePlanner(const mrpt::maps::COccupancyGridMap2D& grid, const RouteOptions& options)
    : options_(options),
      width_(static_cast<int>(grid.getSizeX())),
      height_(static_cast<int>(grid.getSizeY())),
      resolution_(static_cast<double>(grid.getResolution())),
      corner_(static_cast<double>(grid.getXMin()), static_cast<double>(grid.getYMin())) {
  cv::Mat free(height_, width_, CV_8U), distance;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      free.at<unsigned char>(y, x) = grid.getCell(x, y) > 0.5F ? 1 : 0;
    }
  }
  cv::distanceTransform(free, distance, cv::DIST_L2, cv::DIST_MASK_5);
  clearance_.resize(static_cast<size_t>(width_) * static_cast<size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      clearance_[static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x)] =
          distance.at<float>(y, x) * static_cast<float>(resolution_);
    }
  }
}

int RoutePlanner::cellAt(const Point2D& point) const {
  const int x = static_cast<int>(std::floor((point.x - corner_.x) / resolution_));
  const int y = static_cast<int>(std::floor((point.y - corner_.y) / resolution_));
  return x < 1 || y < 1 || x >= width_ - 1 || y >= height_ - 1 ? -1 : y * width_ + x;
}

Point2D RoutePlanner::centreOf(int cell) const {
  const int x = cell % width_, y = cell / width_;
  return {corner_.x + (x + 0.5) * resolution_, corner_.y + (y + 0.5) * resolution_};
}

bool RoutePlanner::seesStraight(const Point2D& from, const Point2D& to) const {
  const auto close = [&](const Point2D& point) {
    const int cell = cellAt(point);
    return cell < 0 ? 0.0F : clearance_[static_cast<size_t>(cell)];
  };
  // A short cut may not come closer to walls than its ends do, unless they are clear of them.
  const float least = std::min({close(from), close(to), static_cast<float>(options_.keep_clear)});
  const int steps = static_cast<int>(std::ceil((to - from).norm() / (resolution_ / 2)));
  for (int i = 0; i <= steps; ++i) {
    if (close(from + (to - from) * (i / static_cast<double>(std::max(1, steps)))) <
        least - static_cast<float>(resolution_)) {
      return false;
    }
  }
  return true;
}

std::vector<Point2D> RoutePlanner::route(const Point2D& from, const Point2D& to) const {
  const auto radius = static_cast<float>(options_.radius);
  const int start = cellAt(from), goal = cellAt(to);
  if (start < 0 || goal < 0 || clearance_[static_cast<size_t>(start)] < radius ||
      clearance_[static_cast<size_t>(goal)] < radius) {
    return {};
  }
  std::vector<float> cost(clearance_.size(), kUnreached);
  std::vector<int> parent(clearance_.size(), -1);
  using Entry = std::pair<float, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[static_cast<size_t>(start)] = 0;
  open.emplace(0.0F, start);
  while (!open.empty() && open.top().second != goal) {
    const auto [so_far, cell] = open.top();
    open.pop();
    if (so_far > cost[static_cast<size_t>(cell)]) {
      continue;
    }
    for (const Step& step : kSteps) {
      const int x = cell % width_ + step.x, y = cell / width_ + step.y;
      if (x < 1 || y < 1 || x >= width_ - 1 || y >= height_ - 1) {
        continue;
      }
      const int next = y * width_ + x;
      const float clear = clearance_[static_cast<size_t>(next)];
      if (clear < radius) {
        continue;
      }
      const float lacking = std::max(0.0F, static_cast<float>(options_.keep_clear) - clear);
      const float total = so_far + step.length * (1 + 8 * lacking);
      if (total < cost[static_cast<size_t>(next)]) {
        cost[static_cast<size_t>(next)] = total;
        parent[static_cast<size_t>(next)] = cell;
        open.emplace(total, next);
      }
    }
  }
  if (cost[static_cast<size_t>(goal)] == kUnreached) {
    return {};
  }
  std::vector<Point2D> cells;
  for (int cell = goal; cell != start; cell = parent[static_cast<size_t>(cell)]) {
    cells.push_back(centreOf(cell));
  }
  std::reverse(cells.begin(), cells.end());
  // Straight pieces in place of cells: as far ahead as can be seen.
  std::vector<Point2D> corners;
  Point2D at = from;
  for (size_t i = 0; i < cells.size();) {
    size_t furthest = i;
    while (furthest + 1 < cells.size() && seesStraight(at, cells[furthest + 1])) {
      ++furthest;
    }
    at = cells[furthest];
    corners.push_back(at);
    i = furthest + 1;
  }
  return corners;
}

Path RoutePlanner::tour(const Pose2D& start_in_world, const std::vector<Point2D>& places) const {
  Path path;
  path.start_in_world = start_in_world;
  Point2D at(start_in_world.x, start_in_world.y);
  for (const Point2D& place : places) {
    const std::vector<Point2D> way = route(at, place);
    if (!way.empty()) {
      path.points_in_world.insert(path.points_in_world.end(), way.begin(), way.end());
      at = way.back();
    }
  }
  return path;
}

}  // namespace sbox::dataset
