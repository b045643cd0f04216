// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace sbox::dataset {

/// One line of a plain-text file: a keyword and the numbers behind it.
struct TextLine {
  std::string keyword;
  std::vector<double> numbers;
  std::string place;  ///< "PATH:LINE", for error messages.

  /// Throws std::runtime_error unless there are as many numbers as `usage` says.
  void expect(bool holds, const std::string& usage) const {
    if (!holds) {
      throw std::runtime_error(place + ": expected: " + usage);
    }
  }
};

/// The lines of a file that hold more than a # comment. Throws std::runtime_error if it cannot be
/// read or holds something else than a keyword and finite numbers.
[[nodiscard]] std::vector<TextLine> readTextLines(const std::string& path);

}  // namespace sbox::dataset
