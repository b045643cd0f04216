// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/digest.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace sbox {

Digest& Digest::add(const void* bytes, std::size_t count) {
  const auto* from = static_cast<const unsigned char*>(bytes);
  for (std::size_t i = 0; i < count; i += sizeof(std::uint64_t)) {
    std::uint64_t block = 0;
    std::memcpy(&block, from + i, std::min(sizeof(block), count - i));
    value_ = (value_ ^ block) * 0xff51afd7ed558ccdULL;
    value_ =
        (value_ ^ (value_ >> 32)) * 0xc4ceb9fe1a85ec53ULL;  // Multiplication carries upwards only.
    value_ ^= value_ >> 32;
  }
  return *this;
}

std::string digestText(std::uint64_t digest) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(digest));
  return text;
}

}  // namespace sbox
