// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace sbox {

/// While it lives, what the process writes to stderr is lost; one at a time, others wait. For
/// libraries that complain there about what we report ourselves.
class SilentStderr {
 public:
  SilentStderr();
  SilentStderr(const SilentStderr&) = delete;
  SilentStderr& operator=(const SilentStderr&) = delete;
  ~SilentStderr();

 private:
  int kept_;  ///< A copy of the real one; -1 if there is none.
};

}  // namespace sbox
