// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/mrpt_reason.h"

namespace sbox {

std::string mrptReason(const std::exception& error) {
  const std::string text = error.what();
  // What is thrown by hand has the heading only.
  size_t begin = 0;
  for (const std::string mark : {"==== MRPT exception ====", "Message:"}) {
    const size_t found = text.find(mark);
    begin = found == std::string::npos ? begin : found + mark.size();
  }
  begin = text.find_first_not_of(" \t\r\n", begin);
  if (begin == std::string::npos) {
    return "unknown error";
  }
  return text.substr(begin, text.find_first_of("\r\n", begin) - begin);
}

}  // namespace sbox
