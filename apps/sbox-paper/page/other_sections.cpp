// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>

#include "sbox-bench/statistics.h"
#include "sbox-paper/page/plot.h"
#include "sbox-paper/page/sections.h"
#include "sbox/report/html/html_text.h"
#include "sbox/report/overlay_picture.h"

namespace sbox::paper {
namespace {

using bench::formatNumber;
using bench::Table;

std::string ofTotal(int count, int total) {
  return std::to_string(count) + " / " + std::to_string(total);
}

std::string rightText(const std::optional<bool>& right) {
  return right ? (*right ? "right" : "wrong") : "-";
}

cv::Mat overlayOf(const Map& a, const Map& b, const PairResult& answer, const std::string& title) {
  return drawOverlay(classifyCells(a), classifyCells(b), answer.pose_b_in_a, title, a.name, b.name);
}

/// Whether the verdict is what one hopes for.
bool goodAnswer(const PlaceAnswer& place) {
  const bool accepted = place.answer.verdict == Verdict::Accepted;
  return place.decidable ? accepted && place.right.value_or(false) : !accepted;
}

}  // namespace

void addPlacesSection(Page& page, const std::vector<PlaceAnswer>& answers,
                      const std::string& source) {
  page.section("Rooms, a long corridor, and places the paper does not try (figure 13)", source);
  page.paragraph(
      "The paper shows one pair of maps with rooms and one of a long corridor with many like "
      "boxes, "
      "both merged. Ours: <code>rooms</code>, <code>corridor</code> (twelve like rooms, told apart "
      "by "
      "furniture and niches), <code>angled</code> (walls in many directions), each with several "
      "pairs of "
      "simulated robots mapped by ICP-SLAM, then the shipped maps. In <code>symmetric</code> "
      "nobody can tell how two maps fit: the right "
      "answer is \u201cambiguous\u201d, and accepting is an error even where it happens to be "
      "true. Right means "
      "within 0.3 m and 2 degrees of the truth for simulated pairs, and the benchmark's rule for "
      "files.");
  Table table;
  table.header = {"place",    "seed",       "overlap", "ours", "pose",
                  "error, m", "confidence", "paper",   "pose"};
  int good = 0;
  for (const PlaceAnswer& place : answers) {
    good += goodAnswer(place) ? 1 : 0;
    table.rows.push_back({place.place + (place.real ? " (real)" : ""),
                          place.seed == 0 ? "-" : std::to_string(place.seed),
                          place.overlap > 0 ? formatNumber(100 * place.overlap, 0) + " %" : "-",
                          toString(place.answer.verdict), rightText(place.right),
                          place.right ? formatNumber(place.excess, 2) : "-",
                          formatNumber(place.answer.confidence, 2), toString(place.paper.verdict),
                          rightText(place.paper_right)});
  }
  page.target(good == static_cast<int>(answers.size()),
              ofTotal(good, static_cast<int>(answers.size())) +
                  " as they should be: merged rightly, or refused where nobody can tell.");
  page.table("Every pair", table);
  std::map<std::string, int> shown;
  for (const PlaceAnswer& place : answers) {
    const bool first = shown[place.place]++ == 0;
    if (place.answer.has_pose && (first || !goodAnswer(place))) {
      page.picture(overlayOf(place.map_a, place.map_b, place.answer, place.place),
                   place.place + (place.seed > 0 ? ", seed " + std::to_string(place.seed) : "") +
                       ": " + toString(place.answer.verdict) + ", " + rightText(place.right) +
                       ". " + place.answer.reason);
    }
  }
}

void addMatchesSection(Page& page, const std::vector<PairMatches>& pairs, const std::string& data,
                       const std::string& source) {
  page.section("Right matches against image keypoints (figure 15)", source);
  page.paragraph(
      "Maps: " + html::escaped(data) +
      ". A match is right if the true transform brings its two points within half a metre plus "
      "the pair's own rigid residual: drifted maps part by so much under the best "
      "transform. Boxes count four corners each, as in the paper; keypoints count if each "
      "is the other's nearest by descriptor, before any RANSAC. The paper counts 68 and 60 right "
      "corners on "
      "one E5 and one F5 pair, far above ORB and SURF, without saying which pairs. SURF is "
      "patented and not in Debian's OpenCV; SIFT stands in for it. Neighbouring boxes share "
      "corners, so the counts are not of independent evidence.");
  struct Kind {
    const char* name;
    MatchCount PairMatches::*count;
  };
  constexpr Kind kKinds[] = {{"boxes", &PairMatches::boxes},
                             {"paper", &PairMatches::paper},
                             {"ORB", &PairMatches::orb},
                             {"SIFT", &PairMatches::sift}};
  std::map<std::string, std::vector<const PairMatches*>> groups;
  for (const PairMatches& pair : pairs) {
    groups[pair.group].push_back(&pair);
  }
  Table table;
  table.header = {"maps", "pairs"};
  std::vector<std::string> series;
  for (const Kind& kind : kKinds) {
    table.header.push_back(std::string(kind.name) + ": right of matched");
    series.emplace_back(kind.name);
  }
  std::vector<BarGroup> bars;
  double top = 80;
  for (const auto& [name, members] : groups) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row = {name, std::to_string(members.size())};
    BarGroup& group = bars.emplace_back();
    group.label = name;
    for (const Kind& kind : kKinds) {
      std::vector<double> right, all;
      for (const PairMatches* pair : members) {
        right.push_back((pair->*kind.count).right);
        all.push_back((pair->*kind.count).matches);
      }
      row.push_back(formatNumber(bench::median(right), 0) + " of " +
                    formatNumber(bench::median(all), 0));
      group.values.push_back(bench::median(right));
      group.texts.push_back(formatNumber(bench::median(right), 0));
      top = std::max(top, bench::median(right));
    }
  }
  page.table("Medians over the pairs of each place", table);
  page.figure(barsSvg("Right matches", "right matches, median", 1.1 * top, series, bars),
              "Figure 15: right matches of each kind.");
}

