// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ini text as MRPT users write it: [section], key = value, comments after ; # or //.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace sbox {

/// One "key = value" with its section, both in lower case: MRPT's keys know no case.
struct IniEntry {
  std::string section;  ///< Empty before the first section.
  std::string key;      ///< In lower case.
  std::string value;    ///< As written, without comment and outer blanks.
  int line = 0;         ///< Counted from 1.
};

/// What is wrong with the text, with the line.
class IniError : public std::runtime_error {
 public:
  IniError(int line, const std::string& reason);  ///< "line N: reason", counted from 1.
};

/// All entries in their order. Unlike MRPT's own reading, a line that is none of the above, a key
/// outside of any section, and a key given twice are errors: a slip of the pen is not passed over.
/// Throws IniError.
[[nodiscard]] std::vector<IniEntry> parseIni(const std::string& text);

}  // namespace sbox
