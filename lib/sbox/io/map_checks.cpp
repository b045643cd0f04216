// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/map_checks.h"

#include <cmath>

#include "sbox/core/number_text.h"
#include "sbox/io/file_error.h"

namespace sbox {

void checkMapSize(const std::string& path, std::int64_t width, std::int64_t height) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " cells";
  if (width < 1 || height < 1) {
    throw FileError(path, "has no cells (" + size + ")");
  }
  if (width > max_map_side || height > max_map_side || width * height > max_map_cells) {
    throw FileError(path, "claims " + size + ", more than the " + std::to_string(max_map_cells) +
                              " (" + std::to_string(max_map_side) + " a side) that can be held");
  }
}

void checkResolution(const std::string& path, double resolution) {
  if (!(resolution >= min_resolution && resolution <= max_resolution)) {
    throw FileError(path, "resolution " + numberText(resolution) + " m is not between " +
                              numberText(min_resolution) + " and " + numberText(max_resolution) +
                              " m");
  }
}

void checkCorner(const std::string& path, const Pose2D& corner_in_map) {
  if (!(std::abs(corner_in_map.x) <= max_position && std::abs(corner_in_map.y) <= max_position)) {
    throw FileError(path, "lies too far from the zero of its frame: x " +
                              numberText(corner_in_map.x) + " m, y " + numberText(corner_in_map.y) +
                              " m");
  }
}

}  // namespace sbox
