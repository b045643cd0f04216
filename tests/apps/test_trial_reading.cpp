// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "catch.h"
#include "sbox-merge/trial_reading.h"
#include "sbox/io/file_error.h"

using sbox::app::survives;
using sbox::app::tryReading;

TEST_CASE("work that ends, if only by an exception, is survived") {
  int here = 0;
  CHECK(survives([&] { here = 1; }));
  CHECK(survives([] { throw std::runtime_error("no"); }));
  CHECK(here == 0);  // It was done elsewhere.
}

TEST_CASE("work that ends its process is not survived") {
  CHECK_FALSE(survives([] { std::raise(SIGKILL); }));
  CHECK_FALSE(survives([] { std::_Exit(3); }));
}

TEST_CASE("a file whose reading ends the process is refused") {
  CHECK_NOTHROW(tryReading("a.rawlog", [] {}));
  try {
    tryReading("a.rawlog", [] { std::raise(SIGKILL); });
    FAIL("was taken");
  } catch (const sbox::FileError& error) {
    CHECK(error.path() == "a.rawlog");
    CHECK(error.reason() == "is damaged: MRPT cannot read it");
  }
}
