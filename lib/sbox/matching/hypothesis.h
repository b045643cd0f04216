// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A way in which two maps may lie to each other.
#pragma once

#include "sbox/core/rigid_transform.h"

namespace sbox {

/// A transform that features proposed, before the cells were asked.
struct Hypothesis {
  RigidTransform b_in_a;  ///< From map b to map a.
  double votes = 0;       ///< Weights of the features that proposed it, summed.
};

}  // namespace sbox
