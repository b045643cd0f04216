// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of YAML that ROS map files are written in: a mapping from keys to scalars and to lists
// of scalars. Our own, because MRPT's reader prints to stderr, takes half a broken file for a whole
// one and overflows its stack on deep nesting.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sbox {

/// What stands behind a key.
struct FlatYamlValue {
  /// Its form.
  enum class Kind {
    Scalar,
    List,
    Other  ///< Something else, such as a nested mapping: skipped.
  };
  Kind kind = Kind::Scalar;        ///< Says which of the members below counts.
  std::vector<std::string> items;  ///< The scalar, or the items of the list.
};

/// Reads the first document of the text: comments, plain and quoted scalars, lists in brackets or
/// one item a line. Throws std::invalid_argument, saying which line and why, where the text is no
/// such mapping.
[[nodiscard]] std::map<std::string, FlatYamlValue> parseFlatYaml(std::string_view text);

/// The text as a YAML scalar: quoted unless it is plain beyond doubt.
[[nodiscard]] std::string yamlScalar(const std::string& text);

}  // namespace sbox
