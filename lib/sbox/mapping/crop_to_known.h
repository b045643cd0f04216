// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/core/map.h"

namespace sbox {

/// The cells between the first and the last known row and column, and no other. Throws
/// std::invalid_argument if none is known.
[[nodiscard]] Map cropToKnown(const Map& map);

}  // namespace sbox
