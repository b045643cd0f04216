// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CRawlog.h>

#include "sbox/slam/scan_log.h"

namespace sbox {

/// The steps of a log of bare observations; entries of other kinds are passed over. The scans are
/// shared with `log`.
[[nodiscard]] ScanLog stepsOfObservations(const mrpt::obs::CRawlog& log);

}  // namespace sbox
