// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One self-contained HTML page, light or dark as the reader's system is.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "sbox-bench/table.h"

namespace sbox::paper {

class Page {
 public:
  explicit Page(std::string title);

  /// Starts a section; `source` is the command that gives its numbers.
  void section(const std::string& heading, const std::string& source);
  /// Text; `markup` may hold tags, its other text must be escaped.
  void paragraph(const std::string& markup);
  /// A line that says whether a target is met.
  void target(bool met, const std::string& text);
  /// A table with a caption; cells are escaped.
  void table(const std::string& caption, const bench::Table& table);
  /// A figure from plot.h with a caption.
  void figure(const std::string& svg, const std::string& caption);
  /// A picture with a caption; several in a row share a line where there is room.
  void picture(const cv::Mat& image, const std::string& caption);
  /// Text that opens on a click, for details.
  void details(const std::string& summary, const bench::Table& table);

  [[nodiscard]] std::string html() const;

 private:
  void closePictures();

  std::string title_;
  std::string body_;
  bool in_pictures_ = false;
};

}  // namespace sbox::paper
