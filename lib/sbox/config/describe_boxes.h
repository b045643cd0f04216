// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/config/option_table.h"
#include "sbox/match_pair.h"

namespace sbox {

/// Adds the options of the default method, in sections "features*", "matching.*", "verification*"
/// and "refinement*".
void describe(PairOptions& options, OptionTable& table);

}  // namespace sbox
