// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One number for how well the cells' evidence speaks for a transform; orders hypotheses of a pair.
#pragma once

#include <algorithm>

#include "sbox/alignment/evidence.h"

namespace sbox {

/// Log of the odds, up to a constant of the pair, that the transform is right. Its weights are
/// those of a conditional logit model fitted to map pairs with known truth.
[[nodiscard]] double plausibility(const Overlap& overlap);

/// What plausibility() gives where the maps do not meet.
constexpr double kImplausible = -1000;

}  // namespace sbox
