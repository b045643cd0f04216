// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/mrpt_reason.h"

namespace sbox {

std::string mrptReason(const std::exception& error) {
  const std::string text = error.what();
  const std::string mark = "Message:";
  const size_t found = text.find(mark);
  const size_t begin =
      text.find_first_not_of(" \t\r\n", found == std::string::npos ? 0 : found + mark.size());
  if (begin == std::string::npos) {
    return "unknown error";
  }
  return text.substr(begin, text.find_first_of("\r\n", begin) - begin);
}

}  // namespace sbox
