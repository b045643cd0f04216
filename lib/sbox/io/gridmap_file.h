// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's own grid map files: a gzip stream (or the plain bytes of one) holding one serialised
// mrpt::maps::COccupancyGridMap2D.
//
// Written by MRPT, read here: MRPT's reader moves the grid by up to half a cell onto a multiple of
// the cell size, and takes memory for whatever a damaged header claims.
#pragma once

#include <string>

#include "sbox/core/map.h"

namespace sbox {

/// Reads a `.gridmap` or `.gridmap.gz` of any MRPT since 2009; compressed or not is seen from its
/// contents. corner_in_map is x_min and y_min as stored, without yaw. Throws FileError.
[[nodiscard]] Map loadGridmap(const std::string& path);

/// Writes a gzip-compressed file that MRPT 1.x and later read. Cells are kept bit for bit, the
/// corner to float precision (MRPT itself will round it to a multiple of the cell size on reading).
/// The format knows no yaw: a turned map is written as alignToAxes gives it. Throws FileError, also
/// where the corner lies so far from zero that MRPT would miscount the cells.
void saveGridmap(const Map& map, const std::string& path);

}  // namespace sbox
