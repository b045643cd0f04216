// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/html/html_text.h"

#include <nlohmann/json.hpp>

namespace sbox::html {
namespace {

/// The text with each byte that is not part of UTF-8 replaced.
std::string validUtf8(const std::string& text) {
  using Json = nlohmann::ordered_json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace))
      .get<std::string>();
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : validUtf8(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? '?' : c;
    }
  }
  return out;
}

std::string pngUri(const std::vector<unsigned char>& png) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out = "data:image/png;base64,";
  for (size_t i = 0; i < png.size(); i += 3) {
    const size_t left = png.size() - i;
    const unsigned three = static_cast<unsigned>(png[i]) << 16 |
                           (left > 1 ? static_cast<unsigned>(png[i + 1]) << 8 : 0U) |
                           (left > 2 ? static_cast<unsigned>(png[i + 2]) : 0U);
    out += digits[three >> 18];
    out += digits[three >> 12 & 63];
    out += left > 1 ? digits[three >> 6 & 63] : '=';
    out += left > 2 ? digits[three & 63] : '=';
  }
  return out;
}

}  // namespace sbox::html
