// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace sbox::html {

/// A mask (8 bit, one channel) as the bytes of a PNG of one bit a pixel: opaque where it is not 0,
/// else transparent. A page paints through it in a colour of its own.
[[nodiscard]] std::vector<unsigned char> maskPng(const cv::Mat& mask);

}  // namespace sbox::html
