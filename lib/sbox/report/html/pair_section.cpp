// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/html/pair_section.h"

#include <algorithm>

#include "sbox/core/number_text.h"
#include "sbox/report/html/html_text.h"
#include "sbox/report/html/pose_table.h"
#include "sbox/report/html/stage.h"
#include "sbox/report/overlay_layers.h"
#include "sbox/report/summary.h"
#include "sbox/report/words.h"

namespace sbox::html {
namespace {

constexpr size_t most_alternatives = 5;

const char* meaning(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accepted:
      return "The cells of both maps bear this placement out.";
    case Verdict::Ambiguous:
      return "Distinct placements explain the maps about as well, so none was taken. Compare the "
             "overlays below. A further map that overlaps both, or more of the surroundings in "
             "either, can settle it.";
    case Verdict::Rejected:
      break;
  }
  return "No placement is borne out well enough by the cells; the best that was found is shown. "
         "The maps may show different places, or have too little in common.";
}

std::string badge(const PairResult& found) {
  return std::string("<span class=\"badge ") + toString(found.verdict) + "\">" +
         toString(found.verdict) + "</span> confidence " + fixedDigits(found.confidence, 2);
}

/// Marks where conflicting wall gathers, in shares of the stage.
std::string rings(const cv::Mat& conflicting, const PlotView& stage) {
  std::string text;
  for (const cv::Point& centre : conflictCentres(conflicting)) {
    text += "<div class=\"layer ring\" data-layer=\"conflicts\" style=\"left:" +
            fixedDigits(100.0 * centre.x / stage.size.width, 3) +
            "%;top:" + fixedDigits(100.0 * centre.y / stage.size.height, 3) + "%\"></div>\n";
  }
  return text;
}

/// The stage that shows b on a under one candidate.
Section overlay(const PageData& page, const MapPair& pair, const Pose2D& pose_b_in_a, int number) {
  const StateGrid &a = page.grid(pair.a), &b = page.grid(pair.b);
  const MapMasks &mask_a = page.mask(pair.a), &mask_b = page.mask(pair.b);
  Bounds bounds;
  bounds.add(a, {});
  bounds.add(b, pose_b_in_a);
  const double scale =
      fitScale({bounds}, maskSide(page.grids.size()), std::min(a.resolution, b.resolution));
  const PlotView stage = makeView(bounds, scale);
  const OverlayLayers layers = overlayLayers(a, b, pose_b_in_a, stage, 1);
  const std::string name =
      "p" + std::to_string(pair.a) + "-" + std::to_string(pair.b) + "-" + std::to_string(number);
  Section section;
  section.style =
      maskRule(name + "-both", layers.agreeing) + maskRule(name + "-conflicts", layers.conflicting);
  section.body = stageOf(
      stage,
      placedLayer({mask_a.free_class, "free-a", "a free"}, mask_a.view, {}, stage) +
          placedLayer({mask_b.free_class, "free-b", "b free"}, mask_b.view, pose_b_in_a, stage) +
          placedLayer({mask_a.wall_class, "wall-a", "a"}, mask_a.view, {}, stage) +
          placedLayer({mask_b.wall_class, "wall-b", "b"}, mask_b.view, pose_b_in_a, stage) +
          wholeLayer({name + "-both", "wall-both", "walls"}) +
          wholeLayer({name + "-conflicts", "wall-conflict", "conflicts"}) +
          rings(layers.conflicting, stage));
  return section;
}

std::string controls(const PageData& page, const MapPair& pair) {
  const std::string &a = page.name(pair.a), &b = page.name(pair.b);
  return "<div class=\"controls\">\n<label class=\"fade\"><span class=\"swatch wall-a\"></span>" +
         escaped(a) + " <input type=\"range\" min=\"0\" max=\"100\" value=\"50\" data-fade " +
         "aria-label=\"from one map to the other\"> " + escaped(b) +
         "<span class=\"swatch wall-b\"></span></label>\n" +
         checkbox("a", "wall-a", "map a", true) + checkbox("b", "wall-b", "map b", true) +
         checkbox("free", "free-a", "free space", true) +
         checkbox("walls", "wall-both", "walls in both", true) +
         checkbox("conflicts", "wall-conflict", "wall of one in free space of the other", true) +
         zoomButtons() + "</div>\n";
}

std::string facts(const PairResult& found) {
  std::string text = "<ul>\n<li>Free in both: " + fixedDigits(found.overlap_m2, 1) + " m&sup2;; " +
                     counted(found.matched_boxes.size(), "matched box", "matched boxes") +
                     ".</li>\n";
  if (found.kalman) {
    text += "<li>The Kalman step alone gives " + poseText(*found.kalman) + ": " +
            differenceText(*found.kalman, found.pose_b_in_a) + ".</li>\n";
  }
  if (found.ceres) {
    text += "<li>Ceres alone gives " + poseText(*found.ceres) + ": " +
            differenceText(*found.ceres, found.pose_b_in_a) + ".</li>\n";
  }
  return text + "</ul>\n";
}

void addAlternatives(const PageData& page, const MapPair& pair, Section& section) {
  const std::vector<Candidate>& alternatives = pair.result.alternatives;
  const size_t shown = std::min(alternatives.size(), most_alternatives);
  if (shown == 0) {
    return;
  }
  section.body += "<h3>Other placements</h3>\n<div class=\"alternatives\">\n";
  for (size_t i = 0; i < shown; ++i) {
    const Candidate& candidate = alternatives[i];
    const Section drawn = overlay(page, pair, candidate.pose_b_in_a, static_cast<int>(i) + 1);
    section.style += drawn.style;
    section.body += "<figure>" + drawn.body + "<figcaption>" + poseText(candidate.pose_b_in_a) +
                    ", confidence " + fixedDigits(candidate.confidence, 2) +
                    "</figcaption></figure>\n";
  }
  section.body += "</div>\n";
  if (alternatives.size() > shown) {
    section.body +=
        "<p>" + std::to_string(alternatives.size() - shown) + " more are in the JSON report.</p>\n";
  }
}

}  // namespace

