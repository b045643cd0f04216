// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/adjustment/map_adjusted.h"

#include <utility>

#include "sbox/adjustment/scan_agreement.h"

namespace sbox {

AdjustedMap mapAdjusted(const std::string& name, const std::vector<PlacedKeyFrames>& maps,
                        size_t reference, const MappingOptions& mapping, AdjustmentOptions options,
                        int threads, const ProgressFunction& progress) {
  options.points.max_range = mapping.max_range;
  options.points.max_tilt = mapping.max_tilt;
  AdjustedMap kept;
  kept.key_frames = joinKeyFrames(maps);
  kept.map = mapKeyFrames(name, kept.key_frames, mapping);
  kept.joined_agreement = scanAgreement(kept.key_frames, kept.map, options.points);
  kept.agreement = kept.joined_agreement;
  KeyFrames adjusted = adjustKeyFrames(maps, reference, options, threads, progress);
  Map map = mapKeyFrames(name, adjusted, mapping);
  const double agreement = scanAgreement(adjusted, map, options.points);
  if (agreement > kept.joined_agreement) {
    kept = {std::move(map), std::move(adjusted), true, kept.joined_agreement, agreement};
  }
  return kept;
}

}  // namespace sbox
