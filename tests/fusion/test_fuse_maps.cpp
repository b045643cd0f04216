// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "catch.h"
#include "fusion/literal_map.h"
#include "sbox/fusion/fuse_maps.h"

using namespace sbox;
using namespace sbox::test;

namespace {

using Rows = std::vector<std::string>;

Map noiseMap(int width, int height, unsigned seed, const Pose2D& corner = {}) {
  std::mt19937 random(seed);
  Map map = makeMap("noise", width, height, 0.05, corner);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool known = random() % 4 != 0;
      setCell(&map, x, y, known ? static_cast<int>(random() % 255) - 127 : 0);
    }
  }
  return map;
}

}  // namespace

TEST_CASE("a map fused with itself keeps its cells and doubles its log-odds", "[fusion]") {
  const Pose2D corner = GENERATE(Pose2D(), Pose2D(-7.31, 4.2, 0), Pose2D(1, 2, 0.6));
  const Map map = literalMap({"####", "#..#", "#. #"}, 0.1, corner);
  const FusionResult result = fuseMaps({{&map, {}}, {&map, {}}}, 0);
  CHECK(asText(result.merged) == asText(map));
  CHECK(cellAt(result.merged, 1, 1) == 127);
  CHECK(cellAt(result.merged, 0, 0) == -127);
  CHECK(result.merged.corner_in_map.x == Approx(corner.x));
  CHECK(result.merged.corner_in_map.y == Approx(corner.y));
  CHECK(result.merged.corner_in_map.phi == Approx(corner.phi));
  CHECK(result.shared_cells == 11);
  CHECK(result.conflict_share == 0);
}

TEST_CASE("the extent is just what is known, on the reference's cells", "[fusion]") {
  const Map a = literalMap({"    ", " #. ", "    "}, 0.1, {2, 3, 0.3});
  const Map b = literalMap({"   ", " . ", "   "}, 0.1, {2, 3, 0.3});
  // Three cells along b's own turned rows.
  const Pose2D b_in_a(0.3 * std::cos(0.3), 0.3 * std::sin(0.3), 0);
  const FusionResult result = fuseMaps({{&a, {}}, {&b, b_in_a}}, 0);
  CHECK(asText(result.merged) == Rows{"#. ."});
  const Point2D corner = a.corner_in_map.composePoint({0.1, 0.1});
  CHECK(result.merged.corner_in_map.x == Approx(corner.x));
  CHECK(result.merged.corner_in_map.y == Approx(corner.y));
  CHECK(result.merged.corner_in_map.phi == Approx(0.3));
}

TEST_CASE("log-odds are summed and saturate", "[fusion]") {
  Map a = makeMap("a", 4, 1, 0.1), b = makeMap("b", 4, 1, 0.1);
  const int of_a[] = {40, -100, 30, 0}, of_b[] = {20, -100, -70, 0};
  for (int x = 0; x < 4; ++x) {
    setCell(&a, x, 0, of_a[x]);
    setCell(&b, x, 0, of_b[x]);
  }
  const Map merged = fuseMaps({{&a, {}}, {&b, {}}}, 0).merged;
  REQUIRE(merged.width() == 3);
  CHECK(cellAt(merged, 0, 0) == 60);
  CHECK(cellAt(merged, 1, 0) == -127);
  CHECK(cellAt(merged, 2, 0) == -40);
}

TEST_CASE("evidence that cancels leaves a wall, not a hole", "[fusion]") {
  Map wall = makeMap("wall", 1, 1, 0.1), open = wall, open_too = wall;
  setCell(&wall, 0, 0, -127);
  setCell(&open, 0, 0, 127);
  setCell(&open_too, 0, 0, 127);
  CHECK(cellAt(fuseMaps({{&wall, {}}, {&open, {}}}, 0).merged, 0, 0) == -16);
  CHECK(cellAt(fuseMaps({{&wall, {}}, {&open, {}}, {&open_too, {}}}, 0).merged, 0, 0) == 127);
}

TEST_CASE("Table 1", "[fusion]") {
  // The nine pairs of states, one a column.
  const Map a = literalMap({"   ...###"}), b = literalMap({" .# .# .#"});
  FusionOptions options;
  options.rule = FusionRule::Table;
  const FusionResult result = fuseMaps({{&a, {}}, {&b, {}}}, 0, options);
  CHECK(asText(result.merged) == Rows{".#..####"});
  CHECK(result.shared_cells == 4);
}

TEST_CASE("Table 1 lets an unsure cell give way", "[fusion]") {
  Map unsure = makeMap("unsure", 1, 1, 0.1), open = unsure;
  setCell(&unsure, 0, 0, -3);
  setCell(&open, 0, 0, 90);
  FusionOptions options;
  options.rule = FusionRule::Table;
  CHECK(cellAt(fuseMaps({{&unsure, {}}, {&open, {}}}, 0, options).merged, 0, 0) == 90);
}

