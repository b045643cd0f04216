// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/hough_lines.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

#include "sbox/paper/hough_votes.h"

namespace sbox {
namespace {

/// A bin and the votes it had when it was last looked at. The strongest comes first.
struct RankedBin {
  int votes;
  int bin;
  bool operator<(const RankedBin& other) const {
    return votes != other.votes ? votes < other.votes : bin > other.bin;
  }
};

HoughLine makeLine(const HoughVotes& table, int bin, const std::vector<WallStretch>& stretches) {
  HoughLine line;
  line.theta = table.theta(bin);
  line.rho = table.rho(bin);
  line.votes = table.votes(bin);
  const double c = std::cos(line.theta), s = std::sin(line.theta);
  const double begin = stretches.front().begin, end = stretches.back().end;
  line.from = {line.rho * c - begin * s, line.rho * s + begin * c};
  line.to = {line.rho * c - end * s, line.rho * s + end * c};
  return line;
}

}  // namespace

std::vector<HoughLine> findHoughLines(const StateGrid& grid, const HoughOptions& options) {
  if (!(options.theta_step > 0) || !(options.rho_step > 0)) {
    throw std::invalid_argument("the steps of the Hough transform must be positive");
  }
  std::vector<HoughLine> lines;
  if (grid.empty()) {
    return lines;
  }
  StateGrid remaining = grid;
  HoughVotes table(grid, options.theta_step, std::max(options.rho_step, grid.resolution));
  // Two cells make a line; one is a dot.
  const int min_votes = std::max(
      2, static_cast<int>(std::ceil(options.stretches.min_length / grid.resolution - 1e-9)));
  std::vector<RankedBin> strong;
  for (int bin = 0; bin < table.bins(); ++bin) {
    if (table.votes(bin) >= min_votes) {
      strong.push_back({table.votes(bin), bin});
    }
  }
  std::priority_queue<RankedBin> queue(std::less<RankedBin>(), std::move(strong));
  while (!queue.empty() && lines.size() < static_cast<size_t>(std::max(0, options.max_lines))) {
    const RankedBin top = queue.top();
    queue.pop();
    // Votes only fall, so a bin that has kept its votes is the strongest of all.
    const int votes = table.votes(top.bin);
    if (votes < top.votes) {
      if (votes >= min_votes) {
        queue.push({votes, top.bin});
      }
      continue;
    }
    const std::vector<WallStretch> stretches =
        findWallStretches(remaining, table.theta(top.bin), table.rho(top.bin), options.stretches);
    if (stretches.empty()) {
      continue;
    }
    lines.push_back(makeLine(table, top.bin, stretches));
    for (const WallStretch& stretch : stretches) {
      for (const size_t cell : stretch.cells) {
        remaining.cells[cell] = CellState::Unknown;
        table.withdraw(static_cast<int>(cell % static_cast<size_t>(grid.width)),
                       static_cast<int>(cell / static_cast<size_t>(grid.width)));
      }
    }
  }
  return lines;
}

}  // namespace sbox
