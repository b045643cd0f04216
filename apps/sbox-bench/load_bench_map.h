// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sbox/core/map.h"

namespace sbox::bench {

/// A map from a ROS-style image (white free, grey unknown, black occupied), with the cell size of
/// the .yaml beside it. Throws std::runtime_error with "PATH: reason".
[[nodiscard]] Map loadBenchMap(const std::string& path);

}  // namespace sbox::bench
