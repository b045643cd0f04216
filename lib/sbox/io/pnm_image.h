// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The PNM images in which ROS keeps maps: PGM and PPM, binary or text (P2, P3, P5, P6). Read here
// because OpenCV 4 leaves binary values as they are where the largest one is not 255.
#pragma once

#include <optional>
#include <string>

#include "sbox/io/image_file.h"
#include "sbox/io/image_header.h"

namespace sbox {

/// Whether the bytes start as one of the four kinds.
[[nodiscard]] bool isPnm(const Bytes& bytes);

/// The size it claims; nothing if the header is cut off or damaged.
[[nodiscard]] std::optional<ImageHeader> readPnmHeader(const Bytes& bytes);

/// The pixels, scaled so that the largest value becomes 255. Throws FileError naming `path` if
/// there are too few or if a value is no number or too large.
[[nodiscard]] Image decodePnm(const std::string& path, const Bytes& bytes);

/// A grey image as binary PGM.
[[nodiscard]] Bytes encodePgm(const Image& image);

}  // namespace sbox
