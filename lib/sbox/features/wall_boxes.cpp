// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/wall_boxes.h"

#include <algorithm>
#include <cmath>

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

/// A vertical side that reaches between two horizontal ones.
struct Reaching {
  Side side;
  double cover;
};

/// Boxes ordered by the length of their real sides; a long room's box tells more than a niche's.
double evidence(const WallBox& box) { return box.cover * (box.size_x + box.size_y); }

class BoxFinder {
 public:
  BoxFinder(const AxisLines& lines, const BoxLimits& limits)
      : limits_(limits), horizontal_(sidesOf(lines, 1, 3)), vertical_(sidesOf(lines, 0, 2)) {}

  std::vector<WallBox> find() {
    for (size_t i = 0; i < horizontal_.size(); ++i) {
      for (size_t j = i + 1; j < horizontal_.size(); ++j) {
        const double size = horizontal_[j].line->across - horizontal_[i].line->across;
        if (size > limits_.max_side) {
          break;
        }
        if (size >= limits_.min_side) {
          findBetween(horizontal_[i], horizontal_[j]);
        }
      }
    }
    keepBest();
    return std::move(boxes_);
  }

 private:
  void findBetween(const Side& lower, const Side& upper) {
    // The upper and lower side must lie over each other somewhere, give or take a box.
    const double from = std::max(lower.line->low, upper.line->low) - limits_.max_side;
    const double to = std::min(lower.line->high, upper.line->high) + limits_.max_side;
    std::vector<Reaching> reaching;
    auto side =
        std::lower_bound(vertical_.begin(), vertical_.end(), from,
                         [](const Side& s, double value) { return s.line->across < value; });
    for (; side != vertical_.end() && side->line->across <= to; ++side) {
      const double cover = side->line->cover(lower.line->across, upper.line->across);
      if (cover >= limits_.min_cover) {
        reaching.push_back({*side, cover});
      }
    }
    for (size_t k = 0; k < reaching.size(); ++k) {
      for (size_t l = k + 1; l < reaching.size(); ++l) {
        const double left = reaching[k].side.line->across, right = reaching[l].side.line->across;
        if (right - left > limits_.max_side) {
          break;
        }
        if (right - left < limits_.min_side) {
          continue;
        }
        const double cover_lower = lower.line->cover(left, right);
        const double cover_upper = upper.line->cover(left, right);
        const double mean = (cover_lower + cover_upper + reaching[k].cover + reaching[l].cover) / 4;
        const double size = upper.line->across - lower.line->across + right - left;
        // Lines off their axes make a box a little larger than this tells.
        constexpr double margin = 1.5;
        if (margin * mean * size > floor_ &&
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
      std::stable_sort(boxes_.begin(), boxes_.end(), [](const WallBox& a, const WallBox& b) {
        return evidence(a) > evidence(b);
      });
      boxes_.resize(static_cast<size_t>(limits_.max_boxes));
      floor_ = evidence(boxes_.back());
    }
  }

  BoxLimits limits_;
  std::vector<Side> horizontal_;
  std::vector<Side> vertical_;
  std::vector<WallBox> boxes_;
  double floor_ = -1;  ///< Evidence of the last box that is kept once there are too many.
};

}  // namespace

std::vector<WallBox> findBoxes(const AxisLines& lines, const BoxLimits& limits) {
  return BoxFinder(lines, limits).find();
}

}  // namespace sbox
