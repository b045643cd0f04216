// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/html/map_masks.h"

#include <algorithm>

#include "sbox/report/drawing/grid_raster.h"
#include "sbox/report/html/html_text.h"
#include "sbox/report/html/mask_png.h"

namespace sbox::html {

std::string maskRule(const std::string& css_class, const cv::Mat& mask) {
  const std::string image = "url(" + pngUri(maskPng(mask)) + ")";
  return "." + css_class + "{-webkit-mask-image:" + image + ";mask-image:" + image + "}\n";
}

MapMasks maskMap(const StateGrid& grid, const std::string& name, int long_side) {
  constexpr int min_wall_pixels = 2;
  Bounds bounds;
  bounds.add(grid, {});
  MapMasks masks;
  masks.view = makeView(bounds, fitScale({bounds}, long_side, grid.resolution));
  masks.free_class = name + "-free";
  masks.wall_class = name + "-wall";
  const GridRaster raster = rasterize(grid, {}, masks.view, min_wall_pixels);
  masks.style =
      maskRule(masks.free_class, raster.free) + maskRule(masks.wall_class, raster.occupied);
  return masks;
}

int maskSide(size_t map_count) {
  constexpr size_t most = 1400, least = 400, all_pixels = 14000;
  return static_cast<int>(std::clamp(all_pixels / std::max<size_t>(map_count, 1), least, most));
}

}  // namespace sbox::html
