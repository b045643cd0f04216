// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/matching/feature_votes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "sbox/matching/turned_bounds.h"

namespace sbox {
namespace {

/// A pair of features that look alike, and where it puts the centre of map b, in a's frame axes.
struct Ballot {
  Eigen::Vector2d centre_b;
  int feature_a;
  int feature_b;
};

/// p turned by quarter turns about the origin.
Eigen::Vector2d quarterTurned(const Eigen::Vector2d& p, int turns) {
  switch (turns & 3) {
    case 0:
      return p;
    case 1:
      return {-p.y(), p.x()};
    case 2:
      return -p;
    default:
      return {p.y(), -p.x()};
  }
}

/// Translations counted in square bins.
class VoteGrid {
 public:
  VoteGrid(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double bin)
      : low_(low), bin_(bin) {
    const Eigen::Vector2d size = (high - low) / bin;
    width_ = static_cast<int>(std::ceil(size.x())) + 3;
    height_ = static_cast<int>(std::ceil(size.y())) + 3;
    weights_.resize(static_cast<size_t>(width_) * static_cast<size_t>(height_));
    sums_.resize(weights_.size());
  }

  /// Forgets all votes.
  void clear() { std::fill(weights_.begin(), weights_.end(), 0); }

  /// Each ballot counts less the more often its features were used: rows of equal things would
  /// outvote the rest.
  void count(const std::vector<Ballot>& ballots, size_t features_a, size_t features_b,
             double weight) {
    std::vector<int> uses_a(features_a, 0), uses_b(features_b, 0);
    for (const Ballot& ballot : ballots) {
      ++uses_a[static_cast<size_t>(ballot.feature_a)];
      ++uses_b[static_cast<size_t>(ballot.feature_b)];
    }
    for (const Ballot& ballot : ballots) {
      const double uses = static_cast<double>(uses_a[static_cast<size_t>(ballot.feature_a)]) *
                          uses_b[static_cast<size_t>(ballot.feature_b)];
      add(ballot.centre_b, weight / std::sqrt(uses));
    }
  }

  /// Every bin that holds votes: their mean place, and the votes in it and the bins round it.
  template <typename Take>
  void forEachBin(const Take& take) const {
    for (int y = 1; y + 1 < height_; ++y) {
      for (int x = 1; x + 1 < width_; ++x) {
        const size_t here = binAt(x, y);
        if (weights_[here] <= 0) {
          continue;
        }
        double around = 0;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            around += weights_[binAt(x + dx, y + dy)];
          }
        }
        take(sums_[here] / weights_[here], around);
      }
    }
  }

 private:
  [[nodiscard]] size_t binAt(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }

  void add(const Eigen::Vector2d& point, double weight) {
    const Eigen::Vector2d place = (point - low_) / bin_;
    const int x = static_cast<int>(std::floor(place.x())) + 1;
    const int y = static_cast<int>(std::floor(place.y())) + 1;
    if (x < 1 || y < 1 || x + 1 >= width_ || y + 1 >= height_) {
      return;
    }
    const size_t bin = binAt(x, y);
    if (weights_[bin] <= 0) {
      sums_[bin].setZero();
    }
    weights_[bin] += weight;
    sums_[bin] += weight * point;
  }

  Eigen::Vector2d low_;
  double bin_;
  int width_ = 0;
  int height_ = 0;
  std::vector<double> weights_;        ///< Of each bin's votes.
  std::vector<Eigen::Vector2d> sums_;  ///< Of their weighted places; of no meaning without votes.
};

/// Corners with one signature: the same free sides and the same arms.
std::array<std::vector<int>, 256> bySignature(const std::vector<WallCorner>& corners, int turns) {
  std::array<std::vector<int>, 256> buckets;
  for (size_t i = 0; i < corners.size(); ++i) {
    const auto signature = static_cast<size_t>(turned(corners[i].free_sides, turns) |
                                               (turned(corners[i].arms, turns) << 4));
    buckets[signature].push_back(static_cast<int>(i));
  }
  return buckets;
}

std::vector<Ballot> cornerBallots(const std::vector<WallCorner>& a,
                                  const std::vector<WallCorner>& b, int turns,
                                  const Eigen::Vector2d& centre_b) {
  const auto buckets_a = bySignature(a, 0), buckets_b = bySignature(b, turns);
  std::vector<Ballot> ballots;
  for (size_t signature = 0; signature < buckets_a.size(); ++signature) {
    for (const int i : buckets_a[signature]) {
      for (const int j : buckets_b[signature]) {
        ballots.push_back({a[static_cast<size_t>(i)].position +
                               quarterTurned(centre_b - b[static_cast<size_t>(j)].position, turns),
                           i, j});
      }
    }
  }
  return ballots;
}

