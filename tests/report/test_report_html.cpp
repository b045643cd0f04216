// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <regex>
#include <set>

#include "catch.h"
#include "report/html_result.h"
#include "sbox/report/html/html_text.h"
#include "sbox/report/html/mask_png.h"
#include "sbox/report/html/stage.h"
#include "sbox/report/report_html.h"

using namespace sbox;
using namespace sbox::test;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

std::string page(const HtmlCase& made, int threads = 1) {
  return reportHtml(made.maps, made.result, {"merged.yaml"}, threads);
}

/// The page without its style and its script, which are no markup.
std::string markup(std::string text) {
  for (const char* tag : {"style", "script"}) {
    const std::string open = std::string("<") + tag + ">", close = std::string("</") + tag + ">";
    for (size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
      text.erase(at, text.find(close, at) + close.size() - at);
    }
  }
  return text;
}

/// The first tag that is closed out of turn or not at all; empty if all are closed.
std::string unbalancedTag(const std::string& text) {
  const std::set<std::string> void_tags{"meta", "input"};
  const std::regex tag("<(/?)([a-zA-Z0-9]+)(?:\\s[^<>]*?)?(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    const std::string name = (*it)[2];
    if (void_tags.count(name) == 1 || (*it)[3] == "/") {
      continue;
    }
    if ((*it)[1] != "/") {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return name;
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

}  // namespace

TEST_CASE("a page says in words what became of each map and each pair") {
  const std::string text = page(htmlCase());
  CHECK(contains(text, "<title>2 of 3 maps merged</title>"));
  for (const char* words :
       {"the walls agree", "three corners of the room look alike", "nothing in common",
        "Distinct placements explain the maps about as well", "maps/third.gridmap",
        "confidence 0.97", "6.000 &plusmn; 0.020 m", "90.00 &plusmn; 1.15 &deg;",
        "0.050 m and 0.00&deg; apart", "1.2 % are wall in one and free in another",
        "Merged map: merged.yaml", "2 vertical points", "1 suppositional box"}) {
    INFO(words);
    CHECK(contains(text, words));
  }
}

TEST_CASE("a page shows each map's best pair, and each placement of an ambiguous one") {
  const std::string text = page(htmlCase());
  CHECK(contains(text, "id=\"pair-0-1\""));
  CHECK(contains(text, "id=\"pair-0-2\""));
  CHECK_FALSE(contains(text, "id=\"pair-1-2\""));
  // Merged map, two pairs, two alternatives, three maps with features.
  CHECK(count(text, "class=\"stage\"") == 8);
  CHECK(count(text, "<figcaption>") == 2);
  CHECK(contains(text, "<figcaption>x 4.000 m, y 2.000 m, phi 0.00 deg, confidence 0.20"));
}

TEST_CASE("a page closes all its tags and takes nothing from elsewhere") {
  const std::string text = page(htmlCase());
  CHECK(unbalancedTag(markup(text)).empty());
  for (const char* foreign : {"http:", "https:", "@import", "<link", "src=", "url(\"", "url(/"}) {
    INFO(foreign);
    CHECK_FALSE(contains(text, foreign));
  }
  CHECK(count(text, "url(") == count(text, "url(data:image/png;base64,"));
}

TEST_CASE("a page is the same bytes on any number of threads, whatever the time taken") {
  HtmlCase made = htmlCase();
  const std::string once = page(made, 1);
  made.result.seconds.total = 12;
  CHECK(page(made, 3) == once);
}

TEST_CASE("hostile names and reasons are text on a page") {
  HtmlCase made = htmlCase("<script>alert(1)</script>/\"'&\xff\x01.yaml");
  made.result.pairs[0].result.reason = "</section><img src=x>";
  const std::string text = page(made);
  CHECK_FALSE(contains(text, "<script>alert"));
  CHECK_FALSE(contains(text, "<img"));
  CHECK(contains(text, "&lt;script&gt;alert(1)&lt;/script&gt;/&quot;&#39;&amp;\xEF\xBF\xBD?.yaml"));
  CHECK(unbalancedTag(markup(text)).empty());
}

TEST_CASE("a page can be made of maps without any known cell and without any pose") {
  HtmlCase made = htmlCase();
  made.maps[2] = makeMap("blank", 5, 5, 0.1);
  made.result.merged.clear();
  made.result.pairs = {{0, 2, {}}};
  const std::string text = reportHtml(made.maps, made.result, {});
  CHECK(unbalancedTag(markup(text)).empty());
  CHECK(count(text, "class=\"stage\"") == 3);
}

TEST_CASE("a layer lies on its stage where its map lies") {
  // The stage shows 20 m x 10 m from (-5, 0); the part 4 m x 2 m from (1, 1) of a map that is
  // turned left about (7, 3): its lower-left corner comes to lie at (6, 4).
  const PlotView stage{{-5, 0}, 10, {200, 100}}, part{{1, 1}, 20, {80, 40}};
  const std::string text =
      html::placedLayer({"mask", "colour", "name"}, part, {7, 3, M_PI / 2}, stage);
  CHECK(contains(text, "left:55.0000%;bottom:40.0000%;width:20.0000%;height:20.0000%;"));
  CHECK(contains(text, "transform:rotate(-90.0000deg)"));
}

TEST_CASE("base64 of any length") {
  const auto coded = [](const std::string& text) {
    return html::pngUri({text.begin(), text.end()}).substr(22);
  };
  CHECK(coded("").empty());
  CHECK(coded("f") == "Zg==");
  CHECK(coded("fo") == "Zm8=");
  CHECK(coded("foo") == "Zm9v");
  CHECK(coded("\xff\xfe\xfd\xfc") == "//79/A==");
}

TEST_CASE("a mask is a picture of one bit a pixel whose black is transparent") {
  cv::Mat mask(3, 19, CV_8U, cv::Scalar(0));
  mask.at<unsigned char>(0, 0) = 255;
  mask.at<unsigned char>(2, 17) = 1;
  const std::vector<unsigned char> png = html::maskPng(mask);
  const cv::Mat read = cv::imdecode(png, cv::IMREAD_GRAYSCALE);
  REQUIRE(read.size() == mask.size());
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      CHECK(read.at<unsigned char>(y, x) == (mask.at<unsigned char>(y, x) != 0 ? 255 : 0));
    }
  }
  // OpenCV does not read transparency of greys; browsers do.
  const std::string bytes(png.begin(), png.end());
  const int bit_depth = bytes[24], colour_type = bytes[25];
  CHECK(bit_depth == 1);
  CHECK(colour_type == 0);
  CHECK(bytes.substr(33, 10) == std::string("\0\0\0\2tRNS\0\0", 10));
}
