// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A way in which two maps may lie to each other.
#pragma once

#include "sbox/core/rigid_transform.h"

namespace sbox {

/// A transform that was proposed, before all cells were asked.
struct Hypothesis {
  RigidTransform b_in_a;  ///< From map b to map a.
  /// What speaks for it, to be compared within one list only: by voteForTransforms() the summed
  /// weights of the features that proposed it, by searchByCorrelation() its plausibility.
  double votes = 0;
};

}  // namespace sbox