Section pairSection(const PageData& page, const MapPair& pair) {
  const PairResult& found = pair.result;
  Section section;
  section.body = "<section class=\"pair\" id=\"pair-" + std::to_string(pair.a) + "-" +
                 std::to_string(pair.b) + "\">\n<h2>" + escaped(page.name(pair.b)) + " in " +
                 escaped(page.name(pair.a)) + "</h2>\n<p>" + badge(found) + "</p>\n<p>" +
                 escaped(found.reason) + (found.reason.empty() ? "" : ". ") +
                 meaning(found.verdict) + "</p>\n";
  if (found.has_pose) {
    section.body += "<p>Map a is " + escaped(page.result->maps[static_cast<size_t>(pair.a)].name) +
                    ", map b is " + escaped(page.result->maps[static_cast<size_t>(pair.b)].name) +
                    ". The pose of b's frame in a's:</p>\n" +
                    poseTable(found.pose_b_in_a, found.covariance) + facts(found);
    const Section best = overlay(page, pair, found.pose_b_in_a, 0);
    section.style += best.style;
    section.body += "<div class=\"viewer\">\n" + controls(page, pair) + best.body;
    if (found.verdict != Verdict::Accepted) {
      addAlternatives(page, pair, section);
    }
    section.body += "</div>\n";
  }
  section.body += "</section>\n";
  return section;
}

std::string pairTable(const PageData& page) {
  constexpr size_t most_rows = 500;
  const std::vector<MapPair>& pairs = page.result->pairs;
  std::string text =
      "<table><thead><tr><th>a</th><th>b</th><th>verdict</th><th>confidence</th><th>x</th>"
      "<th>y</th><th>phi</th><th>reason</th></tr></thead><tbody>\n";
  for (size_t i = 0; i < std::min(pairs.size(), most_rows); ++i) {
    const MapPair& pair = pairs[i];
    const PairResult& found = pair.result;
    text += "<tr><td>" + escaped(page.name(pair.a)) + "</td><td>" + escaped(page.name(pair.b)) +
            "</td><td><span class=\"badge " + toString(found.verdict) + "\">" +
            toString(found.verdict) + "</span></td><td class=\"number\">" +
            fixedDigits(found.confidence, 2) + "</td>" +
            (found.has_pose ? poseCells(found.pose_b_in_a, found.covariance)
                            : "<td></td><td></td><td></td>") +
            "<td>" + escaped(found.reason) + "</td></tr>\n";
  }
  text += "</tbody></table>\n";
  if (pairs.size() > most_rows) {
    text += "<p>" + std::to_string(pairs.size() - most_rows) +
            " more pairs are in the JSON report.</p>\n";
  }
  return text;
}

}  // namespace sbox::html
