// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/hough_votes.h"

#include <algorithm>
#include <cmath>

namespace sbox {

HoughVotes::HoughVotes(const StateGrid& grid, double theta_step, double rho_step)
    : resolution_(grid.resolution), rho_step_(rho_step) {
  const int angles = std::max(2, static_cast<int>(std::lround(M_PI / theta_step)));
  theta_step_ = M_PI / angles;
  const double width = grid.width * grid.resolution, height = grid.height * grid.resolution;
  // Normals in [0, pi) see the grid from -width to its diagonal.
  const int bins_below = static_cast<int>(std::ceil(width / rho_step)) + 1;
  rho_first_ = -bins_below * rho_step;
  rho_bins_ = bins_below + static_cast<int>(std::ceil(std::hypot(width, height) / rho_step)) + 2;
  for (int t = 0; t < angles; ++t) {
    cosines_.push_back(std::cos(t * theta_step_));
    sines_.push_back(std::sin(t * theta_step_));
  }
  votes_.assign(static_cast<size_t>(angles) * static_cast<size_t>(rho_bins_), 0);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (grid.at(x, y) == CellState::Occupied) {
        cast(x, y, 1);
      }
    }
  }
}

void HoughVotes::cast(int x, int y, int weight) {
  // In units of rho_step, counted from the middle of the first bin; truncation then rounds.
  const double px = (x + 0.5) * resolution_ / rho_step_, py = (y + 0.5) * resolution_ / rho_step_;
  const double first = rho_first_ / rho_step_ - 0.5;
  int* row = votes_.data();
  for (size_t t = 0; t < cosines_.size(); ++t, row += rho_bins_) {
    row[static_cast<int>(px * cosines_[t] + py * sines_[t] - first)] += weight;
  }
}

}  // namespace sbox
