// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a map file may claim, checked before memory is taken for it.
#pragma once

#include <cstdint>
#include <string>

#include "sbox/core/map_limits.h"
#include "sbox/core/pose.h"

namespace sbox {

/// Throws FileError naming `path` unless both sides and their product are within the limits.
void checkMapSize(const std::string& path, std::int64_t width, std::int64_t height);

/// Throws FileError naming `path` unless the edge length of a cell in metres is within the limits;
/// NaN is not.
void checkResolution(const std::string& path, double resolution);

/// Throws FileError naming `path` unless the corner lies within max_position of zero; NaN does not.
void checkCorner(const std::string& path, const Pose2D& corner_in_map);

}  // namespace sbox
