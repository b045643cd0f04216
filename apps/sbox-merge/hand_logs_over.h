// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's SLAM brings 120 libraries with it, which take longer to load than two maps to merge. So it
// is in a program of its own, which takes over where an input is a log.
#pragma once

#include "sbox/core/progress.h"

namespace sbox::app {

struct Arguments;
struct Inputs;

/// A RunSlams: runs sbox-merge-with-slam with the same command line in this program's place if any
/// input is a log. Throws FileError where that cannot be run.
void handLogsOver(const Arguments& arguments, const ProgressFunction& tell, Inputs& inputs);

}  // namespace sbox::app
