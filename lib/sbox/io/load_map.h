// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sbox/core/map.h"

namespace sbox {

/// What the file itself cannot say.
struct LoadOptions {
  /// Edge length of a cell in metres for a plain image, which cannot say it itself; other files
  /// ignore it.
  std::optional<double> resolution;
};

/// Reads a map by the extension of its file: .gridmap and .gridmap.gz (MRPT), .simplemap and
/// .simplemap.gz (MRPT, whose scans are mapped by the default MappingOptions), .yaml and .yml (ROS,
/// with the image it names), or an image alone (see isImagePath). The name of the map is the path
/// as given. Throws FileError if the file cannot be used; the memory taken is bounded by what the
/// file really holds, but for simplemaps, which MRPT reads.
[[nodiscard]] Map loadMap(const std::string& path, const LoadOptions& options = {});

/// The files that loadMap reads for this path: itself, and the image that a .yaml names. A .yaml
/// that cannot be read names none.
[[nodiscard]] std::vector<std::string> filesRead(const std::string& path);

}  // namespace sbox
