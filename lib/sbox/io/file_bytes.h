// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sbox {

/// What a file holds.
using Bytes = std::vector<std::uint8_t>;

/// Size in bytes of a file that can be read. Throws FileError if it is missing, unreadable, empty
/// or not a regular file (a folder, a pipe, a device).
std::uint64_t checkReadable(const std::string& path);

/// The whole file. Throws FileError as checkReadable does, and if it has more than `max_bytes`.
[[nodiscard]] Bytes readFile(const std::string& path, std::uint64_t max_bytes);

/// Replaces the contents of the file. Throws FileError if not every byte could be written, such as
/// on a full disk.
void writeFile(const std::string& path, const Bytes& bytes);

}  // namespace sbox
