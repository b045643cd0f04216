// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the stages of `sbox-merge` take together, beside what loading, saving and drawing take
// alone: the floor that our own stages are held against, in the same run on the same machine.
#pragma once

#include "sbox-bench/score_table.h"

namespace sbox::bench {

/// One row a stage: its time and its ratio to loading both maps, saving and drawing the merged one,
/// median and largest over the pairs that are merged; last all stages, from the files that the
/// folders have and from .gridmap files. Loads, fuses and saves again through a temporary folder,
/// one pair after the other, and takes the least time of the repeats.
[[nodiscard]] Table ratioTable(const MethodRun& run, int repeat);

}  // namespace sbox::bench
