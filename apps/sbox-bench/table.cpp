// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sbox::bench {

std::string toText(const Table& table, bool markdown) {
  std::vector<size_t> widths;
  for (const std::string& title : table.header) {
    widths.push_back(title.size());
  }
  for (const auto& row : table.rows) {
    for (size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string text;
  const auto addRow = [&](const std::vector<std::string>& row) {
    text += markdown ? "| " : "";
    for (size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - row[i].size(), ' ');
      text += i == 0 ? row[i] + padding : padding + row[i];
      text += i + 1 < row.size() ? (markdown ? " | " : "  ") : (markdown ? " |\n" : "\n");
    }
  };
  addRow(table.header);
  if (markdown) {
    text += '|';
    for (size_t i = 0; i < widths.size(); ++i) {
      text += std::string(widths[i] + 1, '-') + (i == 0 ? "-|" : ":|");
    }
    text += '\n';
  }
  for (const auto& row : table.rows) {
    addRow(row);
  }
  return text;
}

std::string formatNumber(double value, int digits) {
  if (std::isnan(value)) {
    return "-";
  }
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
  return buffer;
}

}  // namespace sbox::bench
