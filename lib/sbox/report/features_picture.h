// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "sbox/core/feature_set.h"
#include "sbox/core/state_grid.h"

namespace sbox {

/// The features of a map over its cells, as in the paper's figure 7: lines, vertical points and
/// translucent suppositional boxes.
[[nodiscard]] cv::Mat drawFeatures(const StateGrid& grid, const FeatureSet& features,
                                   const std::string& name);

}  // namespace sbox
