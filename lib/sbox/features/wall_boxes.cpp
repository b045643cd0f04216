// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/wall_boxes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "sbox/core/sort_descending.h"

namespace sbox {
namespace {

/// A line and the side it faces.
struct Side {
  const AxisLine* line;
  Quarter facing;
};

std::vector<Side> sidesOf(const AxisLines& lines, Quarter first, Quarter second) {
  std::vector<Side> sides;
  for (const Quarter facing : {first, second}) {
    for (const AxisLine& line : lines[static_cast<size_t>(facing)]) {
      sides.push_back({&line, facing});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::make_tuple(a.line->across, a.line->low, a.facing) <
           std::make_tuple(b.line->across, b.line->low, b.facing);
  });
  return sides;
}

/// Sides by the bands along them: large maps have many that lie in line with a box but far off.
class Bands {
 public:
  /// Sides as sidesOf() gives them; a band is two `height` high and overlaps the next by half.
  Bands(const std::vector<Side>& sides, double height) : height_(height) {
    for (const Side& side : sides) {
      low_ = std::min(low_, side.line->low);
    }
    for (const Side& side : sides) {
      const size_t last = indexOf(side.line->high);
      bands_.resize(std::max(bands_.size(), last + 1));
      for (size_t i = indexOf(side.line->low - height); i <= last; ++i) {
        bands_[i].push_back(side);
      }
    }
  }

  /// All sides that touch [along, along + height], in their order.
  [[nodiscard]] const std::vector<Side>& near(double along) const {
    static const std::vector<Side> none;
    const size_t i = indexOf(along);
    return i < bands_.size() ? bands_[i] : none;
  }

 private:
  [[nodiscard]] size_t indexOf(double along) const {
    return static_cast<size_t>(std::max(0.0, std::floor((along - low_) / height_)));
  }

  double height_;
  double low_ = std::numeric_limits<double>::infinity();
  std::vector<std::vector<Side>> bands_;
};

/// A vertical side that reaches between two horizontal ones.
struct Reaching {
  Side side;
  double cover;
};

/// Boxes ordered by the length of their real sides; a long room's box tells more than a niche's.
double evidence(const WallBox& box) { return box.cover * (box.size_x + box.size_y); }

/// Lines up to 20 degrees off their axes make a box this much larger than their middles tell.
constexpr double kMargin = 1.1;

class BoxFinder {
 public:
  /// `floor`: evidence that boxes must exceed.
  BoxFinder(const AxisLines& lines, const BoxLimits& limits, double floor)
      : limits_(limits),
        horizontal_(sidesOf(lines, 1, 3)),
        vertical_(sidesOf(lines, 0, 2), limits.max_side),
        floor_(floor) {}

  std::vector<WallBox> find() {
    for (size_t i = 0; i < horizontal_.size(); ++i) {
      for (size_t j = i + 1; j < horizontal_.size(); ++j) {
        const double size = horizontal_[j].line->across - horizontal_[i].line->across;
        if (size > limits_.max_side) {
          break;
        }
        // The wider the box, the more evidence it can have.
        const double most =
            bound(horizontal_[i], horizontal_[j], limits_.max_side, 2) * (size + limits_.max_side);
        if (size >= limits_.min_side && kMargin * most > floor_) {
          findBetween(horizontal_[i], horizontal_[j]);
        }
      }
    }
    keepBest();
    return std::move(boxes_);
  }

 private:
  /// Mean cover of a box of this width at most, if its two vertical sides have `covers` together.
  static double bound(const Side& lower, const Side& upper, double width, double covers) {
    const auto cover = [&](const Side& side) {
      return std::min(1.0, (side.line->high - side.line->low) / width);
    };
    return (cover(lower) + cover(upper) + covers) / 4;
  }

  /// Evidence that no box of these sides and this height exceeds, of any width up to `widest`, if
  /// its two vertical sides have `covers` together.
  static double mostEvidence(const Side& lower, const Side& upper, double height, double widest,
                             double covers) {
    // What a side adds grows with the width up to its own length and falls from there on.
    const auto most = [&](const Side& side) {
      return height + std::min(side.line->high - side.line->low, widest);
    };
    return (most(lower) + most(upper) + covers * (height + widest)) / 4;
  }

