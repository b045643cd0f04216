// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The two steps that every method has: features of a map, and matching two maps by them.
#pragma once

#include <optional>
#include <variant>

#include "sbox/core/feature_set.h"
#include "sbox/core/pair_result.h"
#include "sbox/merge_options.h"

namespace sbox {

/// Features of one map, by whichever method.
using MethodFeatures = std::variant<MapFeatures, PaperFeatures>;

/// Features by options.method.
[[nodiscard]] MethodFeatures extractMethodFeatures(const Map& map, const MergeOptions& options);

/// Which cells options.method takes as free and which as occupied.
[[nodiscard]] const StateOptions& statesOf(const MergeOptions& options);

/// Matches two maps by the method that made their features; the published method takes no guess and
/// one thread.
/// Throws std::bad_variant_access if these were made by different methods.
[[nodiscard]] PairResult matchMethodFeatures(const MethodFeatures& a, const MethodFeatures& b,
                                             const MergeOptions& options,
                                             const std::optional<GuessedPoses>& guess = {},
                                             int threads = 1);

/// Lines, points and boxes, for reports and pictures.
[[nodiscard]] const FeatureSet& featureSetOf(const MethodFeatures& features);

}  // namespace sbox
