// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Unsigned integers in file formats. The caller sees to it that the bytes are there.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sbox/io/file_bytes.h"

namespace sbox {

/// Two bytes from `at` on, the lowest first.
[[nodiscard]] inline std::uint16_t littleEndian16(const Bytes& bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] | (bytes[at + 1] << 8));
}
/// Two bytes from `at` on, the highest first.
[[nodiscard]] inline std::uint16_t bigEndian16(const Bytes& bytes, std::size_t at) {
  return static_cast<std::uint16_t>((bytes[at] << 8) | bytes[at + 1]);
}
/// Four bytes from `at` on, the lowest first.
[[nodiscard]] inline std::uint32_t littleEndian32(const Bytes& bytes, std::size_t at) {
  return littleEndian16(bytes, at) |
         (static_cast<std::uint32_t>(littleEndian16(bytes, at + 2)) << 16);
}
/// Four bytes from `at` on, the highest first.
[[nodiscard]] inline std::uint32_t bigEndian32(const Bytes& bytes, std::size_t at) {
  return (static_cast<std::uint32_t>(bigEndian16(bytes, at)) << 16) | bigEndian16(bytes, at + 2);
}

}  // namespace sbox
