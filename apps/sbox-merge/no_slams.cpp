// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// In place of run_slams.cpp in a build without SLAM.
#include "sbox-merge/run_slams.h"
#include "sbox/io/file_error.h"

namespace sbox::app {

void runSlams(const Arguments& arguments, const ProgressFunction& /*tell*/, Inputs& /*inputs*/) {
  for (const std::string& input : arguments.inputs) {
    if (isRawlog(input)) {
      throw FileError(input, "needs SLAM, which this sbox-merge was built without: map it first");
    }
  }
}

}  // namespace sbox::app
