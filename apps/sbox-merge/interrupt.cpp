// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/interrupt.h"

#include <csignal>

namespace sbox::app {
namespace {

/// A signal handler can reach nothing but a variable of the program.
volatile std::sig_atomic_t noted_signal = 0;

extern "C" void noteSignal(int signal) { noted_signal = signal; }

constexpr int signal_exit_base = 128;

}  // namespace

Interrupted::Interrupted(int signal)
    : std::runtime_error("interrupted, nothing was written"),
      exit_code_(signal_exit_base + signal) {}

void noteInterrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) {
      continue;  // nohup, or a job in the background
    }
    struct sigaction action {};
    action.sa_handler = noteSignal;
    // A second one ends the command at once.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(signal, &action, nullptr);
  }
  // A file that grows beyond a limit is then an error of the write, which says so.
  std::signal(SIGXFSZ, SIG_IGN);
}

void checkInterrupt() {
  if (noted_signal != 0) {
    throw Interrupted(noted_signal);
  }
}

}  // namespace sbox::app