void addSuccessSection(Page& page, const SuccessTable& table, const std::string& data,
                       const std::string& source) {
  page.section("Success rates (Table 3)", source);
  page.paragraph(
      "Maps: " + html::escaped(data) +
      ". The paper tries four E5, three F5 and two apartment pairs, without saying which; we take "
      "every annotated pair. Paper's rates: boxes 75 %, 66.7 % and 50 %; ORB 25 %, 0 and 0; "
      "SURF 25 %, 25 % and 0; Hough spectrum 25 % and 25 %. Right: accepted, rotation within 5 "
      "degrees, and the annotated points at most 0.75 m (15 cells) RMS above what the best "
      "rigid transform leaves. ORB, SIFT and the Hough spectrum accept every answer of theirs, so "
      "what is not right is wrong.");
  Table rates;
  rates.header = {"maps", "pairs"};
  for (const std::string& method : table.methods) {
    rates.header.push_back(method);
  }
  std::vector<BarGroup> groups;
  for (const SuccessRow& row : table.rows) {
    if (row.counts.front().pairs == 0) {
      continue;
    }
    std::vector<std::string>& cells = rates.rows.emplace_back();
    cells = {row.group, std::to_string(row.counts.front().pairs)};
    BarGroup& group = groups.emplace_back();
    group.label = row.group;
    for (const SuccessCount& count : row.counts) {
      const double rate = 100.0 * count.right / std::max(1, count.pairs);
      cells.push_back(formatNumber(rate, 1) + " % (" + std::to_string(count.wrong) + " wrong, " +
                      std::to_string(count.refused) + " refused)");
      group.values.push_back(rate);
      group.texts.push_back(formatNumber(rate, 0));
    }
  }
  page.table("Share of pairs merged rightly", rates);
  page.figure(barsSvg("Success rates", "merged rightly, %", 100, table.methods, groups),
              "Table 3 as bars: E5 and F5 are large, HIH and KPT4A small.");
}

