// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/config/option_table.h"
#include "sbox/merge_options.h"

namespace sbox {

/// The options that concern the matching of two maps: the method, and those of either method. Bound
/// to `options`, which must outlive the table.
[[nodiscard]] OptionTable describePairOptions(MergeOptions& options);

/// Every option of every stage, a section each, bound to `options`, which must outlive the table.
/// Reading, dumping and explaining options all follow from this.
[[nodiscard]] OptionTable describeOptions(MergeOptions& options);

}  // namespace sbox
