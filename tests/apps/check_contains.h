// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "catch.h"

namespace sbox::test {

inline void checkContains(const std::string& text, const std::string& part) {
  INFO("\"" << text << "\" must contain \"" << part << "\"");
  CHECK(text.find(part) != std::string::npos);
}

}  // namespace sbox::test
