// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How near to the truth each way of refining a transform comes, on the same pairs.
#pragma once

#include <vector>

#include "sbox-bench/run_method.h"
#include "sbox-bench/table.h"

namespace sbox::bench {

/// For each folder, over the pairs whose best fit is right: the median and the 90 % quantile of the
/// error over the floor, in cells, of the best pair of boxes, least squares over all corners, the
/// paper's Kalman step on that pair, the Kalman step on all corners, Ceres, and what is reported.
[[nodiscard]] Table refinementTable(const std::vector<LoadedFolder>& folders, int threads);

}  // namespace sbox::bench
