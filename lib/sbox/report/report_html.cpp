// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/report_html.h"

#include <functional>

#include "sbox/core/parallel.h"
#include "sbox/report/html/html_text.h"
#include "sbox/report/html/map_sections.h"
#include "sbox/report/html/page_assets.h"
#include "sbox/report/html/page_data.h"
#include "sbox/report/html/pair_section.h"
#include "sbox/report/pairs_to_show.h"
#include "sbox/report/short_names.h"
#include "sbox/report/summary.h"

namespace sbox {
namespace {

using namespace html;

PageData pageData(const std::vector<Map>& maps, const MergeResult& result, int threads) {
  PageData page;
  page.result = &result;
  page.grids.resize(maps.size());
  page.masks.resize(maps.size());
  parallelFor(static_cast<int>(maps.size()), threads, [&](int i) {
    const auto index = static_cast<size_t>(i);
    page.grids[index] = classifyCells(maps[index]);
    page.masks[index] = maskMap(page.grids[index], "m" + std::to_string(i), maskSide(maps.size()));
  });
  page.names = shortNames(result);
  return page;
}

/// The parts of the page in their order, still to be made.
std::vector<std::function<Section()>> planSections(const PageData& page,
                                                   const std::vector<std::string>& merged_files) {
  std::vector<std::function<Section()>> plans;
  const MergeResult& result = *page.result;
  for (size_t i = 0; i < result.merged.size(); ++i) {
    const std::string file = i < merged_files.size() ? merged_files[i] : "";
    plans.emplace_back([&, i, file] { return mergedSection(page, result.merged[i], file); });
  }
  for (const MapPair* pair : pairsToShow(result)) {
    plans.emplace_back([&, pair] { return pairSection(page, *pair); });
  }
  for (size_t i = 0; i < page.names.size(); ++i) {
    plans.emplace_back([&, i] { return featuresSection(page, static_cast<int>(i)); });
  }
  return plans;
}

std::string headline(const MergeResult& result) {
  size_t placed = 0;
  for (const MapOutcome& map : result.maps) {
    placed += map.placed ? 1 : 0;
  }
  return std::to_string(placed) + " of " + std::to_string(result.maps.size()) + " maps merged";
}

std::string statusClass(MergeStatus status) {
  return status == MergeStatus::Merged ? "merged-all" : toString(status);
}

std::string opening(const PageData& page, const std::vector<std::string>& merged_files) {
  const MergeResult& result = *page.result;
  std::string text = "<button type=\"button\" id=\"theme\" hidden>light / dark</button>\n<h1>" +
                     headline(result) + " <span class=\"badge " + statusClass(result.status) +
                     "\">" + toString(result.status) + "</span></h1>\n";
  for (const std::string& line : summaryLines(result, merged_files)) {
    text += "<p>" + escaped(line) + "</p>\n";
  }
  text +=
      "<section id=\"maps\">\n<h2>Where each map lies</h2>\n<p>The pose of each map's frame in " +
      std::string("the frame of its group's reference, with one standard deviation.</p>\n") +
      "<div class=\"table\">" + placementTable(page) + "</div>\n</section>\n";
  if (result.pairs.size() > 1) {
    text += "<section id=\"pairs\">\n<h2>All pairs</h2>\n<p>The pose of b's frame in a's.</p>\n" +
            std::string("<div class=\"table\">") + pairTable(page) + "</div>\n</section>\n";
  }
  return text;
}

/// Nothing may be fetched: what the page shows is in it.
constexpr const char* security_policy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

}  // namespace

std::string reportHtml(const std::vector<Map>& maps, const MergeResult& result,
                       const std::vector<std::string>& merged_files, int threads,
                       const ProgressFunction& progress) {
  const PageData page = pageData(maps, result, threads);
  const auto plans = planSections(page, merged_files);
  std::vector<Section> sections(plans.size());
  StageProgress page_progress(progress, "report sections", static_cast<int>(plans.size()));
  parallelFor(static_cast<int>(plans.size()), threads, [&](int i) {
    page_progress.partBegins();
    sections[static_cast<size_t>(i)] = plans[static_cast<size_t>(i)]();
    page_progress.partDone();
  });

  std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" +
                     std::string("<meta http-equiv=\"Content-Security-Policy\" content=\"") +
                     security_policy + "\">\n<meta name=\"viewport\" " +
                     "content=\"width=device-width, initial-scale=1\">\n<title>" +
                     headline(result) + "</title>\n<style>" + pageStyle();
  for (const MapMasks& masks : page.masks) {
    text += masks.style;
  }
  for (const Section& section : sections) {
    text += section.style;
  }
  text += std::string("</style>\n<script>") + pageScript() +
          "</script>\n<noscript><style>.controls{display:none}</style></noscript>\n</head>\n" +
          "<body>\n" + opening(page, merged_files);
  for (const Section& section : sections) {
    text += section.body;
  }
  text += "<footer>Drag to move; Ctrl and the wheel, or the buttons, to enlarge.</footer>\n" +
          std::string("</body>\n</html>\n");
  return text;
}

}  // namespace sbox
