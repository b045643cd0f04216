// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/config/describe_boxes.h"

#include "sbox/config/describe_states.h"

namespace sbox {
namespace {

void describeWalls(FeatureOptions& features, OptionTable& table) {
  table.section("features");
  table.metres("working_resolution", features.working_resolution, {0.01, 1},
               "Finer maps are read in cells of this size");
  table.count("min_contour_cells", features.contours.min_cells, {2, 1000},
              "Shorter outlines of free space are specks");
  table.metres("line_tolerance", features.walls.tolerance, {0.01, 2},
               "Of the Douglas-Peucker simplification of outlines");
  table.metres("min_line", features.walls.min_length, {0.1, 20}, "Shorter lines are left out");
  table.metres("point_spacing", features.walls.point_spacing, {0.05, 5},
               "Between wall points along an outline");
  table.metres("tangent_reach", features.walls.tangent_reach, {0.05, 5},
               "Of the outline's local direction, either side of a point that is on no line");
  table.metres("sharpen_reach", features.sharpen.reach, {0, 1},
               "Either side of a wall, where the map's own cells are asked for its edge");
  table.metres("sharpen_along", features.sharpen.along, {0, 5},
               "Either side of a wall point, over which its edge is averaged");
  table.metres("sharpen_outlier", features.sharpen.outlier, {0, 1},
               "Places whose edge is this far from the median's are left out");
  table.metres("free_spacing", features.free_spacing, {0.1, 5}, "Between points of free space");
  describeStates("features.cells", features.states, table);

  table.section("features.frames");
  table.number("min_wall_share", features.frames.min_wall_share, {0, 1},
               "Share at walls of lines that tell a main direction");
  table.number("smoothing", features.frames.smoothing, {0.1, 20},
               "Of the histogram of directions, degrees");
  table.number("separation", features.frames.separation, {1, 45},
               "Between two main directions, degrees");
  table.number("min_share", features.frames.min_share, {0, 1},
               "Weight of a further main direction over the strongest");
  table.count("max_frames", features.frames.max_frames, {1, 10}, "Main directions of a map");
}

void describeBoxesAndCorners(FeatureOptions& features, OptionTable& table) {
  table.section("features.lines");
  table.number("max_tilt", features.axis_lines.max_tilt, {0, 44}, "Off the axis, degrees");
  table.metres("join_gap", features.axis_lines.join_gap, {0, 50},
               "Stretches of a wall this far apart are one line");
  table.metres("join_offset", features.axis_lines.join_offset, {0.01, 5},
               "Distance across at which they still are");
  table.number("min_wall_share", features.axis_lines.min_wall_share, {0, 1},
               "A line that lies less at walls is an edge of the unknown");

  table.section("features.corners");
  table.metres("reach", features.corners.reach, {0, 50}, "Both lines come this near to a corner");
  table.metres("min_arm", features.corners.min_arm, {0.01, 20},
               "A line that goes less far beyond a corner has no arm there");
  table.count("max_corners", features.corners.max_corners, {1, 20000}, "The strongest are kept");

  table.section("features.boxes");
  table.metres("min_side", features.boxes.min_side, {0.1, 100}, "Shortest side");
  table.metres("max_side", features.boxes.max_side, {0.1, 1000}, "Longest side");
  table.number("min_cover", features.boxes.min_cover, {0, 1}, "Real wall line on each side, share");
  table.number("mean_cover", features.boxes.mean_cover, {0, 1},
               "Real wall line on all sides, mean share");
  table.count("max_boxes", features.boxes.max_boxes, {1, 20000},
              "Those with the longest real sides are kept");

  table.section("features.fields");
  table.metres("resolution", features.fields.resolution, {0.02, 2}, "Of the likelihood fields");
  table.number("most_cells", features.fields.most_cells, {1e4, 1e9},
               "Larger maps have coarser likelihood fields");
  table.metres("reach", features.fields.reach, {0.1, 2.5}, "Walls further off are as good as none");
  table.number("sector_overlap", features.fields.sector_overlap, {0, 22},
               "Of neighbouring facing directions, degrees");
}

void describeMatching(PairOptions& options, OptionTable& table) {
  table.section("matching.votes");
  table.metres("bin", options.votes.bin, {0.05, 10}, "Edge of a bin of translations");
  table.number("most_bins", options.votes.most_bins, {1e4, 1e9},
               "Where maps are so large that there would be more, bins are larger");
  table.number("box_weight", options.votes.box_weight, {0, 100},
               "Of a pair of boxes; a pair of corners counts 1");
  table.metres("size_tolerance", options.votes.size_tolerance, {0, 10},
               "Between the sides of two boxes");
  table.number("size_ratio", options.votes.size_ratio, {0, 1},
               "Further tolerance, as a share of the side");
  table.count("max_hypotheses", options.votes.max_hypotheses, {1, 100000},
              "The bins with most votes");
  table.count("min_per_heading", options.votes.min_per_heading, {0, 100000},
              "Kept of each pair of frames and quarter turn");

  table.section("matching.guess");
  table.number("deviations", options.guess.deviations, {0.1, 100},
               "Standard deviations from an initial guess, within which is searched first");
  table.metres("spacing", options.guess.spacing, {0.05, 10}, "Between translations tried there");
  table.count("most", options.guess.most, {1, 1000000},
              "Translations tried at a heading; more spacing where they would be more");

  CorrelationSearchOptions& search = options.correlation;
  table.section("matching.search");
  table.number("sure", options.sure, {0, 1.01},
               "Probability from which corners and boxes suffice; above 1 all is searched");
  table.metres("resolution", search.resolution, {0.05, 5}, "Of the pictures that are correlated");
  table.count("most_cells", search.most_cells, {16, 2048},
              "Of a picture's side; larger maps are searched more coarsely");
  table.metres("wall_blur", search.wall_blur, {0.05, 5}, "At which walls agree");
  table.number("min_agree", search.min_agree, {0, 1}, "Share of the common walls that must agree");
  table.metres("separation", search.separation, {0.1, 20}, "Between two translations");
  table.count("per_heading", search.per_heading, {1, 1000}, "Translations kept of a heading");
  table.number("heading_step", search.headings.step, {1, 90}, "Between headings, degrees");
  table.number("heading_smoothing", search.headings.smoothing, {0.1, 20},
               "Of the histograms of facing directions, degrees");
  table.number("heading_share", search.headings.min_share, {0, 1},
               "Of the best heading's correlation that another must have");
  table.count("max_headings", search.headings.max_headings, {1, 360}, "Headings searched");
}

void describeEvidence(const std::string& section, EvidenceOptions& evidence, OptionTable& table) {
  table.section(section);
  table.metres("kernel", evidence.kernel, {0.01, 5}, "Standard deviation at which walls agree");
  table.metres("conflict_from", evidence.conflict_from, {0, 5},
               "Depth in free space at which a wall begins to conflict");
  table.metres("conflict_full", evidence.conflict_full, {0, 5},
               "Depth from which it conflicts fully");
}

void describeAlignment(const std::string& prefix, AlignmentOptions& alignment,
                       const std::string& whose, OptionTable& table) {
  table.metres(prefix + "_kernel", alignment.kernel, {0.01, 10},
               "Scale of the robust kernel of the " + whose);
  table.count(prefix + "_iterations", alignment.iterations, {0, 1000},
              "Steps of the " + whose + ", at most");
  table.count(prefix + "_points", alignment.most_points, {1, 1000000},
              "Wall points of each map in the " + whose);
}

void describeVerification(PairOptions& options, OptionTable& table) {
  RankingOptions& ranking = options.ranking;
  table.section("verification");
  table.count("first_points", ranking.first_points, {1, 100000},
              "Wall points that every hypothesis is asked of");
  table.count("first_kept", ranking.first_kept, {1, 100000}, "Hypotheses kept after that");
  table.count("coarse_points", ranking.coarse_points, {1, 100000},
              "Wall points that these are asked of");
  table.count("coarse_kept", ranking.coarse_kept, {1, 100000}, "Hypotheses kept after that");
  table.count("fine_points", ranking.fine_points, {1, 100000},
              "Wall points that these are asked of");
  table.count("aligned", ranking.aligned, {1, 10000}, "Hypotheses that are aligned to the walls");
  table.number("aligned_within", ranking.aligned_within, {0, 1000},
               "Of the most plausible of them; others go no further, log odds");
  table.count("kept", ranking.kept, {1, 1000}, "Fits that are judged");
  table.number("kept_within", ranking.kept_within, {0, 1000},
               "Of the most plausible fit, log odds");
  table.count("bent_points", ranking.bent_points, {1, 1000000},
              "Wall points that these are asked of");
  table.metres("same_distance", ranking.same_distance, {0, 50}, "Nearer answers are one");
  table.metres("same_bent", ranking.same_bent, {0, 50},
               "Fits that lay the walls this near once the drift is taken out are one");
  table.metres("same_answer", options.same.distance, {0, 50},
               "Fits this near once the drift is taken out are one answer ...");
  table.number("same_answer_drift", options.same.drift_share, {0, 100},
               "... as are fits nearer than this times the roughness of the rougher drift");
  table.number("same_turn", ranking.same_turn, {0, 90}, "Nearer answers are one, degrees");
  describeAlignment("first_alignment", ranking.first_alignment, "first, coarse alignment", table);
  describeAlignment("alignment", ranking.alignment, "alignment", table);
  table.number("accept_from", options.verdict.accept_from, {0, 1},
               "Probability from which the best fit is accepted");
  table.number("rival_from", options.verdict.rival_from, {0, 1},
               "Probability from which a rival that nothing speaks against makes a pair ambiguous");
  table.number("rival_agree", options.verdict.rival_agree, {0, 1},
               "Share of the common walls that agree in such a rival");
  table.number("rival_conflict", options.verdict.rival_conflict, {0, 1},
               "Share of the common walls that may conflict in such a rival");
  table.metres("box_corner_distance", options.boxes.corner_distance, {0, 10},
               "Between the corners of boxes that agree");
  describeEvidence("verification.rigid", ranking.evidence, table);
  describeEvidence("verification.bent", ranking.bent_evidence, table);
  table.metres("straight_from", ranking.bent_evidence.straight_from, {0, 20},
               "Length of line from which a wall is straight and not clutter");
  table.metres("shallow_until", ranking.bent_evidence.shallow_until, {0, 5},
               "Depth in free space up to which drift may have carried a wall there");
  table.metres("deep_from", ranking.bent_evidence.deep_from, {0, 5},
               "Depth at which a wall begins to lie where no drift has carried it");
  table.metres("deep_full", ranking.bent_evidence.deep_full, {0, 5},
               "Depth from which it lies there fully (depths are told apart up to 3.8)");

  table.section("verification.drift");
  table.metres("node_spacing", ranking.drift.node_spacing, {0.5, 1000},
               "Of the lattice of displacements");
  table.count("most_nodes", ranking.drift.most_nodes, {2, 64}, "Along each axis");
  table.metres("bending", ranking.drift.bending, {0.001, 10},
               "Expected change between neighbouring nodes");
  table.metres("wall_noise", ranking.drift.wall_noise, {0.001, 10},
               "Expected offset of walls that agree");
  table.metres("first_kernel", ranking.drift.first_kernel, {0.01, 10},
               "Scale of the robust kernel in the first round ...");
  table.metres("last_kernel", ranking.drift.last_kernel, {0.01, 10}, "... and in the last");
  table.count("rounds", ranking.drift.rounds, {0, 100}, "Of reweighted least squares");
  table.count("most_points", ranking.drift.most_points, {1, 1000000}, "Wall points of each map");
}

void describeRefinement(RefineOptions& refine, OptionTable& table) {
  table.section("refinement");
  table.metres("drift_free", refine.drift_free, {0, 10},
               "Roughness of the drift below which the answer of Ceres is reported");
  table.metres("most_polish", refine.most_polish, {0, 10},
               "Shift of walls from which Ceres is not reported");
  table.metres("large_difference", refine.large_difference, {0, 1000},
               "Distance of Kalman and Ceres that lowers the confidence");
  table.number("difference_odds", refine.difference_odds, {0, 1},
               "The odds of being right are then multiplied by this");
  table.metres("corner_noise", refine.kalman.corner_noise, {0.001, 10},
               "Least standard deviation of a corner in the Kalman step");
  table.metres("prediction_shift", refine.kalman.prediction_shift, {0.001, 100},
               "Standard deviation of the place that the Kalman step starts from");
  table.number("prediction_turn", refine.kalman.prediction_turn, {0.001, 180},
               "Standard deviation of the heading that it starts from, degrees");
  table.number("gate", refine.kalman.gate, {0, 1000},
               "Squared Mahalanobis distance beyond which it leaves a corner out");
  table.metres("wall_noise", refine.covariance.wall_noise, {0.001, 10},
               "Standard deviation of a wall's offset without drift, for the covariance");
  table.metres("correlation_length", refine.covariance.correlation_length, {0.01, 10000},
               "Length of wall that errs together, for the covariance");
  table.number("drift_shift", refine.covariance.drift_shift, {0, 10000},
               "Shift by drift, for the covariance: times squared roughness, per wall that agrees");
  table.number("drift_turn", refine.covariance.drift_turn, {0, 10000},
               "Turn by drift, for the covariance: times roughness^1.5, per wall that agrees");

  table.section("refinement.ceres");
  table.metres("first_scale", refine.polish.first_scale, {0.001, 10},
               "Of the robust loss in the first round ...");
  table.metres("last_scale", refine.polish.last_scale, {0.001, 10}, "... and in the last");
  table.count("rounds", refine.polish.rounds, {0, 100}, "Walls are paired anew in each");
  table.count("iterations", refine.polish.iterations, {0, 1000}, "Of a round, at most");
  table.count("most_points", refine.polish.most_points, {1, 1000000}, "Wall points of each map");
  table.count("most_corners", refine.polish.most_corners, {0, 100000}, "Corners used");
  table.number("corner_weight", refine.polish.corner_weight, {0, 100},
               "Of all corners together, as a share of all walls");
  table.metres("corner_noise", refine.polish.corner_noise, {0.001, 10},
               "Standard deviation of a corner that counts fully");
}

}  // namespace

void describe(PairOptions& options, OptionTable& table) {
  describeWalls(options.features, table);
  describeBoxesAndCorners(options.features, table);
  describeMatching(options, table);
  describeVerification(options, table);
  describeRefinement(options.refine, table);
}

}  // namespace sbox
