// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "catch.h"
#include "fusion/literal_map.h"
#include "sbox/fusion/sub_cell_sampler.h"

using namespace sbox;
using namespace sbox::test;

namespace {

SubCell place(double u, double v) {
  const auto unit = static_cast<double>(kSubCellUnit);
  return {std::llround(u * unit), std::llround(v * unit)};
}

Map rowMap(int left, int right) {
  Map map = makeMap("row", 2, 1, 0.1);
  setCell(&map, 0, 0, left);
  setCell(&map, 1, 0, right);
  return map;
}

}  // namespace

TEST_CASE("between cells of one state the evidence is weighted by distance", "[fusion]") {
  const Map map = rowMap(-20, -100);
  const SubCellSampler sampler(map, 0);
  CHECK(sampler.at(place(0, 0)).whole == -20);
  CHECK(sampler.at(place(0.25, 0)).whole == -40);
  CHECK(sampler.at(place(1, 0)).net == -100);
}

TEST_CASE("at a wall's edge the nearest cell decides and the net evidence fades", "[fusion]") {
  const Map map = rowMap(-100, 80);
  const SubCellSampler sampler(map, 0);
  CHECK(sampler.at(place(0.25, 0)).whole == -100);
  CHECK(sampler.at(place(0.25, 0)).net == -55);
  CHECK(sampler.at(place(0.49, 0)).net < 0);
  CHECK(sampler.at(place(0.51, 0)).whole == 80);
  CHECK(sampler.at(place(0.51, 0)).net == 1);
  CHECK(sampler.at(place(0.75, 0)).net == 35);
}

TEST_CASE("unknown cells carry no weight", "[fusion]") {
  const Map map = rowMap(-100, 0);
  const SubCellSampler sampler(map, 0);
  CHECK(sampler.at(place(0.4, 0)).whole == -100);
  CHECK(sampler.at(place(0.4, 0)).net == -100);
  CHECK(sampler.at(place(0.6, 0)).whole == 0);
  CHECK(sampler.at(place(0.6, 0)).net == 0);
  CHECK(sampler.at(place(-0.4, 0.4)).whole == -100);
  CHECK(sampler.at(place(-0.6, 0)).whole == 0);
}

TEST_CASE("a neck joins occupied cells that touch at their corners", "[fusion]") {
  const Map rising = literalMap({".#", "#."}), falling = literalMap({"#.", ".#"});
  const double width = neckWidth(M_PI / 4, 1);
  CHECK(width == Approx(1));
  const SubCellSampler up(rising, width), down(falling, width);
  CHECK(up.at(place(0.6, 0.4)).whole == kOccupied);
  CHECK(up.at(place(0.4, 0.6)).whole == kOccupied);
  CHECK(up.at(place(0.9, 0.1)).whole == kFree);
  CHECK(down.at(place(0.6, 0.6)).whole == kOccupied);
  CHECK(down.at(place(0.9, 0.9)).whole == kFree);
  CHECK(SubCellSampler(rising, 0).at(place(0.6, 0.4)).whole == kFree);
  // Its flank, past the square between the four centres.
  CHECK(up.at(place(0.55, -0.05)).whole == kOccupied);
  CHECK(neckWidth(M_PI / 2, 1) == 0);
}

TEST_CASE("the fast path inside the map gives what the careful one gives", "[fusion]") {
  std::mt19937 random(5);
  Map map = makeMap("noise", 12, 9, 0.1);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const int kind = static_cast<int>(random() % 4);
      setCell(&map, x, y, kind == 0 ? 0 : kind == 1 ? -100 : static_cast<int>(random() % 127) + 1);
    }
  }
  const SubCellSampler sampler(map, 0.9);
  std::uniform_real_distribution<double> u(0, 10.99), v(0, 7.99);
  int wrong = 0;
  for (int i = 0; i < 5000; ++i) {
    const SubCell at = place(u(random), v(random));
    wrong += sampler.wholeInside(at) != sampler.at(at).whole ? 1 : 0;
  }
  CHECK(wrong == 0);
}
