// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

namespace sbox {

/// What MRPT complains about, as one line: its own texts are many, with a backtrace.
[[nodiscard]] std::string mrptReason(const std::exception& error);

}  // namespace sbox
