// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/text_file.h"

#include <fstream>
#include <stdexcept>

namespace sbox::bench {

void writeText(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

}  // namespace sbox::bench
