// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>

namespace sbox {

/// Whether the numbers of a 2D lidar scan or a sonar reading can be: its sensor has a sound pose,
/// it looks over an angle of no more than all round, and no distance is below zero (one without
/// end, or none, is what drivers give for a beam without an echo). MRPT, which does not ask, writes
/// beside its memory otherwise. True for observations of other kinds.
[[nodiscard]] bool isSound(const mrpt::obs::CObservation& observation);

}  // namespace sbox
