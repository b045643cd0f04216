// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The command as a user runs it, with what it took.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sbox::scale {

/// One run of sbox-merge.
struct MergeRun {
  int exit_code = 0;
  double seconds = 0;
  double peak_mib = 0;    ///< Of resident memory.
  nlohmann::json report;  ///< Discarded by the parser where there is none.
};

/// Runs `command --in MAPS... --report r.json -q ARGUMENTS...` in the folder, with all that it
/// writes by default. The report is read afterwards.
[[nodiscard]] MergeRun runMerge(const std::string& command, const std::filesystem::path& folder,
                                const std::vector<std::string>& maps,
                                const std::vector<std::string>& arguments = {});

}  // namespace sbox::scale
