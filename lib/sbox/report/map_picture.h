// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "sbox/core/state_grid.h"

namespace sbox {

/// A map alone: walls, free space, the unknown.
[[nodiscard]] cv::Mat drawMap(const StateGrid& grid, const std::string& title);

}  // namespace sbox
