// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One rigid transform for maps that are bent against each other: the one nearest to the bent
// fit over all walls that agree. A rigid fit with a robust kernel would settle on the part of the
// building that agrees best as it is.
#pragma once

#include "sbox/alignment/drift_field.h"
#include "sbox/core/rigid_transform.h"
#include "sbox/features/map_features.h"

namespace sbox {

/// The least-squares rigid transform from the wall points of both maps that agree to the places
/// that `b_in_a` and then the drift give them; `b_in_a` where none agree.
[[nodiscard]] RigidTransform meanTransform(const MapFeatures& a, const MapFeatures& b,
                                           const RigidTransform& b_in_a, const DriftField& drift);

}  // namespace sbox
