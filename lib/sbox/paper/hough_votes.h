// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The voting table of the Hough transform.
#pragma once

#include <vector>

#include "sbox/core/state_grid.h"

namespace sbox {

/// Votes of occupied cells for the lines x cos(theta) + y sin(theta) = rho of the grid frame.
class HoughVotes {
 public:
  /// Every occupied cell votes once for each angle. Steps in radians and metres, both positive.
  HoughVotes(const StateGrid& grid, double theta_step, double rho_step);

  /// Bins of the table, numbered by angle, then by distance.
  [[nodiscard]] int bins() const { return static_cast<int>(votes_.size()); }
  /// Occupied cells that voted for the bin and were not withdrawn.
  [[nodiscard]] int votes(int bin) const { return votes_[static_cast<size_t>(bin)]; }
  /// Direction of the normal of a bin's line, radians in [0, pi).
  [[nodiscard]] double theta(int bin) const {
    const int angle = bin / rho_bins_;
    return angle * theta_step_;
  }
  /// Distance of a bin's line from the lower-left corner of the grid along its normal, metres.
  [[nodiscard]] double rho(int bin) const { return rho_first_ + bin % rho_bins_ * rho_step_; }
  /// Takes back all votes of cell (x, y).
  void withdraw(int x, int y) { cast(x, y, -1); }

 private:
  void cast(int x, int y, int weight);

  double resolution_;
  double theta_step_;
  double rho_step_;
  double rho_first_;
  int rho_bins_;
  std::vector<double> cosines_;  // Of each angle.
  std::vector<double> sines_;
  std::vector<int> votes_;
};

}  // namespace sbox