void addOfficesSection(Page& page, const OfficesResult& offices, const std::string& source) {
  page.section("Random offices", source);
  const auto runs = static_cast<int>(offices.runs.size());
  const auto different = static_cast<int>(offices.different.size());
  page.paragraph(
      "Not in the paper. In each random office two robots visit 55 to 85 % of the rooms, one from "
      "the left, "
      "one from the right, and are mapped by ICP-SLAM, each from a heading of its own. Then maps "
      "of "
      "different offices are offered as if they belonged together. Right: within 0.3 m RMS over "
      "the best "
      "rigid fit and 2 degrees.");
  page.target(offices.accepted(0, true) * 100 >= 97 * runs && offices.accepted(0, false) == 0,
              "At least 97 of 100 runs right, none wrong accepted: " +
                  ofTotal(offices.accepted(0, true), runs) + " right, " +
                  std::to_string(offices.accepted(0, false)) + " wrong.");
  page.target(offices.differentAccepted(0) == 0,
              "No pair from different offices accepted: " +
                  ofTotal(offices.differentAccepted(0), different) + " accepted.");
  Table table;
  table.header = {"method", "right", "wrong accepted", "refused", "different offices accepted"};
  for (size_t m = 0; m < offices.methods.size(); ++m) {
    const int right = offices.accepted(m, true), wrong = offices.accepted(m, false);
    table.rows.push_back({offices.methods[m], ofTotal(right, runs), std::to_string(wrong),
                          std::to_string(runs - right - wrong),
                          ofTotal(offices.differentAccepted(m), different)});
  }
  page.table("Two robots in one office, and maps of two offices", table);

  Plot plot({"overlap, % of the smaller map's known area", 0, 100, 10, 0},
            {"error over the rigid floor, m", 0, 0.5, 0.1, 1});
  std::vector<std::pair<double, double>> right, wrong, refused;
  Table details;
  details.header = {"office",   "run",     "overlap",    "rigid floor, m", "verdict",
                    "error, m", "degrees", "confidence", "double walls",   "reason"};
  std::vector<double> doubles;
  for (const OfficeRun& run : offices.runs) {
    const OfficeAnswer& answer = run.answers.front();
    const double overlap = run.robots.truth ? run.robots.truth->overlap : 0;
    const std::pair<double, double> point(100 * overlap,
                                          answer.result.has_pose ? answer.error.excess : 1.0);
    (!answer.accepted() ? refused : answer.error.right ? right : wrong).push_back(point);
    if (answer.accepted() && answer.error.right) {
      doubles.push_back(run.not_coinciding);
    }
    details.rows.push_back(
        {std::to_string(run.office), std::to_string(run.run), formatNumber(100 * overlap, 0) + " %",
         run.robots.truth ? formatNumber(run.robots.truth->rms, 3) : "-",
         toString(answer.result.verdict), formatNumber(answer.error.excess, 3),
         formatNumber(answer.error.rotation_deg, 2), formatNumber(answer.result.confidence, 2),
         formatNumber(100 * run.not_coinciding, 1) + " %", answer.result.reason});
  }
  plot.addPoints("accepted, right", 1, right);
  plot.addPoints("accepted, wrong", 2, wrong);
  plot.addPoints("refused", 4, refused, false);
  page.figure(
      plot.svg("Error over overlap"),
      "Every run by the default method; errors above 0.5 m lie on the upper border. Walls that lie "
      "double in the rightly merged maps: " +
          formatNumber(100 * bench::median(doubles), 1) +
          " % of the edges' length in the median, " +
          formatNumber(100 * bench::maximum(doubles), 1) + " % at most.");
  int pictures = 0;
  for (const OfficeRun& run : offices.runs) {
    const OfficeAnswer& answer = run.answers.front();
    if (answer.result.has_pose && !(answer.accepted() && answer.error.right) && pictures++ < 6) {
      page.picture(
          overlayOf(run.robots.maps[0], run.robots.maps[1], answer.result, run.robots.name),
          run.robots.name + ": " + toString(answer.result.verdict) + ", pose " +
              (answer.error.right ? "right" : "wrong") + ". " + answer.result.reason);
    }
  }
  page.details("Every run", details);
}

}  // namespace sbox::paper
