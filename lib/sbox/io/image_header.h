// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What an image file claims about itself, read without decoding it: a small file can claim more
// pixels than there is memory.
#pragma once

#include <cstdint>
#include <optional>

#include "sbox/io/file_bytes.h"

namespace sbox {

/// Kinds of image that are decoded in different ways.
enum class ImageKind { Png, Pnm, Other };

/// What the first bytes claim.
struct ImageHeader {
  ImageKind kind = ImageKind::Other;  ///< By its magic number.
  std::int64_t width = 0;             ///< Pixels in a row.
  std::int64_t height = 0;            ///< Rows.
  bool whole = true;  ///< False if the file ends before the image does, as far as can be told.
};

/// Kind and size of a PNG, PNM (PGM, PPM), BMP, JPEG or TIFF; nothing if the bytes do not start as
/// one of them or if their header is cut off.
[[nodiscard]] std::optional<ImageHeader> readImageHeader(const Bytes& bytes);

}  // namespace sbox
