// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace sbox {

/// Most cells of a map: 20000 x 20000, which is 1 km x 1 km in cells of 0.05 m.
inline constexpr std::int64_t max_map_cells = 400'000'000;
/// Most cells of a row or a column; keeps MRPT's extents in floats exact to a part of a cell.
inline constexpr std::int64_t max_map_side = 1'000'000;
/// Smallest edge length of a cell, in metres.
inline constexpr double min_resolution = 1e-3;
/// Largest edge length of a cell, in metres.
inline constexpr double max_resolution = 100;

/// Farthest that a map may lie from the zero of its frame, in metres: what a double still holds to
/// a micrometre.
inline constexpr double max_position = 1e9;

}  // namespace sbox
