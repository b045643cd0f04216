// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox/merge_result.h"

namespace sbox::app {

/// Where each of result.merged goes: the main group to `output`, the others beside it with
/// "_group<N>" before the extension.
[[nodiscard]] std::vector<std::string> mergedFileNames(const MergeResult& result,
                                                       const std::string& output);

/// The picture that goes with a map: the same path, ending in .png.
[[nodiscard]] std::string pictureBeside(const std::string& map_file);

/// Where the map that SLAM makes of a log is kept beside the output, without extension: one for
/// each input, empty for those that are no logs. Logs of one name get numbers.
[[nodiscard]] std::vector<std::string> slamMapStems(const std::vector<std::string>& inputs,
                                                    const std::string& output);

/// Path of a picture in the folder; "_view" is added to its name where it would take the place of
/// one of the pictures beside the maps.
[[nodiscard]] std::string pictureInFolder(const std::string& folder, const std::string& file_name,
                                          const std::vector<std::string>& map_files);

}  // namespace sbox::app
