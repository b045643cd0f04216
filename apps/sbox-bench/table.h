// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace sbox::bench {

/// Rows of text under a header.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< Each as long as the header.
};

/// The table with aligned columns, the first to the left and the others to the right; as Markdown
/// if asked for. Ends in a line break.
[[nodiscard]] std::string toText(const Table& table, bool markdown);

/// A number with `digits` decimals, "-" for NaN.
[[nodiscard]] std::string formatNumber(double value, int digits);

}  // namespace sbox::bench
