// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/html/mask_png.h"

#include <array>
#include <opencv2/imgcodecs.hpp>

namespace sbox::html {
namespace {

/// Chunk tRNS, which makes grey value 0 transparent: length, type, value, and the checksum of type
/// and value (PNG specification, 11.3.2.1).
constexpr std::array<unsigned char, 14> black_is_transparent{0,   0, 0, 2,    't',  'R',  'N',
                                                             'S', 0, 0, 0x76, 0x93, 0xCD, 0x38};

/// Where the pixels may begin: after the signature and the header chunk.
constexpr std::ptrdiff_t after_header = 8 + 25;

}  // namespace

std::vector<unsigned char> maskPng(const cv::Mat& mask) {
  std::vector<unsigned char> png;
  cv::imencode(".png", mask != 0, png,
               {cv::IMWRITE_PNG_BILEVEL, 1, cv::IMWRITE_PNG_COMPRESSION, 9});
  png.insert(png.begin() + after_header, black_is_transparent.begin(), black_is_transparent.end());
  return png;
}

}  // namespace sbox::html
