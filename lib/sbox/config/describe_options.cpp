// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/config/describe_options.h"

#include "sbox/config/describe_boxes.h"
#include "sbox/config/describe_paper.h"
#include "sbox/config/describe_states.h"
#include "sbox/io/map_limits.h"

namespace sbox {

OptionTable describeOptions(MergeOptions& options) {
  OptionTable table;
  table.section("merge");
  table.choice<Method>("method", options.method,
                       {{"boxes", Method::Boxes}, {"paper", Method::Paper}},
                       "How pairs of maps are matched");
  describe(options.pair, table);
  describe(options.paper, table);

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
               "Accepted pairs below this confidence join nothing");

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
