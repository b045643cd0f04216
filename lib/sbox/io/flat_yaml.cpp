// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/flat_yaml.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace sbox {
namespace {

constexpr std::string_view blanks = " \t";

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool isBlank(char c) { return c == ' ' || c == '\t'; }

/// Whether a value is a scalar on this line, rather than something nested, named or folded.
bool startsScalar(std::string_view text) {
  return std::string_view("[{&*!|>@`%").find(text[0]) == std::string_view::npos;
}

/// Takes scalars off the front of a line.
class ScalarReader {
 public:
  explicit ScalarReader(std::string_view text) : text_(text) {}

  /// What is left, without leading blanks and without a comment.
  std::string_view rest() {
    const std::size_t first = std::min(text_.find_first_not_of(blanks), text_.size());
    const bool after_blank = first > 0 || at_start_;
    text_.remove_prefix(first);
    return after_blank && !text_.empty() && text_[0] == '#' ? std::string_view() : text_;
  }
  void skip(std::size_t count) {
    text_.remove_prefix(count);
    at_start_ = false;
  }
  /// A quoted scalar, or a plain one up to one of `ends` or a comment.
  std::string scalar(std::string_view ends) {
    const std::string_view text = rest();
    if (!text.empty() && (text[0] == '"' || text[0] == '\'')) {
      return quoted(text[0]);
    }
    std::size_t size = 0;
    while (size < text.size() && ends.find(text[size]) == std::string_view::npos &&
           !(text[size] == '#' && size > 0 && isBlank(text[size - 1]))) {
      ++size;
    }
    // Blanks stay, as they tell a comment from a "#" within a word.
    std::string value(trim(text.substr(0, size)));
    skip(value.size());
    return value;
  }

 private:
  std::string quoted(char quote) {
    std::string value;
    for (std::size_t i = 1; i < text_.size(); ++i) {
      const bool more = i + 1 < text_.size();
      if (text_[i] == quote && quote == '\'' && more && text_[i + 1] == quote) {
        value.push_back(text_[++i]);
      } else if (text_[i] == quote) {
        skip(i + 1);
        return value;
      } else if (text_[i] == '\\' && quote == '"') {
        if (!more || (text_[i + 1] != '"' && text_[i + 1] != '\\' && text_[i + 1] != '/')) {
          throw std::invalid_argument("an escape that is not supported");
        }
        value.push_back(text_[++i]);
      } else {
        value.push_back(text_[i]);
      }
    }
    throw std::invalid_argument("a quote that is not closed");
  }

  std::string_view text_;
  bool at_start_ = true;
};

class Parser {
 public:
  void add(std::string_view line) {
    if (in_brackets_) {
      readItems(ScalarReader(line));
      return;
    }
    ScalarReader reader(line);
    const std::string_view content = reader.rest();
    if (content.empty()) {
      return;
    }
    const bool is_item = content[0] == '-' && (content.size() == 1 || isBlank(content[1]));
    if (isBlank(line[0]) || is_item) {
      continueValue(reader, is_item);
    } else {
      startValue(reader);
    }
  }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  std::map<std::string, FlatYamlValue> finish() {
    if (in_brackets_) {
      throw std::invalid_argument("a list that is not closed");
    }
    return std::move(values_);
  }

 private:
  void startValue(ScalarReader reader) {
    const bool is_scalar = startsScalar(reader.rest());
    const std::string key = reader.scalar(":");
    const std::string_view rest = reader.rest();
    if (!is_scalar || key.empty() || rest.empty() || rest[0] != ':' ||
        (rest.size() > 1 && !isBlank(rest[1]))) {
      throw std::invalid_argument("no \"key: value\"");
    }
    reader.skip(1);
    const auto [place, is_new] = values_.emplace(key, FlatYamlValue());
    if (!is_new) {
      throw std::invalid_argument("key \"" + key + "\" for a second time");
    }
    value_ = &place->second;
    const std::string_view text = reader.rest();
    has_value_ = !text.empty();
    if (!has_value_) {
      return;
    }
    if (text[0] == '[') {
      value_->kind = FlatYamlValue::Kind::List;
      reader.skip(1);
      in_brackets_ = true;
      readItems(reader);
    } else if (!startsScalar(text)) {
      value_->kind = FlatYamlValue::Kind::Other;
    } else {
      value_->items.push_back(reader.scalar(""));
      checkEnd(reader);
    }
  }

  /// A line that belongs to the key above it.
  void continueValue(ScalarReader reader, bool is_item) {
    if (value_ == nullptr) {
      throw std::invalid_argument("no \"key: value\"");
    }
    if (is_item && !has_value_ && value_->kind != FlatYamlValue::Kind::Other) {
      value_->kind = FlatYamlValue::Kind::List;
      reader.skip(1);
      value_->items.push_back(reader.scalar(""));
      checkEnd(reader);
    } else {
      value_->kind = FlatYamlValue::Kind::Other;
    }
  }

  void readItems(ScalarReader reader) {
    while (!reader.rest().empty()) {
      if (reader.rest()[0] == ']') {
        reader.skip(1);
        checkEnd(reader);
        in_brackets_ = false;
        return;
      }
      value_->items.push_back(reader.scalar(",]"));
      if (!reader.rest().empty() && reader.rest()[0] == ',') {
        reader.skip(1);
      } else if (!reader.rest().empty() && reader.rest()[0] != ']') {
        throw std::invalid_argument("a list without a comma between two items");
      }
    }
  }

  static void checkEnd(ScalarReader& reader) {
    if (!reader.rest().empty()) {
      throw std::invalid_argument("something after the value");
    }
  }

  std::map<std::string, FlatYamlValue> values_;
  FlatYamlValue* value_ = nullptr;  ///< Of the key read last.
  bool has_value_ = false;          ///< Whether it stood on the key's own line.
  bool in_brackets_ = false;
};

bool isBinary(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\r' && c != '\n';
  });
}

}  // namespace

std::map<std::string, FlatYamlValue> parseFlatYaml(std::string_view text) {
  if (isBinary(text)) {
    throw std::invalid_argument("it holds binary data");
  }
  if (constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
      text.substr(0, byte_order_mark.size()) == byte_order_mark) {
    text.remove_prefix(byte_order_mark.size());
  }
  Parser parser;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t size = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, size);
    text.remove_prefix(std::min(size + 1, text.size()));
    if (!line.empty() && line.back() == '\r') {
      line.remove_suffix(1);
    }
    const bool starts_document = line.substr(0, 3) == "---";
    if (line == "..." || (starts_document && !parser.empty())) {
      break;
    }
    if (starts_document || (!line.empty() && line[0] == '%' && parser.empty())) {
      continue;
    }
    try {
      parser.add(line);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("line " + std::to_string(number) + " has " + error.what());
    }
  }
  return parser.finish();
}

std::string yamlScalar(const std::string& text) {
  const bool plain =
      !text.empty() && text[0] != '-' && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-' || c == '.' || c == '/';
      });
  if (plain) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted.push_back('\\');
    }
    quoted.push_back(c);
  }
  return quoted + "\"";
}

}  // namespace sbox
