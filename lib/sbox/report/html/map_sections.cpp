// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/html/map_sections.h"

#include "sbox/core/number_text.h"
#include "sbox/report/drawing/palette.h"
#include "sbox/report/html/html_text.h"
#include "sbox/report/html/pose_table.h"
#include "sbox/report/html/stage.h"
#include "sbox/report/words.h"

namespace sbox::html {
namespace {

std::string number(double metres) { return fixedDigits(metres, 3); }

std::string coordinates(const Point2D& point) { return number(point.x) + " " + number(point.y); }

std::string path(const std::string& layer, const std::string& data) {
  return "<path class=\"layer " + layer + "\" data-layer=\"" + layer + "\" d=\"" + data + "\"/>\n";
}

/// Lines, points and boxes in metres over the whole stage. A dot is a line of no length with round
/// ends.
std::string featureShapes(const FeatureSet& features, const PlotView& stage) {
  std::string lines, points, boxes;
  for (const LineSegment& line : features.lines) {
    lines += "M" + coordinates(line.from) + "L" + coordinates(line.to);
  }
  for (const Point2D& point : features.vertical_points) {
    points += "M" + coordinates(point) + "h0";
  }
  for (const auto& box : features.boxes) {
    boxes += "M" + coordinates(box[0]) + "L" + coordinates(box[1]) + " " + coordinates(box[2]) +
             " " + coordinates(box[3]) + "z";
  }
  const double width = stage.size.width / stage.pixels_per_metre;
  const double height = stage.size.height / stage.pixels_per_metre;
  return "<svg viewBox=\"" + number(stage.low.x) + " " + number(-stage.low.y - height) + " " +
         number(width) + " " + number(height) +
         "\" preserveAspectRatio=\"none\"><g transform=\"scale(1,-1)\">\n" + path("boxes", boxes) +
         path("lines", lines) + path("points", points) + "</g></svg>\n";
}

std::string mapColour(int member) {
  return "wall-" + std::to_string(static_cast<size_t>(member) % palette::distinct.size());
}

}  // namespace

std::string placementTable(const PageData& page) {
  std::string text =
      "<table><thead><tr><th>map</th><th>file</th><th>cells</th><th>cell size</th><th>placed</th>"
      "<th>group</th><th>x</th><th>y</th><th>phi</th></tr></thead><tbody>\n";
  for (size_t i = 0; i < page.names.size(); ++i) {
    const MapOutcome& map = page.result->maps[i];
    text += "<tr><td>" + escaped(page.names[i]) + "</td><td class=\"file\">" + escaped(map.name) +
            "</td><td class=\"number\">" + std::to_string(map.width) + " &times; " +
            std::to_string(map.height) + "</td><td class=\"number\">" +
            fixedDigits(map.resolution, 3) + " m</td><td>" + (map.placed ? "yes" : "no") +
            "</td><td class=\"number\">" + std::to_string(map.placement.group) + "</td>" +
            poseCells(map.placement.pose, map.placement.covariance) + "</tr>\n";
  }
  return text + "</tbody></table>\n";
}

Section mergedSection(const PageData& page, const MergedGroup& merged, const std::string& file) {
  const StateGrid grid = classifyCells(merged.map);
  const std::string name = "g" + std::to_string(merged.group);
  const MapMasks masks = maskMap(grid, name, maskSide(page.grids.size()));
  std::string layers =
      placedLayer({masks.free_class, "free", "free"}, masks.view, {}, masks.view) +
      placedLayer({masks.wall_class, "wall", "merged"}, masks.view, {}, masks.view);
  std::string boxes = checkbox("merged", "wall", "merged map", true);
  for (const int member : merged.members) {
    const std::string layer = "map " + std::to_string(member);
    layers += placedLayer(
        {page.mask(member).wall_class, mapColour(member), layer}, page.mask(member).view,
        page.result->maps[static_cast<size_t>(member)].placement.pose, masks.view);
    boxes += checkbox(layer, mapColour(member), page.name(member), false);
  }
  Section section;
  section.style = masks.style;
  section.body = "<section class=\"merged\" id=\"" + name + "\">\n<h2>Merged map" +
                 (file.empty() ? "" : ": " + escaped(file)) + "</h2>\n<p>" +
                 counted(merged.members.size(), "map", "maps") + " in the frame of " +
                 escaped(page.name(merged.reference)) + ", " + std::to_string(merged.map.width()) +
                 " &times; " + std::to_string(merged.map.height()) + " cells of " +
                 fixedDigits(merged.map.resolution(), 3) + " m. Of the cells that several maps " +
                 "know, " + fixedDigits(100 * merged.conflict_share, 1) +
                 " % are wall in one and free in another.</p>\n<div class=\"viewer\">\n" +
                 "<div class=\"controls\">\n" + boxes + zoomButtons() + "</div>\n" +
                 stageOf(masks.view, layers) + "</div>\n</section>\n";
  return section;
}

Section featuresSection(const PageData& page, int map) {
  const FeatureSet& features = page.result->maps[static_cast<size_t>(map)].features;
  const MapMasks& masks = page.mask(map);
  const std::string layers =
      placedLayer({masks.free_class, "free", "free"}, masks.view, {}, masks.view) +
      placedLayer({masks.wall_class, "wall", "wall"}, masks.view, {}, masks.view) +
      featureShapes(features, masks.view);
  Section section;
  section.body =
      "<section class=\"features\" id=\"map-" + std::to_string(map) + "\">\n<h2>Features of " +
      escaped(page.name(map)) + "</h2>\n<div class=\"viewer\">\n<div class=\"controls\">\n" +
      checkbox("wall", "wall", "walls", true) +
      checkbox("lines", "lines", counted(features.lines.size(), "line", "lines"), true) +
      checkbox("points", "points",
               counted(features.vertical_points.size(), "vertical point", "vertical points"),
               true) +
      checkbox("boxes", "boxes",
               counted(features.boxes.size(), "suppositional box", "suppositional boxes"), true) +
      zoomButtons() + "</div>\n" + stageOf(masks.view, layers) + "</div>\n</section>\n";
  return section;
}

}  // namespace sbox::html
