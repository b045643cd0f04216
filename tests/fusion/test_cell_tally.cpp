// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "catch.h"
#include "sbox/fusion/cell_tally.h"

using namespace sbox;

TEST_CASE("a tally keeps the sums of many maps apart", "[fusion]") {
  std::mt19937 random(2);
  CellTally tally;
  int free = 0, occupied = 0, maps = 0;
  for (int i = 0; i < 20000; ++i) {
    const int value = static_cast<int>(random() % 256) - 128;
    tally.add(value);
    free += value > 0 ? value : 0;
    occupied += value < 0 ? -value : 0;
    maps += value != 0 ? 1 : 0;
  }
  CHECK(tally.free() == free);
  CHECK(tally.occupied() == occupied);
  CHECK(tally.maps() == maps);
  CHECK(tally.contested());
}

TEST_CASE("maps that agree or know nothing do not contest a cell", "[fusion]") {
  CellTally tally;
  tally.add(0);
  tally.add(-128);
  tally.add(-5);
  CHECK_FALSE(tally.contested());
  CHECK(tally.maps() == 2);
  CHECK(tally.occupied() == 133);
}
