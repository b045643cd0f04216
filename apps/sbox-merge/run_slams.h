// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox-merge/load_inputs.h"

namespace sbox::app {

/// A RunSlams.
void runSlams(const Arguments& arguments, const ProgressFunction& tell, Inputs& inputs);

}  // namespace sbox::app
