// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps that have drifted fit each other nowhere well by any rigid transform: walls of the merged
// map stand twice. Here each map is bent onto those that are there before it, by the smooth field
// of displacements that verification takes out, so that walls fall on walls. For those who want one
// clean map and have no scans to make it of (with scans, mapAdjusted does better).
#pragma once

#include <vector>

#include "sbox/alignment/drift_field.h"
#include "sbox/alignment/evidence.h"
#include "sbox/features/map_features.h"
#include "sbox/fusion/fuse_maps.h"

namespace sbox {

/// How maps are bent.
struct BendOptions {
  FeatureOptions features;   ///< Of the walls that are laid on each other.
  DriftOptions drift;        ///< How stiff maps are.
  EvidenceOptions evidence;  ///< What of them counts as lying on each other.
  FusionOptions fusion;      ///< Of what is there before a map is bent onto it.
};

/// One map after bending.
struct BentMap {
  Map map;               ///< In the frame of the reference; the reference itself as it was.
  bool is_bent = false;  ///< False where bending made no more walls agree: then it lies as placed.
  double shift = 0;      ///< Root mean square displacement of its walls, metres.
};

/// All maps in the frame of maps[reference], bent where that makes more of the walls agree, in the
/// order of `maps`; that order changes nothing. One after the other is bent onto the maps before
/// it: the reference first, then always the map that has most free space in common with these.
/// Throws as fuseMaps does.
[[nodiscard]] std::vector<BentMap> bendMaps(const std::vector<PlacedMap>& maps, size_t reference,
                                            const BendOptions& options = {});

}  // namespace sbox
