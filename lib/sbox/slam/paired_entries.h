// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CRawlog.h>

#include "sbox/slam/scan_log.h"

namespace sbox {

/// The steps of a log of action collections and sensory frames. Objects are shared with `log`,
/// except that the movements of several actions before one frame are joined in a new one, and a 3D
/// movement becomes a planar one.
[[nodiscard]] ScanLog stepsOfPairs(const mrpt::obs::CRawlog& log);

}  // namespace sbox
