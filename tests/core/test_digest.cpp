// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <vector>

#include "catch.h"
#include "sbox/core/digest.h"

using namespace sbox;

TEST_CASE("no change of one or two bytes leaves the digest as it was", "[digest]") {
  std::vector<unsigned char> bytes(64, 3);
  const auto digest = [&] { return Digest().add(bytes.data(), bytes.size()).value(); };
  std::set<std::uint64_t> seen{digest()};
  size_t tried = 1;
  for (size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] ^= 0x80U;
    seen.insert(digest());
    ++tried;
    for (size_t k = i + 1; k < bytes.size(); ++k) {
      bytes[k] ^= 0x80U;
      seen.insert(digest());
      bytes[k] ^= 0x80U;
      ++tried;
    }
    bytes[i] ^= 0x80U;
  }
  CHECK(seen.size() == tried);
}

TEST_CASE("a digest is told by sixteen digits", "[digest]") {
  CHECK(digestText(0x0123456789abcdefULL) == "0123456789abcdef");
  CHECK(digestText(1) == "0000000000000001");
  CHECK(digestText(Digest().add(1).value()) != digestText(Digest().add(2).value()));
}
