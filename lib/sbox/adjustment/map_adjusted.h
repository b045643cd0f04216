// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox/adjustment/adjust_key_frames.h"
#include "sbox/mapping/map_key_frames.h"

namespace sbox {

/// A map made anew of all scans.
struct AdjustedMap {
  Map map;                      ///< In the frame of the reference.
  KeyFrames key_frames;         ///< What it was made of, map by map.
  bool adjusted = false;        ///< Whether adjusting them made the map sharper.
  double joined_agreement = 0;  ///< scanAgreement() of the key frames as their maps were placed.
  double agreement = 0;         ///< scanAgreement() of the key frames as they are.
};

/// Maps the key frames of all maps twice, as the maps were placed and adjusted, and keeps the
/// sharper map. Range and tilt limits of `mapping` hold for the adjustment, too. Throws as
/// adjustKeyFrames and mapKeyFrames do.
[[nodiscard]] AdjustedMap mapAdjusted(const std::string& name,
                                      const std::vector<PlacedKeyFrames>& maps, size_t reference,
                                      const MappingOptions& mapping = {},
                                      AdjustmentOptions options = {}, int threads = 0,
                                      const ProgressFunction& progress = {});

}  // namespace sbox
