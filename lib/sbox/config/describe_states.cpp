// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/config/describe_states.h"

namespace sbox {

void describeStates(const std::string& section, StateOptions& options, OptionTable& table) {
  table.section(section);
  table.number("free_above", options.free_above, {0.5, 1},
               "Probability of being free from which a cell counts as free");
  table.number("occupied_below", options.occupied_below, {0, 0.5},
               "Probability of being free below which it counts as occupied");
}

}  // namespace sbox
