// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a lidar without noise would see: exactly, or by MRPT's scan simulator.
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <functional>

#include "sbox-dataset/world.h"

namespace sbox::dataset {

/// Fills in the ranges and their validity, given the lidar's pose in the world and a scan that has
/// its aperture, number of beams and range limit.
using Ranger =
    std::function<void(const Pose2D& pose_in_world, mrpt::obs::CObservation2DRangeScan& scan)>;

/// Each beam to the first wall, worked out exactly. Keeps a reference to the world.
[[nodiscard]] Ranger exactRanger(const World& world);

/// MRPT's laser scan simulator over worldGrid(): ranges are right to about a cell, and it is fast
/// however many walls there are. Keeps a reference to the grid.
[[nodiscard]] Ranger gridRanger(const mrpt::maps::COccupancyGridMap2D& grid);

}  // namespace sbox::dataset
