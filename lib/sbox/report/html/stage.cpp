// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/html/stage.h"

#include <cmath>

#include "sbox/core/number_text.h"
#include "sbox/report/html/html_text.h"
#include "sbox/report/words.h"

namespace sbox::html {
namespace {

struct StageExtent {
  double width = 0;
  double height = 0;
};

StageExtent extentOf(const PlotView& view) {
  return {view.size.width / view.pixels_per_metre, view.size.height / view.pixels_per_metre};
}

std::string percent(double share) { return fixedDigits(100 * share, 4) + "%"; }

std::string openLayer(const MaskLayer& layer) {
  return "<div class=\"layer " + layer.mask + " " + layer.colour + "\" data-layer=\"" +
         escaped(layer.name) + "\"";
}

std::string scaleBar(double stage_width) {
  const double length = roundLength(stage_width / 4);
  return "<div class=\"scale\" style=\"width:" + percent(length / stage_width) + "\">" +
         lengthText(length) + "</div>";
}

}  // namespace

std::string wholeLayer(const MaskLayer& layer) { return openLayer(layer) + "></div>\n"; }

std::string placedLayer(const MaskLayer& layer, const PlotView& part, const Pose2D& pose_in_stage,
                        const PlotView& stage) {
  const StageExtent all = extentOf(stage), own = extentOf(part);
  const Point2D corner = pose_in_stage.composePoint(part.low);
  return openLayer(layer) + " style=\"left:" + percent((corner.x - stage.low.x) / all.width) +
         ";bottom:" + percent((corner.y - stage.low.y) / all.height) +
         ";width:" + percent(own.width / all.width) +
         ";height:" + percent(own.height / all.height) + ";transform:rotate(" +
         fixedDigits(-pose_in_stage.phi * 180 / M_PI, 4) + "deg)\"></div>\n";
}

std::string stageOf(const PlotView& stage, const std::string& layers) {
  const StageExtent extent = extentOf(stage);
  return "<div class=\"stage\" style=\"--ratio:" + fixedDigits(extent.width / extent.height, 4) +
         "\"><div class=\"world\">\n" + layers + scaleBar(extent.width) + "</div></div>\n";
}

std::string checkbox(const std::string& layer, const std::string& swatch, const std::string& label,
                     bool checked) {
  return "<label><input type=\"checkbox\" data-toggles=\"" + escaped(layer) + "\"" +
         (checked ? " checked" : "") + "><span class=\"swatch " + swatch + "\"></span>" +
         escaped(label) + "</label>\n";
}

std::string zoomButtons() {
  return "<span class=\"zoom\"><button type=\"button\" data-zoom=\"in\" "
         "aria-label=\"larger\">+</button><button type=\"button\" data-zoom=\"out\" "
         "aria-label=\"smaller\">&minus;</button><button type=\"button\" "
         "data-zoom=\"reset\">whole</button></span>\n";
}

}  // namespace sbox::html
