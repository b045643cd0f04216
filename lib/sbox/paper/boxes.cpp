// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/paper/boxes.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/sort_descending.h"

namespace sbox {
namespace {

using ClusterLoop = std::array<int, 4>;

/// For each pair of lines the cluster of their vertical point, or -1: square, flat.
class CrossingTable {
 public:
  CrossingTable(const std::vector<VerticalPoint>& points,
                const std::vector<PointCluster>& clusters) {
    for (const VerticalPoint& point : points) {
      lines_ = std::max(lines_, point.line2 + 1);
    }
    clusters_.assign(static_cast<size_t>(lines_) * static_cast<size_t>(lines_), -1);
    for (size_t c = 0; c < clusters.size(); ++c) {
      for (const int member : clusters[c].members) {
        const VerticalPoint& point = points[static_cast<size_t>(member)];
        clusters_[index(point.line1, point.line2)] = static_cast<int>(c);
        clusters_[index(point.line2, point.line1)] = static_cast<int>(c);
      }
    }
  }
  [[nodiscard]] int lines() const { return lines_; }
  [[nodiscard]] int at(int line1, int line2) const { return clusters_[index(line1, line2)]; }

 private:
  [[nodiscard]] size_t index(int line1, int line2) const {
    return static_cast<size_t>(line1) * static_cast<size_t>(lines_) + static_cast<size_t>(line2);
  }
  int lines_ = 0;
  std::vector<int> clusters_;
};

double distance(const Point2D& p, const Point2D& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// Twice the signed area of the triangle p, q, r.
double turn(const Point2D& p, const Point2D& q, const Point2D& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Whether the loop turns the same way at each corner: neither crossed nor degenerate.
bool isConvex(const std::array<Point2D, 4>& z) {
  const double first = turn(z[0], z[1], z[2]);
  return first * turn(z[1], z[2], z[3]) > 0 && first * turn(z[2], z[3], z[0]) > 0 &&
         first * turn(z[3], z[0], z[1]) > 0;
}

std::array<Point2D, 4> cornersOf(const ClusterLoop& loop,
                                 const std::vector<PointCluster>& clusters) {
  std::array<Point2D, 4> corners;
  for (size_t i = 0; i < 4; ++i) {
    corners[i] = clusters[static_cast<size_t>(loop[i])].position;
  }
  return corners;
}

bool withinLimits(const std::array<Point2D, 4>& z, const BoxOptions& options) {
  const double side1 = distance(z[0], z[1]), side2 = distance(z[1], z[2]);
  return std::min(side1, side2) >= options.min_width &&
         std::max(side1, side2) <= options.max_height && isConvex(z);
}

/// The same loop, begun at its lowest cluster and gone round the way of its lower neighbour.
ClusterLoop canonical(ClusterLoop loop) {
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  if (loop[3] < loop[1]) {
    std::swap(loop[1], loop[3]);
  }
  return loop;
}

std::vector<ClusterLoop> findLoops(const CrossingTable& crossings,
                                   const std::vector<PointCluster>& clusters,
                                   const BoxOptions& options) {
  std::vector<ClusterLoop> loops;
  std::vector<int> shared;  // Lines that cross both of a pair.
  for (int l1 = 0; l1 < crossings.lines(); ++l1) {
    for (int l2 = l1 + 1; l2 < crossings.lines(); ++l2) {
      shared.clear();
      // l1 is the lowest of the four lines, so that each box is met once.
      for (int m = l1 + 1; m < crossings.lines(); ++m) {
        if (crossings.at(l1, m) >= 0 && crossings.at(l2, m) >= 0) {
          shared.push_back(m);
        }
      }
      for (size_t i = 0; i < shared.size(); ++i) {
        for (size_t j = i + 1; j < shared.size(); ++j) {
          const ClusterLoop loop = {crossings.at(l1, shared[i]), crossings.at(l1, shared[j]),
                                    crossings.at(l2, shared[j]), crossings.at(l2, shared[i])};
          if (withinLimits(cornersOf(loop, clusters), options)) {
            loops.push_back(canonical(loop));
          }
        }
      }
    }
  }
  std::sort(loops.begin(), loops.end());
  loops.erase(std::unique(loops.begin(), loops.end()), loops.end());
  return loops;
}

}  // namespace

SuppositionalBox describeBox(const std::array<Point2D, 4>& loop) {
  SuppositionalBox box;
  box.corners = loop;
  std::array<Point2D, 4>& z = box.corners;
  if (turn(z[0], z[1], z[2]) < 0) {
    std::swap(z[1], z[3]);
  }
  const auto lower_left =
      std::min_element(z.begin(), z.end(), [](const Point2D& p, const Point2D& q) {
        return p.x + p.y != q.x + q.y ? p.x + p.y < q.x + q.y : p.x < q.x;
      });
  std::rotate(z.begin(), lower_left, z.end());
  const double side1 = distance(z[0], z[1]), side2 = distance(z[1], z[2]);
  box.height = std::max(side1, side2);
  box.width = std::min(side1, side2);
  box.area = box.height * box.width;
  for (const Point2D& corner : z) {
    box.centre.x += corner.x / 4;
    box.centre.y += corner.y / 4;
  }
  return box;
}

std::vector<SuppositionalBox> buildBoxes(const std::vector<VerticalPoint>& points,
                                         const std::vector<PointCluster>& clusters,
                                         const BoxOptions& options) {
  std::vector<SuppositionalBox> boxes;
  for (const ClusterLoop& loop : findLoops(CrossingTable(points, clusters), clusters, options)) {
    boxes.push_back(describeBox(cornersOf(loop, clusters)));
  }
  sortDescending(boxes, [](const SuppositionalBox& box) { return box.area; });
  boxes.resize(std::min(boxes.size(), static_cast<size_t>(std::max(0, options.max_boxes))));
  return boxes;
}

}  // namespace sbox
