// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/silent_stderr.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <mutex>

namespace sbox {
namespace {

std::mutex& turn() {
  static std::mutex mutex;
  return mutex;
}

void flushAll() {
  std::cerr.flush();
  std::fflush(stderr);
}

}  // namespace

SilentStderr::SilentStderr() {
  turn().lock();
  flushAll();
  kept_ = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (kept_ >= 0 && nowhere >= 0) {
    dup2(nowhere, STDERR_FILENO);
  }
  if (nowhere >= 0) {
    close(nowhere);
  }
}

SilentStderr::~SilentStderr() {
  if (kept_ >= 0) {
    flushAll();
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  turn().unlock();
}

}  // namespace sbox
