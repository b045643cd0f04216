// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ctrl-C and kill: the work ends at its next step, so that temporary files are removed.
#pragma once

#include <stdexcept>

namespace sbox::app {

/// The user or the system asked to stop.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(int signal);
  /// What the shell expects of a command that a signal ended.
  [[nodiscard]] int exitCode() const { return exit_code_; }

 private:
  int exit_code_;
};

/// From now on SIGINT, SIGTERM and SIGHUP are only noted, or stay ignored where they were, and a
/// file that grows beyond a limit is an error like a full disk.
void noteInterrupts();

/// Throws Interrupted if a signal has been noted.
void checkInterrupt();

}  // namespace sbox::app
