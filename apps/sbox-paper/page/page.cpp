// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/page/page.h"

#include <opencv2/imgcodecs.hpp>
#include <utility>
#include <vector>

#include "sbox/report/html/html_text.h"

namespace sbox::paper {
namespace {

using html::escaped;

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1c2128; --faint: #59636e;
  --rule: #d1d9e0; --panel: #f6f8fa; --good: #1a7f37; --bad: #cf222e;
  --s1: #0b63ce; --s2: #c2570c; --s3: #2a7d46; --s4: #8a3fc7; --s5: #b0217a; }
@media (prefers-color-scheme: dark) { :root { --paper: #12161c; --ink: #e6edf3;
  --faint: #9aa6b2; --rule: #333b45; --panel: #1b212a; --good: #4fc06a; --bad: #ff7b72;
  --s1: #6cb0ff; --s2: #f2a65a; --s3: #67c98a; --s4: #c79bf5; --s5: #f58ac4; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 1.5rem 1.25rem 4rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0.5rem 0 1rem; }
h2 { font-size: 1.3rem; margin: 3rem 0 0.4rem; padding-top: 0.8rem;
  border-top: 1px solid var(--rule); }
code { font: 0.86em/1.4 ui-monospace, monospace; overflow-wrap: anywhere; }
.source { color: var(--faint); margin: 0 0 0.8rem; }
.target { margin: 0.5rem 0; padding: 0.45rem 0.8rem; background: var(--panel);
  border-left: 4px solid var(--good); }
.target.missed { border-color: var(--bad); }
.target b { color: var(--good); margin-right: 0.4em; }
.target.missed b { color: var(--bad); }
figure { margin: 1.2rem 0; }
figcaption, caption { color: var(--faint); font-size: 0.9rem; text-align: left; }
caption { padding-bottom: 0.4rem; }
.scroll { overflow-x: auto; margin: 1.2rem 0; }
table { border-collapse: collapse; font-size: 0.92rem; font-variant-numeric: tabular-nums; }
th, td { padding: 0.28rem 0.75rem; border-bottom: 1px solid var(--rule); text-align: right; }
th { font-weight: 600; vertical-align: bottom; }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
details { margin: 1rem 0; } summary { cursor: pointer; color: var(--s1); }
svg { width: 100%; height: auto; font: 12px system-ui, sans-serif; }
svg text { fill: var(--ink); } svg .small { font-size: 10.5px; }
.grid { stroke: var(--rule); } .level { stroke: var(--faint); stroke-dasharray: 6 4; }
.curve { fill: none; stroke-width: 2; stroke-linejoin: round; } .band { opacity: 0.18; }
.ring { fill: none; stroke-width: 2; }
.curve.series-1, .ring.series-1 { stroke: var(--s1); }
.curve.series-2, .ring.series-2 { stroke: var(--s2); }
.curve.series-3, .ring.series-3 { stroke: var(--s3); }
.curve.series-4, .ring.series-4 { stroke: var(--s4); }
.curve.series-5, .ring.series-5 { stroke: var(--s5); }
.bar.series-1, .disc.series-1, .band.series-1 { fill: var(--s1); }
.bar.series-2, .disc.series-2, .band.series-2 { fill: var(--s2); }
.bar.series-3, .disc.series-3, .band.series-3 { fill: var(--s3); }
.bar.series-4, .disc.series-4, .band.series-4 { fill: var(--s4); }
.bar.series-5, .disc.series-5, .band.series-5 { fill: var(--s5); }
.pictures { display: grid; gap: 1rem;
  grid-template-columns: repeat(auto-fill, minmax(min(26rem, 100%), 1fr)); }
.pictures figure { margin: 0.4rem 0; }
.pictures img { width: 100%; border: 1px solid var(--rule); display: block; }
)";

std::string tableMarkup(const std::string& caption, const bench::Table& table) {
  std::string markup = "<div class=\"scroll\"><table>";
  if (!caption.empty()) {
    markup += "<caption>" + escaped(caption) + "</caption>";
  }
  markup += "\n<thead><tr>";
  for (const std::string& cell : table.header) {
    markup += "<th>" + escaped(cell) + "</th>";
  }
  markup += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    markup += "<tr>";
    for (const std::string& cell : row) {
      markup += "<td>" + escaped(cell) + "</td>";
    }
    markup += "</tr>\n";
  }
  return markup + "</tbody></table></div>\n";
}

}  // namespace

Page::Page(std::string title) : title_(std::move(title)) {}

void Page::closePictures() {
  if (in_pictures_) {
    body_ += "</div>\n";
    in_pictures_ = false;
  }
}

void Page::section(const std::string& heading, const std::string& source) {
  closePictures();
  body_ += "<h2>" + escaped(heading) + "</h2>\n";
  body_ += "<p class=\"source\"><code>" + escaped(source) + "</code></p>\n";
}

void Page::paragraph(const std::string& markup) {
  closePictures();
  body_ += "<p>" + markup + "</p>\n";
}

void Page::target(bool met, const std::string& text) {
  closePictures();
  body_ += std::string("<p class=\"target") + (met ? "" : " missed") + "\"><b>" +
           (met ? "Met" : "Missed") + "</b> " + escaped(text) + "</p>\n";
}

void Page::table(const std::string& caption, const bench::Table& table) {
  closePictures();
  body_ += tableMarkup(caption, table);
}

void Page::details(const std::string& summary, const bench::Table& table) {
  closePictures();
  body_ += "<details><summary>" + escaped(summary) + "</summary>\n" + tableMarkup("", table) +
           "</details>\n";
}

void Page::figure(const std::string& svg, const std::string& caption) {
  closePictures();
  body_ += "<figure>\n" + svg + "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

void Page::picture(const cv::Mat& image, const std::string& caption) {
  if (!in_pictures_) {
    body_ += "<div class=\"pictures\">\n";
    in_pictures_ = true;
  }
  std::vector<unsigned char> png;
  cv::imencode(".png", image, png);
  body_ += "<figure><img alt=\"" + escaped(caption) + "\" src=\"" + html::pngUri(png) +
           "\"><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string Page::html() const {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title_) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body><main>\n<h1>" +
         escaped(title_) + "</h1>\n" + body_ + (in_pictures_ ? "</div>\n" : "") +
         "</main></body>\n</html>\n";
}

}  // namespace sbox::paper
