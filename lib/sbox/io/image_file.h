// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "sbox/io/file_bytes.h"

namespace sbox {

/// Pixels of 8 bits a channel.
struct Image {
  int width = 0;     ///< Pixels in a row.
  int height = 0;    ///< Rows.
  int channels = 0;  ///< 1 grey, 3 colour (in any order), 4 colour and, last, opacity.
  Bytes pixels;      ///< Row by row, top row first, channels side by side.

  /// First byte of a row.
  [[nodiscard]] const std::uint8_t* row(int y) const {
    return pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width) *
                               static_cast<std::size_t>(channels);
  }
};

/// Whether the path ends as an image file that can be read: .png .pgm .ppm .pnm .bmp .jpg .jpeg
/// .tif .tiff, in any case.
[[nodiscard]] bool isImagePath(const std::string& path);

/// Reads an image; what kind it is is seen from its contents. 16 bits a channel are rounded to 8.
/// The size is checked against the limits of a map before the pixels are decoded. Throws FileError.
[[nodiscard]] Image loadImage(const std::string& path);

/// Writes a grey image, by the extension as .png or .pgm. Throws FileError.
void saveGreyImage(const Image& image, const std::string& path);

}  // namespace sbox
