// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace sbox {

/// JSON text that a person can read too: what fits in a line of 100 characters stays in one, all
/// else is broken and indented by two.
[[nodiscard]] std::string layOutJson(const nlohmann::ordered_json& json);

}  // namespace sbox
