// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox/match_share.h"

namespace sbox {

/// A share of the pairs as JSON, with every number in full.
[[nodiscard]] std::string shareJson(const MatchedShare& share,
                                    const std::vector<std::string>& map_names);

/// Reads it back. Throws FileError if the file cannot be read, or holds anything else.
[[nodiscard]] MatchedShare loadShare(const std::string& path);

}  // namespace sbox