  void findBetween(const Side& lower, const Side& upper) {
    // The upper and lower side must lie over each other somewhere, give or take a box.
    const double from = std::max(lower.line->low, upper.line->low) - limits_.max_side;
    const double to = std::min(lower.line->high, upper.line->high) + limits_.max_side;
    if (from > to) {
      return;
    }
    std::vector<Reaching> reaching;
    const std::vector<Side>& near = vertical_.near(lower.line->across);
    auto side = std::lower_bound(near.begin(), near.end(), from, [](const Side& s, double value) {
      return s.line->across < value;
    });
    for (; side != near.end() && side->line->across <= to; ++side) {
      const double cover = side->line->cover(lower.line->across, upper.line->across);
      if (cover >= limits_.min_cover) {
        reaching.push_back({*side, cover});
      }
    }
    if (reaching.empty()) {
      return;
    }
    const double height = upper.line->across - lower.line->across;
    const double most_cover =
        std::max_element(reaching.begin(), reaching.end(), [](const auto& a, const auto& b) {
          return a.cover < b.cover;
        })->cover;
    for (size_t k = 0; k < reaching.size(); ++k) {
      const double widest = std::min(
          limits_.max_side, reaching.back().side.line->across - reaching[k].side.line->across);
      if (kMargin * mostEvidence(lower, upper, height, widest, reaching[k].cover + most_cover) <=
          floor_) {
        continue;
      }
      for (size_t l = k + 1; l < reaching.size(); ++l) {
        const double left = reaching[k].side.line->across, right = reaching[l].side.line->across;
        if (right - left > limits_.max_side) {
          break;
        }
        const double size = height + right - left;
        if (right - left < limits_.min_side ||
            kMargin * bound(lower, upper, right - left, reaching[k].cover + reaching[l].cover) *
                    size <=
                floor_) {
          continue;
        }
        const double cover_lower = lower.line->cover(left, right);
        const double cover_upper = upper.line->cover(left, right);
        const double mean = (cover_lower + cover_upper + reaching[k].cover + reaching[l].cover) / 4;
        if (kMargin * mean * size > floor_ &&
            std::min(cover_lower, cover_upper) >= limits_.min_cover && mean >= limits_.mean_cover) {
          addBox(lower, upper, reaching[k].side, reaching[l].side, mean);
        }
      }
    }
  }

  void addBox(const Side& lower, const Side& upper, const Side& left, const Side& right,
              double cover) {
    WallBox box;
    box.corners = {crossing(*lower.line, *left.line), crossing(*lower.line, *right.line),
                   crossing(*upper.line, *right.line), crossing(*upper.line, *left.line)};
    box.centre = (box.corners[0] + box.corners[1] + box.corners[2] + box.corners[3]) / 4;
    box.size_x =
        ((box.corners[1] - box.corners[0]).norm() + (box.corners[2] - box.corners[3]).norm()) / 2;
    box.size_y =
        ((box.corners[3] - box.corners[0]).norm() + (box.corners[2] - box.corners[1]).norm()) / 2;
    const auto inward = [](const Side& side, Quarter place) {
      return side.facing == (place + 2) % 4 ? 1 << place : 0;
    };
    box.facing_in = static_cast<QuarterMask>(inward(right, 0) | inward(upper, 1) | inward(left, 2) |
                                             inward(lower, 3));
    box.cover = cover;
    if (evidence(box) <= floor_) {
      return;
    }
    boxes_.push_back(box);
    if (boxes_.size() >= 8 * static_cast<size_t>(limits_.max_boxes)) {
      keepBest();
    }
  }

  /// Keeps the boxes with most evidence.
  void keepBest() {
    if (boxes_.size() > static_cast<size_t>(limits_.max_boxes)) {
      sortDescending(boxes_, evidence);
      boxes_.resize(static_cast<size_t>(limits_.max_boxes));
      floor_ = evidence(boxes_.back());
    }
  }

  BoxLimits limits_;
  std::vector<Side> horizontal_;
  Bands vertical_;
  std::vector<WallBox> boxes_;
  double floor_;  ///< Evidence of the last box that is kept once there are too many.
};

/// The `count` longest lines (more where lengths are equal), in their order; there are more.
AxisLines longestLines(const AxisLines& lines, size_t count) {
  const auto length = [](const AxisLine& line) { return line.high - line.low; };
  std::vector<double> lengths;
  for (const std::vector<AxisLine>& side : lines) {
    for (const AxisLine& line : side) {
      lengths.push_back(length(line));
    }
  }
  const auto last = lengths.begin() + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(lengths.begin(), last, lengths.end(), std::greater<>());
  AxisLines longest;
  for (size_t side = 0; side < lines.size(); ++side) {
    std::copy_if(lines[side].begin(), lines[side].end(), std::back_inserter(longest[side]),
                 [&](const AxisLine& line) { return length(line) >= *last; });
  }
  return longest;
}

/// Evidence that a box of the longest lines alone has at least if it is to be kept.
double evidenceToBeat(const AxisLines& lines, const BoxLimits& limits) {
  constexpr size_t long_lines = 800;
  if (lines[0].size() + lines[1].size() + lines[2].size() + lines[3].size() <= 2 * long_lines) {
    return -1;
  }
  const std::vector<WallBox> boxes = BoxFinder(longestLines(lines, long_lines), limits, -1).find();
  if (boxes.empty() || static_cast<int>(boxes.size()) < limits.max_boxes) {
    return -1;
  }
  double least = evidence(boxes.front());
  for (const WallBox& box : boxes) {
    least = std::min(least, evidence(box));
  }
  return std::nextafter(least, 0.0);
}

}  // namespace

std::vector<WallBox> findBoxes(const AxisLines& lines, const BoxLimits& limits) {
  return BoxFinder(lines, limits, evidenceToBeat(lines, limits)).find();
}

}  // namespace sbox