TEST_CASE("cells that only the reference knows keep their value", "[fusion]") {
  const Map a = noiseMap(40, 30, 1, {5, -3, 0.4}), b = noiseMap(20, 20, 2);
  const FusionResult result = fuseMaps({{&a, {}}, {&b, {100, 100, 0.7}}}, 0);
  const Pose2D a_in_merged = inverse(result.merged.corner_in_map) + a.corner_in_map;
  const int dx = static_cast<int>(std::lround(a_in_merged.x / 0.05));
  const int dy = static_cast<int>(std::lround(a_in_merged.y / 0.05));
  int wrong = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      wrong += cellAt(result.merged, x + dx, y + dy) != cellAt(a, x, y) ? 1 : 0;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("the order of the maps and the number of threads change no cell", "[fusion]") {
  const Map a = noiseMap(150, 90, 1), b = noiseMap(140, 200, 2), c = noiseMap(100, 100, 3);
  const PlacedMap in_a{&a, {}}, in_b{&b, {1.03, -2.2, 0.83}}, in_c{&c, {-3.3, 1, -2.5}};
  FusionOptions options;
  options.rule = GENERATE(FusionRule::Table, FusionRule::LogOdds);
  const FusionResult first = fuseMaps({in_a, in_b, in_c}, 0, options);
  options.threads = 3;
  const FusionResult second = fuseMaps({in_c, in_b, in_a}, 2, options);
  CHECK(sameCells(first.merged, second.merged));
  CHECK(first.conflicts == second.conflicts);
  CHECK(first.conflict_share == second.conflict_share);
  CHECK(first.conflict_share > 0);
}

TEST_CASE("nothing known is left out and nothing is made up", "[fusion]") {
  const Map a = noiseMap(60, 40, 4, {0, 0, 0.2}), b = noiseMap(50, 70, 5);
  const Pose2D b_in_a(0.613, -0.4, 1.1);
  const FusionResult result = fuseMaps({{&a, {}}, {&b, b_in_a}}, 0);
  const Map& merged = result.merged;
  int wrong = 0, column_known = 0, row_known = 0;
  for (int y = 0; y < merged.height(); ++y) {
    for (int x = 0; x < merged.width(); ++x) {
      const auto known = [&](const Map& map, const Pose2D& map_in_a) {
        const Point2D at =
            (map_in_a + map.corner_in_map).inverseComposePoint(merged.cellCentre(x, y));
        return cellAt(map, static_cast<int>(std::floor(at.x / 0.05)),
                      static_cast<int>(std::floor(at.y / 0.05))) != 0;
      };
      const bool merged_known = cellAt(merged, x, y) != 0;
      // Necks between corner-to-corner walls may know a little more.
      wrong += (known(a, {}) || known(b, b_in_a)) && !merged_known ? 1 : 0;
      column_known += merged_known && (x == 0 || x == merged.width() - 1) ? 1 : 0;
      row_known += merged_known && (y == 0 || y == merged.height() - 1) ? 1 : 0;
    }
  }
  CHECK(wrong <= 2);  // A centre on the very edge of a cell.
  CHECK(column_known > 0);
  CHECK(row_known > 0);
}

TEST_CASE("a finer map splits the reference's cells evenly", "[fusion]") {
  const Map coarse = literalMap({"#.", " #"}, 0.1, {1, 1, 0});
  const Map fine = literalMap({"."}, 0.05, {1, 1, 0});
  const FusionResult result = fuseMaps({{&coarse, {}}, {&fine, {}}}, 0);
  CHECK(asText(result.merged) == Rows{"##..", "##..", "  ##", ". ##"});
  CHECK(result.merged.resolution() == Approx(0.05));
  const FusionResult swapped = fuseMaps({{&coarse, {}}, {&fine, {}}}, 1);
  CHECK(asText(swapped.merged) == Rows{"##..", "##..", "  ##", ". ##"});
}

TEST_CASE("cell sizes that do not divide are resampled to the finer", "[fusion]") {
  const Map coarse = literalMap({"....", "....", "....", "...."}, 0.05);
  const Map fine = literalMap({"."}, 0.02);
  const Map merged = fuseMaps({{&coarse, {}}, {&fine, {}}}, 0).merged;
  CHECK(merged.resolution() == Approx(0.02));
  CHECK(merged.width() == 10);
  CHECK(merged.height() == 10);
}

TEST_CASE("two views of one wall half a cell apart stay one wall", "[fusion]") {
  const Map a = literalMap({".....", "#####", "....."}), b = a;
  const double shift = GENERATE(-0.08, -0.05, -0.02, 0.02, 0.05, 0.08);
  const FusionResult result = fuseMaps({{&a, {}}, {&b, {0, shift, 0}}}, 0);
  const Rows text = asText(result.merged);
  CHECK(std::count(text.begin(), text.end(), "#####") == 1);
  CHECK(result.conflicts.empty());
}

TEST_CASE("a wall deep in the other map's free space is a conflict", "[fusion]") {
  const Map a = literalMap({".....", ".....", ".....", "#####"});
  const Map b = literalMap({"..#..", ".....", ".....", "#####"});
  const FusionResult result = fuseMaps({{&a, {}}, {&b, {}}}, 0);
  CHECK(result.shared_cells == 20);
  CHECK(result.conflict_share == Approx(0.05));
  CHECK(result.conflicts == std::vector<std::size_t>{3 * 5 + 2});
}

TEST_CASE("maps that know nothing give one unknown cell", "[fusion]") {
  const Map a = makeMap("a", 3, 3, 0.1, {4, 5, 0});
  const FusionResult result = fuseMaps({{&a, {}}, {&a, {1e12, 0, 1}}}, 0);
  CHECK(asText(result.merged) == Rows{" "});
  CHECK(result.conflict_share == 0);
}

TEST_CASE("misuse is refused", "[fusion]") {
  const Map a = literalMap({"#"});
  CHECK_THROWS_AS(fuseMaps({}, 0), std::invalid_argument);
  CHECK_THROWS_AS(fuseMaps({{&a, {}}}, 1), std::invalid_argument);
  CHECK_THROWS_AS(fuseMaps({{nullptr, {}}}, 0), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(fuseMaps({{&a, {}}, {&a, {nan, 0, 0}}}, 0), std::invalid_argument);
  CHECK_THROWS_AS(fuseMaps({{&a, {}}, {&a, {1e6, 1e6, 0}}}, 0), std::length_error);
  CHECK_THROWS_AS(fuseMaps({{&a, {}}, {&a, {1e15, 0, 0}}}, 0), std::length_error);
}
