// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox-paper/page/page.h"
#include "sbox-paper/page/plot.h"

using namespace sbox::paper;

TEST_CASE("a page escapes what it is given and refers to nothing outside", "[page]") {
  Page page("A < B");
  page.section("Part & parcel", "sbox-paper --only rooms");
  page.table("caption", {{"a", "b"}, {{"<i>", "2"}}});
  page.target(false, "at most 2 %");
  page.picture(cv::Mat(4, 4, CV_8UC3, cv::Scalar(1, 2, 3)), "four pixels");
  const std::string html = page.html();
  CHECK(html.find("A &lt; B") != std::string::npos);
  CHECK(html.find("<td>&lt;i&gt;</td>") != std::string::npos);
  CHECK(html.find("target missed") != std::string::npos);
  CHECK(html.find("data:image/png;base64,") != std::string::npos);
  CHECK(html.find("http") == std::string::npos);
}

TEST_CASE("a plot puts marks where the axes say, and those beyond on the border", "[page]") {
  Plot plot({"x", 0, 10, 5, 0}, {"y", 0, 1, 0.5, 1});
  plot.addPoints("p", 1, {{0, 0}, {10, 1}, {10, 7}});
  const std::string svg = plot.svg("title");
  CHECK(svg.find("cx=\"62.0\" cy=\"272.0\"") != std::string::npos);
  const size_t top = svg.find("cx=\"704.0\" cy=\"34.0\"");
  REQUIRE(top != std::string::npos);
  CHECK(svg.find("cx=\"704.0\" cy=\"34.0\"", top + 1) != std::string::npos);
}
