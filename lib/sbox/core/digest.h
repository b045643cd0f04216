// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace sbox {

/// Bytes mixed eight at a time in the manner of MurmurHash3: tells whether two things are the same,
/// against accidents but not against malice.
class Digest {
 public:
  /// Adds bytes.
  Digest& add(const void* bytes, std::size_t count);
  /// Adds a number by its bytes.
  template <typename Number>
  Digest& add(Number number) {
    static_assert(std::is_arithmetic_v<Number>);
    return add(&number, sizeof(number));
  }
  /// The digest of all that was added, in that order.
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

/// Sixteen hexadecimal digits.
[[nodiscard]] std::string digestText(std::uint64_t digest);

}  // namespace sbox
