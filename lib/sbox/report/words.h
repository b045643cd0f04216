// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts and lengths as pictures and pages tell them.
#pragma once

#include <cstddef>
#include <string>

namespace sbox {

/// "3 lines", "1 line".
[[nodiscard]] std::string counted(std::size_t count, const std::string& one,
                                  const std::string& many);

/// The largest of 1, 2 or 5 times a power of ten that is at most `metres`, which is above 0.
[[nodiscard]] double roundLength(double metres);

/// A roundLength() with no more digits than it needs: "20 m", "0.5 m".
[[nodiscard]] std::string lengthText(double round_metres);

}  // namespace sbox
