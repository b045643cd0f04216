// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox-merge/arguments.h"
#include "sbox-merge/command.h"
#include "sbox/core/key_frame.h"
#include "sbox/core/map.h"
#include "sbox/core/progress.h"

namespace sbox::app {

/// Whether the input is a robot's log, by its name, and has to go through SLAM.
[[nodiscard]] bool isRawlog(const std::string& path);

/// What the inputs hold, in their order.
struct Inputs {
  std::vector<Map> maps;
  std::vector<KeyFrames> key_frames;  ///< What each map was made of; empty where that is unknown.
};

/// Reads the maps, or makes them: of a simplemap by its poses, of a robot's log by SLAM. Throws
/// FileError if one cannot be used.
[[nodiscard]] Inputs loadInputs(const Arguments& arguments, const RunSlams& run_slams,
                                const ProgressFunction& tell);

}  // namespace sbox::app
