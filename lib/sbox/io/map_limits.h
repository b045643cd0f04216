// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a map file may claim, checked before memory is taken for it.
#pragma once

#include <cstdint>
#include <string>

#include "sbox/core/pose.h"

namespace sbox {

/// Most cells of a map: 20000 x 20000, which is 1 km x 1 km in cells of 0.05 m.
inline constexpr std::int64_t max_map_cells = 400'000'000;
/// Most cells of a row or a column; keeps MRPT's extents in floats exact to a part of a cell.
inline constexpr std::int64_t max_map_side = 1'000'000;
/// Smallest and largest edge length of a cell, in metres.
inline constexpr double min_resolution = 1e-3;
inline constexpr double max_resolution = 100;

/// Farthest that a map may lie from the zero of its frame, in metres: what a double still holds to
/// a micrometre.
inline constexpr double max_position = 1e9;

/// Throws FileError naming `path` unless both sides and their product are within the limits.
void checkMapSize(const std::string& path, std::int64_t width, std::int64_t height);

/// Throws FileError naming `path` unless the edge length of a cell in metres is within the limits;
/// NaN is not.
void checkResolution(const std::string& path, double resolution);

/// Throws FileError naming `path` unless the corner lies within max_position of zero and is turned
/// by no more than 1000 full turns; NaN is not.
void checkCorner(const std::string& path, const Pose2D& corner_in_map);

}  // namespace sbox
