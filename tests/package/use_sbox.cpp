// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>

#include "sbox/core/state_grid.h"

int main() {
  sbox::Map map = sbox::makeMap("one free cell", 4, 3, 0.05);
  map.grid.setCell(2, 1, 1.0F);
  const sbox::StateGrid states = sbox::classifyCells(map);
  return states.width == 1 && states.height == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
