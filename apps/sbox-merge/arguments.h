// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "sbox/match_share.h"
#include "sbox/merge_options.h"
#include "sbox/slam/run_slam.h"

namespace sbox::app {

/// What the user asked for.
struct Arguments {
  std::vector<std::string> command_line;  ///< As it was given, the name first.
  std::vector<std::string> inputs;
  std::string output = "merged.gridmap";
  std::string simplemap;              ///< Of all key frames; empty: none.
  std::string report;                 ///< Empty: none.
  std::string pictures;               ///< Folder; empty: none.
  std::string html;                   ///< Empty: none.
  std::string tf;                     ///< Empty: none.
  std::string graph;                  ///< Empty: none.
  std::optional<PairShare> share;     ///< Match only these pairs and write them as the report.
  std::vector<std::string> joined;    ///< Reports of all shares, instead of matching.
  std::vector<std::string> settings;  ///< Files of --config, --initial and --slam-config.
  std::optional<double> resolution;   ///< Of plain images, metres a cell.
  MergeOptions merge;                 ///< With what --config and the other options say.
  SlamOptions slam;                   ///< For rawlogs.
  bool fuse_observations = false;     ///< Make the merged map anew of all scans.
  bool dump_config = false;
  bool verbose = false;
  bool quiet = false;
};

/// Wrong usage. what() is one line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the command line, and the file that --config names. Nothing if all has been said already
/// (--help, --version). Throws UsageError, and FileError if the configuration cannot be used.
[[nodiscard]] std::optional<Arguments> parseArguments(int argc, const char* const* argv);

}  // namespace sbox::app
