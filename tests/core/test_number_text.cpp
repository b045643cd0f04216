// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <locale>

#include "catch.h"
#include "sbox/core/number_text.h"

using namespace sbox;

namespace {

/// While it lives, streams write numbers as Germans do: 1.234,5.
class GermanNumbers {
 public:
  GermanNumbers() : usual_(std::locale::global({std::locale::classic(), new Punctuation})) {}
  GermanNumbers(const GermanNumbers&) = delete;
  GermanNumbers& operator=(const GermanNumbers&) = delete;
  ~GermanNumbers() { std::locale::global(usual_); }

 private:
  struct Punctuation : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::locale usual_;
};

}  // namespace

TEST_CASE("numbers for people are rounded and never minus zero", "[core]") {
  CHECK(fixedDigits(-0.0004, 3) == "0.000");
  CHECK(fixedDigits(-0.0006, 3) == "-0.001");
  CHECK(fixedDigits(12.5, 0) == "13");
  CHECK(scientificDigits(0.000123456, 2) == "1.23e-04");
  CHECK(scientificDigits(-0.0, 2) == "0.00e+00");
}

TEST_CASE("numbers for programs read back as they were", "[core]") {
  for (const double value : {0.1, -1e-300, 1e22, 123456.789, 0x1.fffffffffffffp+1023}) {
    CHECK(parseNumber(numberText(value)) == value);
    CHECK(parseNumber(plainNumberText(value)) == value);
    CHECK(plainNumberText(value).find('e') == std::string::npos);
  }
  CHECK(numberText(0.05F) == "0.05");
  CHECK(parseNumber("+1.5") == 1.5);
  for (const char* text : {"", "+", "+-1", "1,5", "1.5 ", " 1.5", "0x10", "nan", "inf", "1e999"}) {
    CHECK_FALSE(parseNumber(text));
  }
}

TEST_CASE("numbers are the same text whatever the program's locale", "[core]") {
  const GermanNumbers german;
  CHECK(fixedDigits(1234.5, 2) == "1234.50");
  CHECK(scientificDigits(1234.5, 3) == "1.234e+03");
  CHECK(numberText(1234.5) == "1234.5");
  CHECK(plainNumberText(1234.5) == "1234.5");
  CHECK(parseNumber("1234.5") == 1234.5);
}
