// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/config/describe_paper.h"

#include "sbox/config/describe_states.h"

namespace sbox {
namespace {

void describeLines(PaperOptions& options, OptionTable& table) {
  table.section("paper.lines");
  HoughOptions& hough = options.hough;
  table.degrees("theta_step", hough.theta_step, {0.1, 15}, "Width of an angle bin");
  table.metres("rho_step", hough.rho_step, {0.005, 1},
               "Width of a distance bin, at least one cell");
  table.count("max_lines", hough.max_lines, {2, 1000}, "The strongest lines are kept");
  StretchOptions& stretches = hough.stretches;
  table.metres("min_length", stretches.min_length, {0.05, 100}, "Shorter stretches are left out");
  table.metres("max_gap", stretches.max_gap, {0, 100}, "Holes up to this do not end a stretch");
  table.metres("wall_width", stretches.wall_width, {0.01, 5},
               "Cells this near count as the line's");
}

void describePoints(PaperOptions& options, OptionTable& table) {
  table.section("paper.points");
  table.degrees("perpendicular_tolerance", options.vertical_points.perpendicular_tolerance, {0, 45},
                "Deviation from a right angle allowed");
  table.metres("cluster_radius", options.clusters.radius, {0, 10},
               "A point this near to a cluster's first member joins it");
  table.metres("newton_precision", options.clusters.precision, {1e-12, 0.1},
               "Newton's method ends when its step is shorter");
  table.metres("outline_reach", options.outline.reach, {0, 20},
               "How far to walk from a point to find the outline");
}

void describeBoxes(PaperOptions& options, OptionTable& table) {
  table.section("paper.boxes");
  table.metres("min_width", options.boxes.min_width, {0.05, 100},
               "The shorter side is at least this long");
  table.metres("max_height", options.boxes.max_height, {0.05, 10000},
               "The longer side is at most this long");
  table.count("max_boxes", options.boxes.max_boxes, {1, 20000}, "The largest boxes are kept");
}

void describeMatching(PaperOptions& options, OptionTable& table) {
  table.section("paper.matching");
  BestPairOptions& best = options.best_pair;
  table.metres("side_tolerance", best.rough_match.side_tolerance, {0, 100},
               "Difference of heights, and of widths, allowed");
  table.count("max_matches", best.rough_match.max_matches, {1, 1000000},
              "Rough matches of the largest boxes are kept");
  table.metres("corner_distance", best.agreement.corner_distance, {0, 100},
               "A match agrees if its four corners are nearer");
  table.count("min_agreeing", best.min_agreeing, {0, 100000},
              "Agreeing matches that make a transform a candidate");
  table.metres("least_distance", best.least_distance, {1e-6, 100},
               "The sum of distances in eq. 5 counts as no less");
}

}  // namespace

void describe(PaperOptions& options, OptionTable& table) {
  describeStates("paper.cells", options.states, table);
  describeLines(options, table);
  describePoints(options, table);
  describeBoxes(options, table);
  describeMatching(options, table);
}

}  // namespace sbox
