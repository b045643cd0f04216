// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/map_picture.h"

#include "sbox/report/drawing/figure.h"
#include "sbox/report/drawing/paint.h"

namespace sbox {

cv::Mat drawMap(const StateGrid& grid, const std::string& title) {
  Bounds bounds;
  bounds.add(grid, {});
  const double scale = fitScale({bounds}, plot_long_side, grid.resolution);
  Figure figure;
  figure.title = title;
  figure.plots = {paintCells(grid, makeView(bounds, scale), palette::wall)};
  figure.pixels_per_metre = scale;
  figure.legend = {{Swatch::Area, palette::wall, "wall"},
                   {Swatch::Area, palette::free_space, "free"},
                   {Swatch::Area, palette::unknown, "unknown"}};
  return composeFigure(figure);
}

}  // namespace sbox
