// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A matched pair as JSON: in the report, and in the shares of --pairs, which are read back.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "sbox/placement/map_pair.h"

namespace sbox {

/// x and y in metres, phi in radians; null for no pose.
[[nodiscard]] nlohmann::ordered_json poseJson(const std::optional<Pose2D>& pose);

/// Three rows.
[[nodiscard]] nlohmann::ordered_json covarianceJson(const PoseCovariance& covariance);

/// All but the settlement and the seconds; of the matched boxes their number.
[[nodiscard]] nlohmann::ordered_json pairJson(const MapPair& pair);

/// Reads it back, without the matched boxes. Throws std::exception of one kind or another on
/// anything else.
[[nodiscard]] MapPair pairFromJson(const nlohmann::ordered_json& json);

/// A whole number from 0 to 2^30. Throws std::invalid_argument on anything else.
[[nodiscard]] int indexFromJson(const nlohmann::ordered_json& json);

}  // namespace sbox
