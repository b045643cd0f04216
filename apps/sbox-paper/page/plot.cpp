// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/page/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sbox-bench/table.h"
#include "sbox/report/html/html_text.h"

namespace sbox::paper {
namespace {

constexpr double kWidth = 720, kHeight = 320;
constexpr double kLeft = 62, kRight = 16, kTop = 34, kBottom = 48;

std::string number(double value) { return bench::formatNumber(value, 1); }

std::string text(double x, double y, const char* anchor, const std::string& content,
                 const char* css = "") {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\"" +
         css + ">" + html::escaped(content) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& css) {
  return "<line class=\"" + css + "\" x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" +
         number(x2) + "\" y2=\"" + number(y2) + "\"/>\n";
}

std::string open(const std::string& title) {
  return "<svg viewBox=\"0 0 " + number(kWidth) + " " + number(kHeight) + "\" role=\"img\" " +
         "aria-label=\"" + html::escaped(title) + "\">\n";
}

std::string seriesClass(const char* kind, int series) {
  return std::string(kind) + " series-" + std::to_string(series);
}

}  // namespace

Plot::Plot(Axis x, Axis y) : x_(std::move(x)), y_(std::move(y)), legend_at_(kLeft) {}

double Plot::px(double x) const {
  const double share = std::clamp((x - x_.from) / (x_.to - x_.from), 0.0, 1.0);
  return kLeft + share * (kWidth - kLeft - kRight);
}

double Plot::py(double y) const {
  const double share = std::clamp((y - y_.from) / (y_.to - y_.from), 0.0, 1.0);
  return kHeight - kBottom - share * (kHeight - kTop - kBottom);
}

void Plot::addLegend(const std::string& name, int series, const char* mark) {
  if (name.empty()) {
    return;
  }
  const double y = 16;
  if (std::string(mark) == "line") {
    legend_ += line(legend_at_, y - 4, legend_at_ + 18, y - 4, seriesClass("curve", series));
  } else if (std::string(mark) == "level") {
    legend_ += line(legend_at_, y - 4, legend_at_ + 18, y - 4, "level");
  } else {
    legend_ += "<circle class=\"" + seriesClass(mark, series) + "\" cx=\"" +
               number(legend_at_ + 9) + "\" cy=\"" + number(y - 4) + "\" r=\"4\"/>\n";
  }
  legend_ += text(legend_at_ + 24, y, "start", name);
  legend_at_ += 24 + 7.0 * static_cast<double>(name.size()) + 18;
}

void Plot::addLine(const std::string& name, int series,
                   const std::vector<std::pair<double, double>>& points) {
  addLegend(name, series, "line");
  marks_ += "<polyline class=\"" + seriesClass("curve", series) + "\" points=\"";
  for (const auto& [x, y] : points) {
    marks_ += number(px(x)) + "," + number(py(y)) + " ";
  }
  marks_ += "\"/>\n";
}

void Plot::addPoints(const std::string& name, int series,
                     const std::vector<std::pair<double, double>>& points, bool filled) {
  const char* mark = filled ? "disc" : "ring";
  addLegend(name, series, mark);
  for (const auto& [x, y] : points) {
    marks_ += "<circle class=\"" + seriesClass(mark, series) + "\" cx=\"" + number(px(x)) +
              "\" cy=\"" + number(py(y)) + "\" r=\"4\"/>\n";
  }
}

void Plot::addLevel(const std::string& name, double y) {
  addLegend(name, 0, "level");
  marks_ += line(kLeft, py(y), kWidth - kRight, py(y), "level");
}

void Plot::addBand(int series, const std::vector<double>& x, const std::vector<double>& low,
                   const std::vector<double>& high) {
  marks_ += "<polygon class=\"" + seriesClass("band", series) + "\" points=\"";
  for (size_t i = 0; i < x.size(); ++i) {
    marks_ += number(px(x[i])) + "," + number(py(low[i])) + " ";
  }
  for (size_t i = x.size(); i-- > 0;) {
    marks_ += number(px(x[i])) + "," + number(py(high[i])) + " ";
  }
  marks_ += "\"/>\n";
}

std::string Plot::svg(const std::string& title) const {
  std::string result = open(title);
  for (int i = 0; y_.from + i * y_.tick <= y_.to + 1e-9; ++i) {
    const double y = y_.from + i * y_.tick;
    result += line(kLeft, py(y), kWidth - kRight, py(y), "grid");
    result += text(kLeft - 8, py(y) + 4, "end", bench::formatNumber(y, y_.digits));
  }
  for (int i = 0; x_.from + i * x_.tick <= x_.to + 1e-9; ++i) {
    const double x = x_.from + i * x_.tick;
    result += text(px(x), kHeight - kBottom + 18, "middle", bench::formatNumber(x, x_.digits));
  }
  result += text((kLeft + kWidth - kRight) / 2, kHeight - 8, "middle", x_.label);
  const double middle = (kTop + kHeight - kBottom) / 2;
  const std::string turn = " transform=\"rotate(-90 14 " + number(middle) + ")\"";
  result += text(14, middle, "middle", y_.label, turn.c_str());
  return result + marks_ + legend_ + "</svg>\n";
}

std::string barsSvg(const std::string& title, const std::string& y_label, double top,
                    const std::vector<std::string>& series, const std::vector<BarGroup>& groups) {
  std::string result = open(title);
  const double height = kHeight - kTop - kBottom, floor = kHeight - kBottom;
  for (int i = 0; i <= 4; ++i) {
    const double y = floor - height * i / 4;
    result += line(kLeft, y, kWidth - kRight, y, "grid");
    result += text(kLeft - 8, y + 4, "end", bench::formatNumber(top * i / 4, top < 4 ? 1 : 0));
  }
  const double middle = (kTop + floor) / 2;
  const std::string turn = " transform=\"rotate(-90 14 " + number(middle) + ")\"";
  result += text(14, middle, "middle", y_label, turn.c_str());
  const double slot = (kWidth - kLeft - kRight) / static_cast<double>(groups.size());
  const double bar = std::min(34.0, slot * 0.84 / static_cast<double>(series.size()));
  for (size_t g = 0; g < groups.size(); ++g) {
    const double centre = kLeft + slot * (static_cast<double>(g) + 0.5);
    result += text(centre, floor + 18, "middle", groups[g].label);
    for (size_t s = 0; s < series.size(); ++s) {
      const double x =
          centre + bar * (static_cast<double>(s) - static_cast<double>(series.size()) / 2);
      const double tall = height * std::clamp(groups[g].values[s] / top, 0.0, 1.0);
      result += "<rect class=\"" + seriesClass("bar", static_cast<int>(s) + 1) + "\" x=\"" +
                number(x + 1) + "\" y=\"" + number(floor - tall) + "\" width=\"" + number(bar - 2) +
                "\" height=\"" + number(tall) + "\"/>\n";
      result +=
          text(x + bar / 2, floor - tall - 4, "middle", groups[g].texts[s], " class=\"small\"");
    }
  }
  double at = kLeft;
  for (size_t s = 0; s < series.size(); ++s) {
    result += "<rect class=\"" + seriesClass("bar", static_cast<int>(s) + 1) + "\" x=\"" +
              number(at) + "\" y=\"6\" width=\"12\" height=\"12\"/>\n";
    result += text(at + 17, 16, "start", series[s]);
    at += 17 + 7.0 * static_cast<double>(series[s].size()) + 18;
  }
  return result + "</svg>\n";
}

}  // namespace sbox::paper
