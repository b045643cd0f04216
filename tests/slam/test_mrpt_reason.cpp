// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/exceptions.h>

#include <stdexcept>

#include "catch.h"
#include "sbox/slam/mrpt_reason.h"

using namespace sbox;

TEST_CASE("MRPT's own text is cut down to what went wrong", "[mrpt_reason]") {
  try {
    THROW_EXCEPTION("no points map");
  } catch (const std::exception& error) {
    CHECK(mrptReason(error) == "no points map");
  }
  CHECK(mrptReason(std::runtime_error("==== MRPT exception ====\nno map\nCall stack")) == "no map");
  CHECK(mrptReason(std::runtime_error("plain\nand more")) == "plain");
  CHECK(mrptReason(std::runtime_error("")) == "unknown error");
}