std::vector<Ballot> boxBallots(const std::vector<WallBox>& a, const std::vector<WallBox>& b,
                               int turns, const Eigen::Vector2d& centre_b,
                               const VoteOptions& options) {
  // Boxes of b by signature and width, so that only near widths are looked at.
  struct Sized {
    double size_x, size_y;
    int index;
  };
  std::array<std::vector<Sized>, 16> buckets;
  for (size_t j = 0; j < b.size(); ++j) {
    const bool swapped = turns % 2 != 0;
    buckets[turned(b[j].facing_in, turns)].push_back({swapped ? b[j].size_y : b[j].size_x,
                                                      swapped ? b[j].size_x : b[j].size_y,
                                                      static_cast<int>(j)});
  }
  for (std::vector<Sized>& bucket : buckets) {
    std::sort(bucket.begin(), bucket.end(), [](const Sized& left, const Sized& right) {
      return std::make_pair(left.size_x, left.index) < std::make_pair(right.size_x, right.index);
    });
  }
  std::vector<Ballot> ballots;
  for (size_t i = 0; i < a.size(); ++i) {
    const std::vector<Sized>& bucket = buckets[a[i].facing_in];
    const auto tolerance = [&](double size) {
      return options.size_tolerance + options.size_ratio * size;
    };
    auto box = std::lower_bound(bucket.begin(), bucket.end(), a[i].size_x - tolerance(a[i].size_x),
                                [](const Sized& s, double value) { return s.size_x < value; });
    for (; box != bucket.end() && box->size_x <= a[i].size_x + tolerance(a[i].size_x); ++box) {
      if (std::abs(box->size_y - a[i].size_y) <= tolerance(a[i].size_y)) {
        const Eigen::Vector2d& centre = b[static_cast<size_t>(box->index)].centre;
        ballots.push_back({a[i].centre + quarterTurned(centre_b - centre, turns),
                           static_cast<int>(i), box->index});
      }
    }
  }
  return ballots;
}

/// For all places at which the centre of map b can lie if the maps meet.
VoteGrid gridFor(const MapFeatures& map_a, const MapFeatures& map_b, const WallFrame& frame_a,
                 const VoteOptions& options) {
  const TurnedBounds bounds = turnedBounds(map_a, -frame_a.direction);
  const Eigen::Vector2d radius_b =
      Eigen::Vector2d::Constant(std::hypot(map_b.width, map_b.height) / 2);
  const Eigen::Vector2d low = bounds.low - radius_b, high = bounds.high + radius_b;
  const double least_bin = std::sqrt((high - low).prod() / options.most_bins);
  return {low, high, std::max(options.bin, least_bin)};
}

std::vector<Hypothesis> voteForTurn(const MapFeatures& map_b, const FrameFeatures& a,
                                    const FrameFeatures& b, int turns, const VoteOptions& options,
                                    VoteGrid& grid) {
  const Eigen::Matrix2d to_grid_a = Eigen::Rotation2Dd(a.frame.direction).toRotationMatrix();
  const Eigen::Vector2d centre_in_grid_b = map_b.middle();
  const Eigen::Vector2d centre_b = Eigen::Rotation2Dd(-b.frame.direction) * centre_in_grid_b;
  grid.clear();
  grid.count(cornerBallots(a.corners, b.corners, turns, centre_b), a.corners.size(),
             b.corners.size(), 1.0);
  grid.count(boxBallots(a.boxes, b.boxes, turns, centre_b, options), a.boxes.size(), b.boxes.size(),
             options.box_weight);

  const double heading = a.frame.direction - b.frame.direction + turns * M_PI / 2;
  const Eigen::Vector2d arm = Eigen::Rotation2Dd(heading) * centre_in_grid_b;
  std::vector<Hypothesis> hypotheses;
  grid.forEachBin([&](const Eigen::Vector2d& centre_b_in_a, double votes) {
    const Eigen::Vector2d translation = to_grid_a * centre_b_in_a - arm;
    hypotheses.push_back({{heading, translation}, votes});
  });
  return hypotheses;
}

void keepBest(std::vector<Hypothesis>& hypotheses, int count) {
  const auto better = [](const Hypothesis& left, const Hypothesis& right) {
    return std::make_tuple(-left.votes, left.b_in_a.heading, left.b_in_a.translation.x(),
                           left.b_in_a.translation.y()) <
           std::make_tuple(-right.votes, right.b_in_a.heading, right.b_in_a.translation.x(),
                           right.b_in_a.translation.y());
  };
  if (static_cast<int>(hypotheses.size()) > count) {
    std::nth_element(hypotheses.begin(), hypotheses.begin() + count, hypotheses.end(), better);
    hypotheses.resize(static_cast<size_t>(count));
  }
  std::sort(hypotheses.begin(), hypotheses.end(), better);
}

}  // namespace

std::vector<Hypothesis> voteForTransforms(const MapFeatures& a, const MapFeatures& b,
                                          const VoteOptions& options) {
  std::vector<Hypothesis> best, rest;
  for (const FrameFeatures& frame_a : a.frames) {
    VoteGrid grid = gridFor(a, b, frame_a.frame, options);
    for (const FrameFeatures& frame_b : b.frames) {
      for (int turns = 0; turns < 4; ++turns) {
        std::vector<Hypothesis> found = voteForTurn(b, frame_a, frame_b, turns, options, grid);
        keepBest(found, options.max_hypotheses);
        const size_t sure = std::min(found.size(), static_cast<size_t>(options.min_per_heading));
        best.insert(best.end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(sure));
        rest.insert(rest.end(), found.begin() + static_cast<std::ptrdiff_t>(sure), found.end());
      }
    }
  }
  keepBest(rest, std::max(0, options.max_hypotheses - static_cast<int>(best.size())));
  best.insert(best.end(), rest.begin(), rest.end());
  keepBest(best, static_cast<int>(best.size()));
  return best;
}

}  // namespace sbox
