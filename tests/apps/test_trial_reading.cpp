// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.h"
#include "sbox-merge/trial_reading.h"
#include "sbox/io/file_error.h"

using sbox::FileError;
using sbox::app::tryReading;

namespace {

/// Why the file is refused; nothing if it is not.
std::string refusal(const std::function<void()>& read) {
  try {
    tryReading("a.rawlog", 64U << 20U, read);
  } catch (const FileError& error) {
    CHECK(error.path() == "a.rawlog");
    return error.reason();
  }
  return "";
}

}  // namespace

TEST_CASE("reading that ends, if only by an exception, is done elsewhere and then here") {
  int here = 0;
  CHECK(refusal([&] { here = 1; }).empty());
  CHECK(refusal([] { throw std::runtime_error("no"); }).empty());
  CHECK(here == 0);
}

TEST_CASE("a file whose reading ends the process is refused") {
  CHECK(refusal([] { std::raise(SIGKILL); }) == "is damaged: MRPT cannot read it");
  CHECK(refusal([] { std::_Exit(3); }) == "is damaged: MRPT cannot read it");
}

TEST_CASE("what the trial finds wrong with a file is not waited for twice") {
  CHECK(refusal([] { throw FileError("a.rawlog", "holds no scan"); }) == "holds no scan");
}

TEST_CASE("a file that asks for more memory than it can need is refused") {
  const auto fill = [](std::size_t bytes) {
    return [bytes] {
      const std::vector<char> memory(bytes, 1);
      std::_Exit(std::count(memory.begin(), memory.end(), 1) == static_cast<std::ptrdiff_t>(bytes)
                     ? 0
                     : 1);
    };
  };
  CHECK(refusal(fill(16U << 20U)).empty());
  CHECK(refusal([] { throw std::bad_alloc(); }) == "does not fit into memory, or is damaged");
  // In words that depend on the allocator.
  CHECK_FALSE(refusal(fill(std::size_t{4} << 30U)).empty());
}
