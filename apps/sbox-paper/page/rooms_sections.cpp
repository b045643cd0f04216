// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "sbox-paper/answers.h"
#include "sbox-paper/page/plot.h"
#include "sbox-paper/page/sections.h"
#include "sbox/report/overlay_picture.h"

namespace sbox::paper {
namespace {

using bench::formatNumber;
using bench::Table;

std::string percent(double share, int digits = 1) {
  return formatNumber(100 * share, digits) + " %";
}

std::string nameOf(const RoomsPair& pair) {
  return (pair.slam == Slam::Rbpf ? "RBPF-SLAM, seed " : "ICP-SLAM, seed ") +
         std::to_string(pair.seed);
}

std::string lengthText(const std::optional<double>& length) {
  return length ? formatNumber(*length, 2) : "-";
}

std::string errorText(const std::optional<double>& error) {
  return error ? percent(*error, 2) : "-";
}

/// The share under the transform of this name, none if there is no such transform.
std::optional<double> shareOf(const RoomsPair& pair, const std::string& name) {
  for (const NamedCoincidence& entry : pair.coincidences) {
    if (entry.name == name && entry.coincidence) {
      return entry.coincidence->share();
    }
  }
  return std::nullopt;
}

Table lengthTable(const RoomsPair& pair) {
  Table table;
  table.header = {"wall", "true"};
  for (const TurnedLengths& turned : pair.right_angles) {
    const std::string angle = formatNumber(turned.angle_deg, 0) + "\u00b0 ";
    table.header.insert(table.header.end(), {angle + "map 1", angle + "map 2", angle + "merged"});
  }
  for (size_t i = 0; i < pair.right_angles.front().walls.size(); ++i) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row = {std::to_string(i + 1), formatNumber(pair.right_angles.front().walls[i].truth, 2)};
    for (const TurnedLengths& turned : pair.right_angles) {
      const WallLengths& wall = turned.walls[i];
      row.insert(row.end(),
                 {lengthText(wall.map_1), lengthText(wall.map_2), lengthText(wall.merged)});
    }
  }
  std::vector<std::string>& mean = table.rows.emplace_back();
  mean = {"mean error", ""};
  for (const TurnedLengths& turned : pair.right_angles) {
    for (const auto map : {&WallLengths::map_1, &WallLengths::map_2, &WallLengths::merged}) {
      mean.push_back(errorText(meanError(turned.walls, map)));
    }
  }
  return table;
}

struct ErrorSummary {
  double mean = 0;
  double worst = 0;
  int missing = 0;  ///< Angles at which the maps were not merged or a wall was lost.
  int angles = 0;
};

ErrorSummary summarise(const RoomsPair& pair) {
  ErrorSummary summary;
  int counted = 0;
  for (const auto* list : {&pair.right_angles, &pair.random_angles}) {
    for (const TurnedLengths& turned : *list) {
      ++summary.angles;
      const auto error = meanError(turned.walls, &WallLengths::merged);
      if (!error) {
        ++summary.missing;
        continue;
      }
      ++counted;
      summary.mean += *error;
      summary.worst = std::max(summary.worst, *error);
    }
  }
  summary.mean = counted > 0 ? summary.mean / counted : std::numeric_limits<double>::quiet_NaN();
  return summary;
}

std::string angleCurves(const RoomsPair& pair) {
  Plot plot({"rotation of map 2, degrees", 0, 360, 45, 0}, {"mean length error, %", 0, 6, 1, 0});
  plot.addLevel("paper, merged: 4 to 5 %", 4);
  plot.addLevel("", 5);
  const auto curve = [&](const std::string& name, int series,
                         std::optional<double> WallLengths::*map) {
    std::vector<std::pair<double, double>> points;
    for (const TurnedLengths& turned : pair.random_angles) {
      if (const auto error = meanError(turned.walls, map)) {
        points.emplace_back(turned.angle_deg, 100 * *error);
      }
    }
    plot.addLine(name, series, points);
    if (series == 1) {
      plot.addPoints("", series, points);
    }
  };
  curve("map 1", 2, &WallLengths::map_1);
  curve("map 2", 3, &WallLengths::map_2);
  curve("merged", 1, &WallLengths::merged);
  return plot.svg("Mean error of wall lengths over the rotation of map 2");
}

}  // namespace

