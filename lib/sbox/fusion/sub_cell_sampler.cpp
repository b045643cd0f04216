// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/fusion/sub_cell_sampler.h"

#include <cmath>

namespace sbox {

SubCellSampler::SubCellSampler(const Map& map, double neck_width)
    : cells_(map.grid.getRow(0)),
      stride_(map.width()),
      width_(map.width()),
      height_(map.height()),
      neck_half_(std::llround(neck_width * M_SQRT1_2 * static_cast<double>(kSubCellUnit))) {}

CellEvidence SubCellSampler::at(const SubCell& place) const {
  const std::int64_t x = place.u >> 32, y = place.v >> 32;
  const int a = cellAt(x, y), b = cellAt(x + 1, y);
  const int c = cellAt(x, y + 1), d = cellAt(x + 1, y + 1);
  if (ofOneSign(a, b, c, d)) {
    const int mean = bilinear(a, b, c, d, fraction(place.u), fraction(place.v));
    return {mean, mean};
  }
  return blend(place);
}

CellEvidence SubCellSampler::blend(const SubCell& place) const {
  const std::int64_t x = place.u >> 32, y = place.v >> 32;
  const int a = cellAt(x, y), b = cellAt(x + 1, y);
  const int c = cellAt(x, y + 1), d = cellAt(x + 1, y + 1);
  const int fx = fraction(place.u), fy = fraction(place.v);
  int state = nearest(place);
  if (state >= 0 && onNeck(place)) {
    state = -1;
  }
  if (state == 0) {
    return {};
  }
  int sum = 0, known_weight = 0, same_sum = 0, same_weight = 0;
  const auto gather = [&](int value, int weight) {
    const int known = value != 0 ? weight : 0;
    const int same = (value < 0) == (state < 0) ? known : 0;
    sum += known * value;
    same_sum += same * value;
    same_weight += same;
    known_weight += known;
  };
  gather(a, (kOne - fx) * (kOne - fy));
  gather(b, fx * (kOne - fy));
  gather(c, (kOne - fx) * fy);
  gather(d, fx * fy);
  if (same_weight == 0 || known_weight == 0) {
    return {};
  }
  const int net = roundedRatio(sum, known_weight);
  return {roundedRatio(same_sum, same_weight), state < 0 ? std::min(net, -1) : std::max(net, 1)};
}

bool SubCellSampler::onNeck(const SubCell& place) const {
  const std::int64_t x = (place.u + kSubCellUnit / 2) >> 32;
  const std::int64_t y = (place.v + kSubCellUnit / 2) >> 32;
  const std::int64_t off_x = place.u - x * kSubCellUnit, off_y = place.v - y * kSubCellUnit;
  // From the nearest cell towards the place.
  const std::int64_t to_x = off_x < 0 ? -1 : 1, to_y = off_y < 0 ? -1 : 1;
  const std::int64_t dx = std::abs(off_x), dy = std::abs(off_y);
  const auto occupied = [&](int steps_x, int steps_y) {
    return cellAt(x + steps_x * to_x, y + steps_y * to_y) < 0;
  };
  const bool beside = occupied(1, 0), above = occupied(0, 1);
  if (beside && above) {
    return !occupied(1, 1) && kSubCellUnit - dx - dy < neck_half_;
  }
  // The flank of a neck reaches a little past the four cells around the place.
  if (beside) {
    return occupied(0, -1) && !occupied(1, -1) && kSubCellUnit - dx + dy < neck_half_;
  }
  return above && occupied(-1, 0) && !occupied(-1, 1) && kSubCellUnit - dy + dx < neck_half_;
}

double neckWidth(double angle, double ratio) {
  constexpr double kUnturned = 1e-9, kSpare = 1e-8;
  if (std::abs(std::remainder(angle, M_PI / 2)) < kUnturned) {
    return 0;
  }
  const double slant = angle + M_PI / 4;
  const double width = std::max(std::abs(std::cos(slant)), std::abs(std::sin(slant)));
  // Without the spare a wall that runs exactly between two rows would be lost in both.
  return width * ratio + kSpare;
}

}  // namespace sbox
