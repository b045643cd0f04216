// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sbox {

/// `value` with `digits` decimals and never "-0".
[[nodiscard]] std::string fixedDigits(double value, int digits);

}  // namespace sbox
