// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's own grid matching, mrpt::slam::CGridMapAligner with its default options (what its command
// grid-matching runs): Harris corners with polar descriptors, a RANSAC of several hypotheses, ICP
// between the walls of each. It was deleted before MRPT 3.0, and this build may have no mrpt-slam.
#pragma once

#include <optional>

#include "sbox-bench/method.h"

namespace sbox::bench {

/// The answer is the mean of the most likely mode; it is accepted where any is left, that is, where
/// ICP's goodness and the distance it moved the mode pass the aligner's own thresholds. Maps of
/// unlike cell size are refused, as the aligner throws on them. Time per pair is bounded by its
/// own rule: five times as many draws as there are pairs of correspondences. Nothing where this
/// MRPT has no such class.
[[nodiscard]] std::optional<Method> mrptMethod();

}  // namespace sbox::bench
