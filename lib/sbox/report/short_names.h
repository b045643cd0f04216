// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox/merge_result.h"

namespace sbox {

/// The names with "-2", "-3", ... added so that all are distinct without regard to case; the first
/// to bear a name keeps it.
[[nodiscard]] std::vector<std::string> distinctNames(const std::vector<std::string>& names);

/// For each path a distinct name that is safe in a file name: letters, digits, "-" and "_" of its
/// stem, after its folder where stems are alike; at most 60 before numbers are added.
[[nodiscard]] std::vector<std::string> shortNames(const std::vector<std::string>& paths);

/// The short names of all maps, in their order.
[[nodiscard]] std::vector<std::string> shortNames(const MergeResult& result);

}  // namespace sbox
