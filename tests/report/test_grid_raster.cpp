// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "catch.h"
#include "sbox/report/drawing/grid_raster.h"

using namespace sbox;

namespace {

StateGrid randomGrid(int width, int height, double resolution, const Pose2D& corner) {
  StateGrid grid{width, height, resolution, corner, {}};
  std::mt19937 random(7);
  for (int i = 0; i < width * height; ++i) {
    grid.cells.push_back(static_cast<CellState>(random() % 3));
  }
  return grid;
}

/// The cell that holds a point of the plot, and whether the point is clearly inside it.
std::pair<CellState, bool> stateAt(const StateGrid& grid, const Pose2D& pose,
                                   const Point2D& point) {
  const Point2D in_grid = inverse(pose + grid.corner_in_map).composePoint(point);
  const double x = in_grid.x / grid.resolution, y = in_grid.y / grid.resolution;
  const double off_x = x - std::floor(x) - 0.5, off_y = y - std::floor(y) - 0.5;
  return {grid.at(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))),
          std::max(std::abs(off_x), std::abs(off_y)) < 0.49};
}

}  // namespace

TEST_CASE("each pixel shows the cell under its centre, at any pose") {
  const StateGrid grid = randomGrid(9, 6, 0.1, {-0.35, 0.2, 0.3});
  for (const Pose2D& pose :
       {Pose2D{0, 0, 0}, Pose2D{1.5, -2, 0}, Pose2D{0, 0, 1.1}, Pose2D{-3.2, 0.7, -2.5}}) {
    Bounds bounds;
    bounds.add(grid, pose);
    const PlotView view = makeView(bounds, 87);
    const GridRaster raster = rasterize(grid, pose, view, 1);
    REQUIRE(raster.free.size() == view.size);
    int compared = 0, wrong = 0;
    for (int y = 0; y < view.size.height; ++y) {
      for (int x = 0; x < view.size.width; ++x) {
        const Point2D point{view.low.x + (x + 0.5) / 87,
                            view.low.y + (view.size.height - y - 0.5) / 87};
        const auto [state, clear] = stateAt(grid, pose, point);
        if (clear) {
          ++compared;
          wrong += (raster.free.at<unsigned char>(y, x) != 0) != (state == CellState::Free);
          wrong += (raster.occupied.at<unsigned char>(y, x) != 0) != (state == CellState::Occupied);
        }
      }
    }
    CHECK(compared > 1000);
    CHECK(wrong == 0);
  }
}

TEST_CASE("a thin wall stays where a pixel holds many cells") {
  StateGrid grid{400, 400, 0.05, {}, std::vector<CellState>(400 * 400, CellState::Free)};
  for (size_t y = 0; y < 400; ++y) {
    grid.cells[y * 400 + 203] = CellState::Occupied;
  }
  Bounds bounds;
  bounds.add(grid, {});
  const PlotView view = makeView(bounds, 4);
  const GridRaster raster = rasterize(grid, {}, view, 1);
  for (int y = 4; y < view.size.height - 4; ++y) {
    CHECK(cv::countNonZero(raster.occupied.row(y)) >= 1);
  }
}

TEST_CASE("an empty grid shows nothing") {
  const GridRaster raster = rasterize({}, {}, makeView({}, 10), 2);
  CHECK(cv::countNonZero(raster.occupied) + cv::countNonZero(raster.free) == 0);
}