void addCoincidenceSection(Page& page, const std::vector<RoomsPair>& pairs,
                           const std::string& source) {
  page.section("Double walls (figure 8)", source);
  page.paragraph(
      "Two simulated robots map <code>rooms.world</code>. Along each wall edge that both maps "
      "show, "
      "each 0.05 m, we look where either map has its wall; where the two lie more than 0.1 m (two "
      "cells) apart, the merged map shows the wall twice. The paper counts 22 edges by eye: 31.6 % "
      "of "
      "their length (9 edges) lies double after a plain merge by the best pair of boxes, 2.4 % (1 "
      "edge) "
      "after its Kalman step. The best rigid fit is the best that a transform can do: what the "
      "SLAM has bent stays bent. The last column is what <code>sbox-merge --fusion "
      "observations</code> "
      "makes of the same robots: from where the maps were placed, all scans are adjusted together "
      "and "
      "the map is made anew. Where the paper's columns come near 100 %, its best pair of boxes "
      "is a wrong one, "
      "which no Kalman step can mend.");
  Table table;
  table.header = {"maps"};
  std::vector<std::string> series;
  for (const NamedCoincidence& entry : pairs.front().coincidences) {
    table.header.push_back(entry.name);
  }
  std::vector<BarGroup> groups;
  int met = 0, icp = 0, met_from_scans = 0;
  for (const RoomsPair& pair : pairs) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row.push_back(nameOf(pair));
    for (const NamedCoincidence& entry : pair.coincidences) {
      row.push_back(entry.coincidence ? percent(entry.coincidence->share()) + " (" +
                                            std::to_string(entry.coincidence->apart_edges) +
                                            " of " + std::to_string(entry.coincidence->edges) + ")"
                                      : "-");
    }
    BarGroup& group = groups.emplace_back();
    group.label = (pair.slam == Slam::Rbpf ? "RBPF " : "ICP ") + std::to_string(pair.seed);
    for (const char* name : {"paper, plain merge", "paper, Kalman", "ours, reported",
                             "best rigid fit to the truth", "ours, from all scans"}) {
      const double share = shareOf(pair, name).value_or(1);
      group.values.push_back(100 * share);
      group.texts.push_back(formatNumber(100 * share, share < 0.1 ? 1 : 0));
    }
    const auto ours = shareOf(pair, "ours, reported");
    const auto from_scans = shareOf(pair, "ours, from all scans");
    met_from_scans += pair.error.right && from_scans && *from_scans <= 0.024 ? 1 : 0;
    icp += pair.slam == Slam::Icp ? 1 : 0;
    met += pair.slam == Slam::Icp && pair.error.right && ours && *ours <= 0.024 ? 1 : 0;
  }
  page.target(met == icp, "At most 2.4 % double: " + std::to_string(met) + " of " +
                              std::to_string(icp) + " pairs by ICP-SLAM.");
  const auto all = static_cast<int>(pairs.size());
  page.target(met_from_scans == all,
              "At most 2.4 % double from all scans: " + std::to_string(met_from_scans) + " of " +
                  std::to_string(all) + " pairs by either SLAM.");
  page.table("Share of the wall edges' length that is double (edges, of those both maps show)",
             table);
  page.figure(barsSvg("Share of double walls", "double, % of edge length", 100,
                      {"paper, plain", "paper, Kalman", "ours", "best rigid fit", "from all scans"},
                      groups),
              "Share of double walls for each pair of maps.");
  const RoomsPair& shown = pairs.back();
  const StateGrid a = classifyCells(shown.robots.maps[0]), b = classifyCells(shown.robots.maps[1]);
  const auto plain = plainPaperPose(shown.robots.maps[0], shown.robots.maps[1]);
  if (plain) {
    page.picture(drawOverlay(a, b, *plain, "plain merge", "map 1", "map 2"),
                 "Figure 8a: the paper's plain merge, " + nameOf(shown) + ".");
  }
  if (shown.answer.has_pose) {
    page.picture(drawOverlay(a, b, shown.answer.pose_b_in_a, "ours", "map 1", "map 2"),
                 "Figure 8b: our merge, " + nameOf(shown) + ".");
  }
  const RoomsPair& bent = pairs.front();
  if (bent.adjusted) {
    page.picture(drawOverlay(classifyCells(bent.robots.maps[0]), classifyCells(bent.robots.maps[1]),
                             bent.answer.pose_b_in_a, "ours", "map 1", "map 2"),
                 "Our merge, " + nameOf(bent) + ".");
    page.picture(
        drawOverlay(classifyCells(bent.adjusted->maps[0]), classifyCells(bent.adjusted->maps[1]),
                    Pose2D(), "ours, from all scans", "map 1", "map 2"),
        "The same robots after all scans were adjusted together.");
  }
}

void addLengthSections(Page& page, const std::vector<RoomsPair>& pairs, const std::string& source) {
  page.section("Wall lengths at 0, 45 and 90 degrees (Table 2)", source);
  page.paragraph(
      "Eight walls of known length, measured in each map as the distance between the cells at "
      "their two "
      "ends. Map 2 is turned about its robot's start and written into upright cells again, so its "
      "walls "
      "are jagged at 45 degrees. The paper reports a mean error of about 4 % in the merged map. A "
      "dash: "
      "the maps were not merged, or the wall's end is not to be found.");
  for (const RoomsPair* pair : {&pairs.front(), &pairs.back()}) {
    if (pair == &pairs.front() || pairs.size() > 1) {
      page.table("Lengths in metres, " + nameOf(*pair), lengthTable(*pair));
    }
  }
  page.section("Wall lengths at random angles (figure 11)", source);
  Table table;
  table.header = {"maps", "angles", "mean error", "worst angle's", "not merged", "from all scans"};
  bool met = true;
  for (const RoomsPair& pair : pairs) {
    const ErrorSummary summary = summarise(pair);
    table.rows.push_back({nameOf(pair), std::to_string(summary.angles), percent(summary.mean, 2),
                          percent(summary.worst, 2), std::to_string(summary.missing),
                          errorText(meanError(pair.adjusted_walls, &WallLengths::merged))});
    met = met && summary.missing == 0 && summary.worst <= 0.02;
  }
  page.target(met, "Mean error of the merged map at most 2 % at every angle (paper: within 5 %).");
  page.figure(angleCurves(pairs.back()),
              "Figure 11: mean error over the eight walls, " + nameOf(pairs.back()) + ".");
  page.table(
      "Error of the merged map over all angles; beside it that of the map made anew from all scans",
      table);
}

}  // namespace sbox::paper
