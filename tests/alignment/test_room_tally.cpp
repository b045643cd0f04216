// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "catch.h"
#include "sbox/alignment/room_tally.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

const WallSums kFits{3, 2.7, 0}, kConflicts{3, 0.9, 2}, kDisagrees{3, 0.9, 0};

}  // namespace

TEST_CASE("rooms whose walls conflict or do not agree do not fit", "[alignment]") {
  RoomTally tally({0, 0}, {24, 6});
  CHECK(tally.counts().all == 0);
  // No two of these places share a square of any lattice.
  tally.add({4.5, 4.5}, kFits);
  tally.add({10.5, 4.5}, kConflicts);
  tally.add({16.5, 4.5}, kDisagrees);
  tally.add({22.5, 4.5}, {1.9, 0, 1.9});  // Too little to tell.
  CHECK(tally.counts().all == Approx(3));
  CHECK(tally.counts().misfit == Approx(2));
  // A wall that fits makes up for it in its own room.
  tally.add({10.6, 4.5}, {30, 30, 0});
  CHECK(tally.counts().misfit == Approx(1));
}

TEST_CASE("walls together make a room, apart they make two", "[alignment]") {
  RoomTally together({-10, 5}, {20, 35}), apart({-10, 5}, {20, 35});
  for (RoomTally* tally : {&together, &apart}) {
    tally->add({-9.5, 5.5}, kFits);
  }
  together.add({-9.4, 5.6}, kConflicts);
  apart.add({19.5, 34.5}, kConflicts);
  CHECK(together.counts().all == Approx(1));
  CHECK(together.counts().misfit == Approx(1));
  CHECK(apart.counts().all == Approx(2));
  CHECK(apart.counts().misfit == Approx(1));
}

TEST_CASE("rooms are counted as if each lattice were summed by itself", "[alignment]") {
  std::mt19937 random(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const Vector2d low(-3, 2), high(38, 27);
  RoomTally tally(low, high);
  std::map<std::pair<int, std::pair<int, int>>, WallSums> squares;
  for (int i = 0; i < 200; ++i) {
    const Vector2d place(between(low.x(), high.x()), between(low.y(), high.y()));
    WallSums wall;
    wall.known = between(0, 1);
    wall.agree = between(0, wall.known);
    wall.conflict = between(0, 0.6 * wall.known);
    tally.add(place, wall);
    for (int lattice = 0; lattice < 4; ++lattice) {
      const double x = (place.x() - low.x()) / 6 + 0.5 * (lattice % 2);
      const double y = (place.y() - low.y()) / 6 + 0.5 * (lattice / 2);
      const std::pair<int, int> square(static_cast<int>(std::floor(x)),
                                       static_cast<int>(std::floor(y)));
      squares[{lattice, square}] += wall;
    }
  }
  double all = 0, misfit = 0;
  for (const auto& [key, wall] : squares) {
    if (wall.known >= 2) {
      all += 0.25;
      misfit += wall.agree < 0.4 * wall.known || wall.conflict > 0.3 * wall.known ? 0.25 : 0;
    }
  }
  CHECK(misfit > 1);
  CHECK(misfit < all - 1);
  CHECK(tally.counts().all == Approx(all));
  CHECK(tally.counts().misfit == Approx(misfit));
}
