// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The four transforms of a rough match (paper, section 3.2, eq. 4): three corners of one box on
// three of the other, for each cyclic shift.
#pragma once

#include <array>

#include "sbox/paper/boxes.h"

namespace sbox {

/// Poses of the frame of box a in that of box b, T0 to T3: corners 1, 2, 3 of a on the corners
/// 1 + k, 2 + k, 3 + k of b.
[[nodiscard]] std::array<Pose2D, 4> candidateTransforms(const SuppositionalBox& box_a,
                                                        const SuppositionalBox& box_b);

}  // namespace sbox
