// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The world as a grid: what MRPT's scan simulator looks at and what routes are planned on.
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include "sbox-dataset/world.h"

namespace sbox::dataset {

/// A grid with cells of `resolution` metres over the world and `margin` metres around it: every
/// cell that a wall touches is occupied, all others are free.
[[nodiscard]] mrpt::maps::COccupancyGridMap2D worldGrid(const World& world, double resolution,
                                                        double margin = 0.5);

}  // namespace sbox::dataset
