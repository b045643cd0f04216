// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two large maps of one building.
#pragma once

#include <filesystem>
#include <string>

namespace sbox::scale {

/// Prints what the columns of measureTwoMaps() are.
void printTwoMapsHeader();

/// Merges two maps of side x side cells, of which `known_side` across are known, and prints a row.
void measureTwoMaps(const std::string& command, int side, double known_side,
                    const std::filesystem::path& folder);

}  // namespace sbox::scale
