// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbox {
namespace {

constexpr int kMostTiles = 512;  // A side; more would cost memory and find nothing faster.

double squaredDistance(const Point2D& p, const Point2D& q) {
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

double largestCornerDistance(const SuppositionalBox& box_a, const SuppositionalBox& box_b,
                             const Transform& to_b) {
  const Point2D first = to_b(box_a.corners[0]);
  size_t shift = 0;
  double nearest = std::numeric_limits<double>::max();
  for (size_t k = 0; k < 4; ++k) {
    const double d = squaredDistance(first, box_b.corners[k]);
    if (d < nearest) {
      nearest = d;
      shift = k;
    }
  }
  double largest = nearest;
  for (size_t i = 1; i < 4; ++i) {
    largest =
        std::max(largest, squaredDistance(to_b(box_a.corners[i]), box_b.corners[(i + shift) % 4]));
  }
  return std::sqrt(largest);
}

}  // namespace

double largestCornerDistance(const SuppositionalBox& box_a, const SuppositionalBox& box_b,
                             const Pose2D& pose_a_in_b) {
  return largestCornerDistance(box_a, box_b, Transform(pose_a_in_b));
}

AgreementIndex::AgreementIndex(const std::vector<SuppositionalBox>& boxes_a,
                               const std::vector<SuppositionalBox>& boxes_b, double side_tolerance,
                               const AgreementOptions& options)
    : boxes_a_(boxes_a),
      boxes_b_(boxes_b),
      side_tolerance_(side_tolerance),
      corner_distance_(options.corner_distance) {
  if (boxes_b.empty()) {
    return;
  }
  Point2D end = boxes_b.front().centre;
  corner_ = end;
  for (const SuppositionalBox& box : boxes_b) {
    corner_ = {std::min(corner_.x, box.centre.x), std::min(corner_.y, box.centre.y)};
    end = {std::max(end.x, box.centre.x), std::max(end.y, box.centre.y)};
  }
  const double extent = std::max(end.x - corner_.x, end.y - corner_.y);
  tile_size_ = std::max({corner_distance_, extent / kMostTiles, 1e-6});
  columns_ = column(end.x) + 1;
  rows_ = row(end.y) + 1;
  const auto tileOf = [&](const SuppositionalBox& box) {
    return static_cast<size_t>(row(box.centre.y) * columns_ + column(box.centre.x));
  };
  tile_begin_.assign(static_cast<size_t>(columns_) * static_cast<size_t>(rows_) + 1, 0);
  for (const SuppositionalBox& box : boxes_b) {
    ++tile_begin_[tileOf(box) + 1];
  }
  for (size_t t = 1; t < tile_begin_.size(); ++t) {
    tile_begin_[t] += tile_begin_[t - 1];
  }
  tile_boxes_.resize(boxes_b.size());
  std::vector<int> next(tile_begin_.begin(), tile_begin_.end() - 1);
  for (size_t b = 0; b < boxes_b.size(); ++b) {
    tile_boxes_[static_cast<size_t>(next[tileOf(boxes_b[b])]++)] = static_cast<int>(b);
  }
}

int AgreementIndex::column(double x) const {
  return static_cast<int>(std::floor(std::clamp((x - corner_.x) / tile_size_, -2.0, 1e6)));
}

int AgreementIndex::row(double y) const {
  return static_cast<int>(std::floor(std::clamp((y - corner_.y) / tile_size_, -2.0, 1e6)));
}

AgreementIndex::Partner AgreementIndex::nearestPartner(const SuppositionalBox& box_a,
                                                       const Transform& to_b, int except) const {
  Partner nearest{-1, corner_distance_};
  const Point2D centre = to_b(box_a.centre);
  const int first_column = std::max(0, column(centre.x - corner_distance_));
  const int last_column = std::min(columns_ - 1, column(centre.x + corner_distance_));
  const int first_row = std::max(0, row(centre.y - corner_distance_));
  const int last_row = std::min(rows_ - 1, row(centre.y + corner_distance_));
  for (int r = first_row; r <= last_row && first_column <= last_column; ++r) {
    const auto begin = static_cast<size_t>(r * columns_ + first_column);
    const auto end = static_cast<size_t>(r * columns_ + last_column) + 1;
    for (int i = tile_begin_[begin]; i < tile_begin_[end]; ++i) {
      const int b = tile_boxes_[static_cast<size_t>(i)];
      const SuppositionalBox& box_b = boxes_b_[static_cast<size_t>(b)];
      if (b == except ||
          squaredDistance(centre, box_b.centre) >= corner_distance_ * corner_distance_ ||
          !sidesAgree(box_a, box_b, side_tolerance_)) {
        continue;
      }
      const double distance = largestCornerDistance(box_a, box_b, to_b);
      if (distance < nearest.distance || (distance == nearest.distance && b < nearest.box)) {
        nearest = {b, distance};
      }
    }
  }
  return nearest;
}

Agreement AgreementIndex::find(const Pose2D& pose_a_in_b, const RoughMatch& own) const {
  const Transform to_b(pose_a_in_b);
  std::vector<Partner> partner_of_b(boxes_b_.size(), Partner{-1, corner_distance_});
  for (size_t a = 0; a < boxes_a_.size(); ++a) {
    if (static_cast<int>(a) == own.a) {
      continue;
    }
    const Partner partner = nearestPartner(boxes_a_[a], to_b, own.b);
    if (partner.box >= 0) {
      Partner& back = partner_of_b[static_cast<size_t>(partner.box)];
      if (partner.distance < back.distance) {
        back = {static_cast<int>(a), partner.distance};
      }
    }
  }
  Agreement agreement;
  for (size_t b = 0; b < partner_of_b.size(); ++b) {
    if (partner_of_b[b].box >= 0) {
      agreement.matches.push_back({partner_of_b[b].box, static_cast<int>(b)});
      agreement.distance_sum += partner_of_b[b].distance;
    }
  }
  std::sort(agreement.matches.begin(), agreement.matches.end(),
            [](const RoughMatch& p, const RoughMatch& q) { return p.a < q.a; });
  return agreement;
}

}  // namespace sbox
