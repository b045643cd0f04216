// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text in pictures, in OpenCV's own vector font.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "sbox/report/drawing/palette.h"

namespace sbox {

/// How text is drawn.
struct TextStyle {
  double cap_height = 22;  ///< Height of a capital letter, in pixels; the stroke follows.
  palette::Colour colour = palette::ink;  ///< Of the strokes.
  bool bold = false;                      ///< Wider strokes.
};

/// Width of the text, in pixels.
[[nodiscard]] int textWidth(const std::string& text, const TextStyle& style);

/// Draws the text with the left end of its base line at `base`.
void drawText(cv::Mat& picture, const std::string& text, cv::Point base, const TextStyle& style);

/// Draws the text about `centre` with a white rim, to be read on anything.
void drawLabel(cv::Mat& picture, const std::string& text, cv::Point centre, const TextStyle& style);

/// The text, its middle replaced by "..." where it would be wider than `width` pixels.
[[nodiscard]] std::string shortened(const std::string& text, int width, const TextStyle& style);

}  // namespace sbox
