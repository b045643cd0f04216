// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/json_layout.h"

namespace sbox {
namespace {

constexpr size_t line_length = 100;

/// One line, with blanks after colons and commas.
std::string inLine(const nlohmann::ordered_json& json) {
  std::string out;
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      out += (out.empty() ? "" : ", ") + inLine(key) + ": " + inLine(value);
    }
    return "{" + out + "}";
  }
  if (json.is_array()) {
    for (const auto& value : json) {
      out += (out.empty() ? "" : ", ") + inLine(value);
    }
    return "[" + out + "]";
  }
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// `used`: characters of the line that are taken already.
std::string layOut(const nlohmann::ordered_json& json, size_t indent, size_t used) {
  std::string line = inLine(json);
  if (!json.is_structured() || used + line.size() <= line_length) {
    return line;
  }
  const std::string indentation(indent + 2, ' ');
  std::string out;
  for (const auto& [key, value] : json.items()) {
    const std::string label = json.is_object() ? inLine(key) + ": " : "";
    out.append(out.empty() ? "" : ",\n").append(indentation).append(label);
    out.append(layOut(value, indent + 2, indentation.size() + label.size()));
  }
  const std::string end(indent, ' ');
  return json.is_object() ? "{\n" + out + "\n" + end + "}" : "[\n" + out + "\n" + end + "]";
}

}  // namespace

std::string layOutJson(const nlohmann::ordered_json& json) { return layOut(json, 0, 0) + "\n"; }

}  // namespace sbox
