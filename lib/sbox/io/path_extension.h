// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace sbox {

/// Extension of a path in lower case with its dot; ".gz" takes the one before it along:
/// "MAP.gridmap.gz" gives ".gridmap.gz". Empty if there is none.
[[nodiscard]] std::string pathExtension(const std::string& path);

/// Whether the path ends in .yaml or .yml.
[[nodiscard]] bool isYamlPath(const std::string& path);

}  // namespace sbox
