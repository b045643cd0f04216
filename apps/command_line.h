// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the command lines of the programs for developers have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

namespace sbox::app {

/// Reads the command line. What the program is to exit with if it ends there: 0 after its help, 2
/// after wrong usage, which stderr then explains.
inline std::optional<int> parseCommandLine(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
}

/// The most of anything that can be counted on a command line.
constexpr int kMost = 1'000'000;

}  // namespace sbox::app
