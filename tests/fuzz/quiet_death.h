// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sanitizer/common_interface_defs.h>
#include <sys/resource.h>

#include <csignal>

namespace sbox::fuzz {

/// In a process that may end any way: none of these is a finding of the fuzzer. AddressSanitizer
/// has taken all addresses there are, so that a limit on memory does nothing; one on time stands
/// in.
inline void dieQuietly() {
  const rlimit seconds{1, 1};
  setrlimit(RLIMIT_CPU, &seconds);
  __sanitizer_set_death_callback(nullptr);
  for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) {
    std::signal(signal, SIG_DFL);
  }
}

}  // namespace sbox::fuzz
