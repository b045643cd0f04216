// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/alignment/drift_field.h"
#include "sbox/alignment/evidence.h"
#include "sbox/core/rigid_transform.h"

namespace sbox {

/// A hypothesis that was aligned to the walls, and what the cells say of it.
struct Fit {
  RigidTransform b_in_a;   ///< From map b to map a.
  Evidence evidence;       ///< Of the rigid transform.
  DriftField drift;        ///< How the maps are bent against each other under it.
  Evidence bent_evidence;  ///< With the drift taken out, on a narrow scale.
  double bend_ratio = 0;   ///< How bent the maps are against each other over how bent each is.
  double log_odds = 0;     ///< See verdict_model.h: that this fit is right, up to a constant.
  double probability = 0;  ///< That this fit is right, and not another or none.
};

}  // namespace sbox
