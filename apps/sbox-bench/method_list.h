// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox-bench/method.h"

namespace sbox::bench {

/// The names of all methods, the library's own first.
[[nodiscard]] std::vector<std::string> methodNames();

/// The method of that name with its default options. Throws std::invalid_argument for a name that
/// is not in methodNames().
[[nodiscard]] Method methodByName(const std::string& name);

/// The library's method with some options of its own, "section.key=value,section.key=value", each
/// as sbox-merge --dump-config names it; that text is its name. Throws std::invalid_argument for
/// what is no option.
[[nodiscard]] Method methodWith(const std::string& settings);

}  // namespace sbox::bench
