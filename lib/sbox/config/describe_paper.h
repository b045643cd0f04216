// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/config/option_table.h"
#include "sbox/paper/paper_method.h"

namespace sbox {

/// Adds the options of the published method, in sections "paper.*".
void describe(PaperOptions& options, OptionTable& table);

}  // namespace sbox
