// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/slam/scan_log.h"

namespace sbox {

/// MRPT's ICP-SLAM needs times that go on: it throws without them, maps but the first scan where
/// all are one, and warns of each step back. If a time is missing or not later than the one before,
/// all steps are given times 0.1 s apart; returns whether that was needed.
bool stampSteps(ScanLog& log);

}  // namespace sbox
