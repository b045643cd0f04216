// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sbox/config/option_table.h"
#include "sbox/core/state_grid.h"

namespace sbox {

/// Adds which cells count as free and occupied, in the section named.
void describeStates(const std::string& section, StateOptions& options, OptionTable& table);

}  // namespace sbox
