// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/drawing/text.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace sbox {
namespace {

constexpr int font = cv::FONT_HERSHEY_SIMPLEX;

/// Letters are drawn this many times larger and shrunk: OpenCV's strokes are whole pixels wide,
/// which is too coarse for small letters.
constexpr int text_oversampling = 4;

/// The font's capitals are 21 units high at scale one.
double largeScale(const TextStyle& style) { return text_oversampling * style.cap_height / 21; }

int largeStroke(const TextStyle& style, double widened_by = 0) {
  const double width = style.cap_height * (style.bold ? 0.14 : 0.09) + widened_by;
  return std::max(1, static_cast<int>(std::lround(text_oversampling * width)));
}

/// OpenCV's fonts know ASCII only: one "?" for each other character of UTF-8.
std::string asciiOnly(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      out += c;
    } else if ((byte & 0xC0U) != 0x80U) {
      out += '?';
    }
  }
  return out;
}

/// Blends the colour onto the picture where the text's strokes are, `widened_by` pixels wider.
void blendStrokes(cv::Mat& picture, const std::string& text, cv::Point base, const TextStyle& style,
                  const palette::Colour& colour, double widened_by) {
  const int pad = static_cast<int>(style.cap_height / 2) + 2;
  const auto height = static_cast<int>(std::ceil(style.cap_height));
  const cv::Rect place(base.x - pad, base.y - height - pad, textWidth(text, style) + 2 * pad,
                       height + 2 * pad);
  cv::Mat large(place.size() * text_oversampling, CV_8U, cv::Scalar(0));
  cv::putText(large, text, cv::Point(pad, height + pad) * text_oversampling, font,
              largeScale(style), cv::Scalar(255), largeStroke(style, widened_by), cv::LINE_AA);
  cv::Mat cover;
  cv::resize(large, cover, place.size(), 0, 0, cv::INTER_AREA);
  const cv::Rect visible = place & cv::Rect({0, 0}, picture.size());
  for (int y = visible.y; y < visible.y + visible.height; ++y) {
    for (int x = visible.x; x < visible.x + visible.width; ++x) {
      const double share = cover.at<unsigned char>(y - place.y, x - place.x) / 255.0;
      auto& pixel = picture.at<cv::Vec3b>(y, x);
      pixel = cv::Vec3d(pixel) * (1 - share) + cv::Vec3d(colour) * share;
    }
  }
}

}  // namespace

int textWidth(const std::string& text, const TextStyle& style) {
  int base_line = 0;
  return cv::getTextSize(asciiOnly(text), font, largeScale(style), largeStroke(style), &base_line)
             .width /
         text_oversampling;
}

void drawText(cv::Mat& picture, const std::string& text, cv::Point base, const TextStyle& style) {
  blendStrokes(picture, asciiOnly(text), base, style, style.colour, 0);
}

void drawLabel(cv::Mat& picture, const std::string& text, cv::Point centre,
               const TextStyle& style) {
  const cv::Point base(centre.x - textWidth(text, style) / 2,
                       centre.y + static_cast<int>(style.cap_height / 2));
  blendStrokes(picture, asciiOnly(text), base, style, palette::paper, style.cap_height / 3);
  drawText(picture, text, base, style);
}

std::string shortened(const std::string& text, int width, const TextStyle& style) {
  if (textWidth(text, style) <= width) {
    return text;
  }
  for (size_t keep = text.size(); keep > 1; --keep) {
    const size_t head = keep / 2;
    std::string candidate = text.substr(0, head) + "..." + text.substr(text.size() - (keep - head));
    if (textWidth(candidate, style) <= width) {
      return candidate;
    }
  }
  return "...";
}

}  // namespace sbox
