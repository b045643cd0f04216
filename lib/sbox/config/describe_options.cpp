// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/config/describe_options.h"

#include "sbox/config/describe_boxes.h"
#include "sbox/config/describe_paper.h"
#include "sbox/config/describe_states.h"
#include "sbox/core/map_limits.h"

namespace sbox {
namespace {

void describeAdjustment(AdjustmentOptions& options, OptionTable& table) {
  table.section("adjustment");
  table.count("rounds", options.rounds, {0, 100},
              "Key frames are matched so often, each time from where they were moved to");
  table.metres("point_spacing", options.points.spacing, {0, 10},
               "Between points of a scan that are kept");
  table.metres("neighbours", options.points.neighbours, {0, 10},
               "Points of a scan this near make a surface ...");
  table.metres("thickness", options.points.thickness, {0, 1},
               "... if they deviate no more from a line");
  table.metres("radius", options.overlap.radius, {0, 1000},
               "Key frames this near may have seen the same");
  table.number("turn_cost", options.overlap.turn_cost, {0, 1000},
               "A heading off by a radian counts as this many metres");
  table.count("partners", options.overlap.partners, {0, 1000},
              "Near key frames that each is matched with, at most ...");
  table.count("passage", options.overlap.passage, {0, 100000},
              "... of which those that follow each other this closely count once");
  table.number("least_overlap", options.match.least_overlap, {0, 1},
               "Share of what two key frames saw that must match");
  table.metres("gate", options.match.gate, {0, 100},
               "Farther points do not match in the first rounds ...");
  table.metres("last_gate", options.match.last_gate, {0, 100}, "... nor in the last");
  table.degrees("most_turn", options.match.most_turn, {0, 180},
                "Surfaces that face more different ways do not match");
  table.metres("kernel", options.match.kernel, {0.001, 100},
               "Points that do not match this well count less");
  table.count("iterations", options.match.iterations, {0, 1000}, "Of a match, all done");
  table.metres("most_shift", options.match.most_shift, {0, 100},
               "A match farther from where the key frames were is none");
  table.degrees("most_rotation", options.match.most_rotation, {0, 180},
                "A match turned more against where they were is none");
  table.metres("noise", options.match.noise, {0.001, 100}, "Standard deviation of a point");
  table.metres("step_metres", options.step_metres, {0.001, 100},
               "Standard deviation of SLAM from one key frame to the next ...");
  table.number("step_share", options.step_share, {0, 10}, "... and what a metre between them adds");
  table.degrees("step_turn", options.step_turn, {0.01, 180},
                "Standard deviation of SLAM's heading from one key frame to the next");
  table.number("loss_scale", options.loss_scale, {0.01, 1000},
               "Of the graph's robust loss, in standard deviations of an edge");
}

}  // namespace

OptionTable describePairOptions(MergeOptions& options) {
  OptionTable table;
  table.section("merge");
  table.choice<Method>("method", options.method,
                       {{"boxes", Method::Boxes}, {"paper", Method::Paper}},
                       "How pairs of maps are matched");
  describe(options.pair, table);
  describe(options.paper, table);
  return table;
}

OptionTable describeOptions(MergeOptions& options) {
  OptionTable table = describePairOptions(options);
  table.section("retrieval");
  table.count("partners", options.retrieval.partners, {0, 100000},
              "Of many maps, each is matched with this many that look most like it; 0: all");
  LikenessOptions& likeness = options.retrieval.likeness;
  table.count("max_hypotheses", likeness.max_hypotheses, {1, 100000},
              "Transforms with most votes, by which likeness is judged");
  table.count("min_per_heading", likeness.min_per_heading, {0, 100000},
              "Kept of each pair of frames and quarter turn");
  table.count("first_points", likeness.first_points, {1, 100000},
              "Wall points that all are asked of");
  table.count("kept", likeness.kept, {1, 100000}, "Transforms kept after that");
  table.count("points", likeness.points, {1, 100000}, "Wall points that these are asked of");

  table.section("mapping");
  table.metres("resolution", options.mapping.resolution, {min_resolution, max_resolution},
               "Edge length of the cells of a map made of scans");
  table.metres("max_range", options.mapping.max_range, {0.1, 1000}, "How far a beam changes cells");
  table.number("certainty", options.mapping.certainty, {0.501, 0.999},
               "Probability that one beam says of a cell");
  table.degrees("max_tilt", options.mapping.max_tilt, {0, 45},
                "A lidar tilted more out of the plane is left out");

  table.section("placement");
  table.number("min_confidence", options.placement.min_confidence, {0, 1},
               "Maps are joined with at least this probability");
  table.number("overwhelming", options.placement.overwhelming, {0, 1},
               "Probability from which one pair joins two groups by itself");
  table.number("agreed", options.placement.agreed, {0, 1},
               "Probability from which pairs that agree join two groups ...");
  table.number("witnesses", options.placement.witnesses, {1, 100},
               "... if they are this many; those of one place count as one");
  table.number("alone", options.placement.alone, {0, 1},
               "Probability, with what speaks against it, from which an accepted pair adds a map");
  table.metres("same_distance", options.placement.same_pose.distance, {0, 1000},
               "Two poses of a map this near are one ...");
  table.number("same_distance_share", options.placement.same_pose.distance_share, {0, 1},
               "... plus this share of the mean radius of the two maps");
  table.degrees("same_turn", options.placement.same_pose.turn, {0, 180},
                "Two headings of a map this near are one");
  table.number("loss_scale", options.placement.graph.loss_scale, {0.01, 1000},
               "Of the graph's robust loss, in standard deviations of an edge");
  table.count("iterations", options.placement.graph.iterations, {0, 10000},
              "Of the graph's solver, at most");

  describeAdjustment(options.adjustment, table);

  table.section("fusion");
  table.choice<FusionRule>("rule", options.fusion.rule,
                           {{"table", FusionRule::Table}, {"logodds", FusionRule::LogOdds}},
                           "The paper's table, or the sum of log-odds");
  table.number("max_cells", options.fusion.max_cells, {1, 1e10},
               "A merged map with more cells is refused");
  describeStates("fusion.cells", options.fusion.states, table);
  return table;
}

}  // namespace sbox
