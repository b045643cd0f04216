// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox-bench/score_table.h"

namespace sbox::bench {

/// One JSON object a line with the accepted transform of each pair, from the corner of a's grid to
/// that of b's: what an external scorer of the same format reads. `with_seconds` false leaves out
/// what differs from run to run.
[[nodiscard]] std::string answerLines(const MethodRun& run, bool with_seconds);

/// Every answer of every run with its judgement, as a JSON document.
[[nodiscard]] std::string answersJson(const std::vector<MethodRun>& runs, bool with_seconds);

}  // namespace sbox::bench
