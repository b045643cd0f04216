// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's readers follow what a damaged file makes null pointers of, which ends the program, and
// make room for whatever number of things it claims to hold. So files of its objects are read once
// in a process of their own, with no more memory than such a file can need, before they are read in
// earnest.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace sbox::app {

/// Throws FileError if a process of its own that only reads the file throws one, is in need of more
/// than `memory` bytes beyond what the program has, or does not come to an end. Nothing happens
/// where no process can be started, or to other exceptions: they will be met again. To be called
/// while the program has one thread.
void tryReading(const std::string& path, std::uint64_t memory, const std::function<void()>& read);

/// The same with as much memory as what the file holds can take once it is read.
void tryReading(const std::string& path, const std::function<void()>& read);

}  // namespace sbox::app
