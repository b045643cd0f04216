// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's readers follow what a damaged file makes null pointers of, which ends the program. So
// files of its objects are read once in a process of their own before they are read in earnest.
#pragma once

#include <functional>
#include <string>

namespace sbox::app {

/// Whether a process of its own comes to the end of the work, if only by an exception; true where
/// no process can be started. To be called while the program has one thread.
[[nodiscard]] bool survives(const std::function<void()>& work);

/// Throws FileError if a process that only reads the file does not survive.
void tryReading(const std::string& path, const std::function<void()>& read);

}  // namespace sbox::app
