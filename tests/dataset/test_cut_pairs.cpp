// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>

#include "catch.h"
#include "io/scratch_folder.h"
#include "sbox-bench/judge.h"
#include "sbox-dataset/cut_pairs.h"
#include "sbox/core/state_grid.h"
#include "sbox/io/load_map.h"
#include "sbox/io/save_map.h"

using namespace sbox;
using namespace sbox::dataset;

namespace {

constexpr double kCell = 0.1;

/// A free hall, 30 m by 6 m, its lower-left corner at the origin of the world, on a grid whose
/// corner lies there in the world and elsewhere in the map's frame.
Map hallSeenFrom(const Pose2D& corner_in_world) {
  Map map = makeMap("hall", 400, 400, kCell, {3, -2, 0.2});
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const Point2D place = corner_in_world.composePoint({(x + 0.5) * kCell, (y + 0.5) * kCell});
      if (place.x > 0 && place.x < 30 && place.y > 0 && place.y < 6) {
        map.grid.setCell(x, y, 0.9F);
      }
    }
  }
  return map;
}

/// Two maps of the hall and where a place every two metres along its middle lies in each.
struct Halls {
  Pose2D corner_a_in_world{-1, -2, 0}, corner_b_in_world{33, 8, M_PI - 0.1};
  Map a = hallSeenFrom(corner_a_in_world), b = hallSeenFrom(corner_b_in_world);
  bench::AnnotatedPair pair;

  Halls() {
    const Pose2D a_in_b = inverse(corner_b_in_world) + corner_a_in_world;
    pair.a = "a";
    pair.b = "b";
    pair.theta_deg = a_in_b.phi * 180 / M_PI;
    pair.offset = Point2D(a_in_b.x, a_in_b.y) * (1 / kCell);
    for (int x = 1; x < 30; x += 2) {
      const Point2D place(x, 3);
      pair.points_a.push_back(corner_a_in_world.inverseComposePoint(place) * (1 / kCell));
      pair.points_b.push_back(corner_b_in_world.inverseComposePoint(place) * (1 / kCell));
    }
  }
};

/// The free cells of a map, as the least and the greatest x of them in the world.
std::pair<double, double> extent(const Map& map, const Pose2D& corner_in_world) {
  std::pair<double, double> ends{1e9, -1e9};
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (map.grid.getCell(x, y) > 0.6F) {
        const double at = corner_in_world.composePoint({(x + 0.5) * kCell, (y + 0.5) * kCell}).x;
        ends = {std::min(ends.first, at), std::max(ends.second, at)};
      }
    }
  }
  return ends;
}

}  // namespace

TEST_CASE("a cut leaves each map its part of the hall", "[dataset][cut_pairs]") {
  const Halls halls;
  const CutPair cut = cutPair(halls.a, halls.b, halls.pair, kCell, {0.6, 0.3, 0});
  const auto [a_begin, a_end] = extent(cut.a, halls.corner_a_in_world);
  const auto [b_begin, b_end] = extent(cut.b, halls.corner_b_in_world);
  CHECK(a_begin == Approx(0).margin(0.2));
  CHECK(a_end == Approx(18).margin(0.2));
  CHECK(b_begin == Approx(9).margin(0.2));
  CHECK(b_end == Approx(30).margin(0.2));
  CHECK(cut.a.width() == halls.a.width());
  CHECK(cut.a.corner_in_map == halls.a.corner_in_map);
}

TEST_CASE("the truth of a cut pair is that of the places both keep", "[dataset][cut_pairs]") {
  Halls halls;
  // Of the map as a whole 1 degree is wrong; the places know better.
  const double theta = halls.pair.theta_deg;
  halls.pair.theta_deg += 1;
  const CutPair cut = cutPair(halls.a, halls.b, halls.pair, kCell, {0.6, 0.32, 0});
  CHECK(cut.pair.points_a.size() == 4);  // At 11, 13, 15 and 17 m.
  CHECK(cut.pair.theta_deg == Approx(theta));
  CHECK(cut.pair.theta_local == halls.pair.theta_deg);
  CHECK(cut.pair.floor_cells == Approx(0).margin(1e-6));
}

TEST_CASE("where too few places are left all count", "[dataset][cut_pairs]") {
  const Halls halls;
  const CutPair cut = cutPair(halls.a, halls.b, halls.pair, kCell, {0.6, 0.5, 0});
  CHECK(cut.pair.points_a.size() == halls.pair.points_a.size());
  CHECK(cut.pair.theta_deg == halls.pair.theta_deg);
}

TEST_CASE("a cut beyond the other leaves nothing in common", "[dataset][cut_pairs]") {
  const Halls halls;
  const CutPair cut = cutPair(halls.a, halls.b, halls.pair, kCell, {0.4, 0.6, 0});
  CHECK(cut.pair.negative);
  CHECK(extent(cut.a, halls.corner_a_in_world).second <
        extent(cut.b, halls.corner_b_in_world).first);
  CHECK_THROWS_AS(cutPair(cut.a, cut.b, cut.pair, kCell, {}), std::invalid_argument);
}

TEST_CASE("a tilted cut runs askew", "[dataset][cut_pairs]") {
  const Halls halls;
  const CutPair cut = cutPair(halls.a, halls.b, halls.pair, kCell, {0.5, 0.3, 45});
  // Across at 45 degrees through the middle: 12 m at one wall, 18 m at the other.
  CHECK(extent(cut.a, halls.corner_a_in_world).second == Approx(18).margin(0.3));
}

TEST_CASE("a map without a free cell cannot be cut", "[dataset][cut_pairs]") {
  Halls halls;
  const Map empty = makeMap("empty", 10, 10, kCell);
  CHECK_THROWS_AS(cutPair(empty, empty, halls.pair, kCell, {}), std::runtime_error);
}

TEST_CASE("a folder of pairs becomes a folder of cut pairs", "[dataset][cut_pairs]") {
  const ScratchFolder scratch;
  const Halls halls;
  saveMap(halls.a, scratch.path("a.yaml"));
  saveMap(halls.b, scratch.path("b.yaml"));
  bench::AnnotatedPair negative = halls.pair;
  negative.negative = true;
  bench::writePairFolder({scratch.path(""), "", kCell, {negative, halls.pair}});
  const std::string made = scratch.path("new/cut");
  cutPairs(scratch.path(""), made, {0.6, 0.3, 0});
  const bench::PairFolder read = bench::readPairFolder(made);
  CHECK(read.resolution == kCell);
  REQUIRE(read.pairs.size() == 1);
  CHECK(read.pairs[0].a == "000a");
  const Map a = loadMap(bench::findMapFile(made, "000a"));
  CHECK(extent(a, halls.corner_a_in_world).second == Approx(18).margin(0.2));
  const auto error = bench::poseError(read.pairs[0], read.resolution,
                                      inverse(halls.corner_b_in_world) + halls.corner_a_in_world);
  REQUIRE(error);
  CHECK(error->right);
  CHECK(error->excess_cells == Approx(0).margin(0.1));
}
