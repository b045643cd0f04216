// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/axis_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sbox {
namespace {

/// A wall line in the axes of its class: u along, v across.
struct Stretch {
  double u_from, v_from, u_to, v_to;
  double wall_share;

  [[nodiscard]] double middle() const { return 0.5 * (v_from + v_to); }
  [[nodiscard]] double length() const { return u_to - u_from; }
};

int rootOf(std::vector<int>& parent, int i) {
  while (parent[static_cast<size_t>(i)] != i) {
    i = parent[static_cast<size_t>(i)] =
        parent[static_cast<size_t>(parent[static_cast<size_t>(i)])];
  }
  return i;
}

/// Whether `right` goes on where `left` ends, or runs beside it; left.u_from <= right.u_from.
bool areOneWall(const Stretch& left, const Stretch& right, const AxisLineOptions& options) {
  if (right.u_from - left.u_to > options.join_gap) {
    return false;
  }
  const double at = std::min(left.u_to, right.u_from);
  const double share = std::clamp((at - left.u_from) / left.length(), 0.0, 1.0);
  const double v_left = left.v_from + share * (left.v_to - left.v_from);
  return std::abs(v_left - right.v_from) <= options.join_offset;
}

/// Least squares line of v over u through all stretches, each as long as it is.
AxisLine joined(const std::vector<const Stretch*>& stretches) {
  double n = 0, u_sum = 0, v_sum = 0, wall = 0;
  AxisLine line;
  line.low = stretches.front()->u_from;
  line.high = stretches.front()->u_to;
  for (const Stretch* s : stretches) {
    n += s->length();
    u_sum += s->length() * 0.5 * (s->u_from + s->u_to);
    v_sum += s->length() * s->middle();
    wall += s->length() * s->wall_share;
    line.low = std::min(line.low, s->u_from);
    line.high = std::max(line.high, s->u_to);
  }
  const double u_mean = u_sum / n, v_mean = v_sum / n;
  double uu = 0, uv = 0;
  for (const Stretch* s : stretches) {
    const double u = 0.5 * (s->u_from + s->u_to) - u_mean, v = s->middle() - v_mean;
    uu += s->length() * (u * u + s->length() * s->length() / 12);
    uv += s->length() * (u * v + s->length() * (s->v_to - s->v_from) / 12);
  }
  line.slope = uv / uu;
  line.across = v_mean + line.slope * (0.5 * (line.low + line.high) - u_mean);
  line.wall_share = wall / n;
  return line;
}

std::vector<AxisLine> joinStretches(std::vector<Stretch> stretches,
                                    const AxisLineOptions& options) {
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
    return std::make_pair(a.middle(), a.u_from) < std::make_pair(b.middle(), b.u_from);
  });
  std::vector<int> parent(stretches.size());
  std::iota(parent.begin(), parent.end(), 0);
  // Stretches whose middles are further apart than this are not looked at as one wall.
  const double window = 4 * options.join_offset;
  for (size_t i = 0; i < stretches.size(); ++i) {
    for (size_t j = i + 1;
         j < stretches.size() && stretches[j].middle() - stretches[i].middle() <= window; ++j) {
      const bool in_order = stretches[i].u_from <= stretches[j].u_from;
      const Stretch& left = stretches[in_order ? i : j];
      const Stretch& right = stretches[in_order ? j : i];
      if (areOneWall(left, right, options)) {
        parent[static_cast<size_t>(rootOf(parent, static_cast<int>(j)))] =
            rootOf(parent, static_cast<int>(i));
      }
    }
  }
  std::vector<std::vector<const Stretch*>> groups(stretches.size());
  for (size_t i = 0; i < stretches.size(); ++i) {
    groups[static_cast<size_t>(rootOf(parent, static_cast<int>(i)))].push_back(&stretches[i]);
  }
  std::vector<AxisLine> lines;
  for (const std::vector<const Stretch*>& group : groups) {
    if (!group.empty()) {
      lines.push_back(joined(group));
    }
  }
  std::sort(lines.begin(), lines.end(), [](const AxisLine& a, const AxisLine& b) {
    return std::make_pair(a.across, a.low) < std::make_pair(b.across, b.low);
  });
  return lines;
}

/// A steeper line is a wall at another angle, not a bent one: 10 degrees.
constexpr double most_bent = 0.17;

}  // namespace

double AxisLine::cover(double from, double to) const {
  return to > from ? std::max(0.0, std::min(high, to) - std::max(low, from)) / (to - from) : 0;
}

double slopeSpread(const AxisLines& lines, double min_length) {
  double sum = 0, weight = 0;
  for (const std::vector<AxisLine>& side : lines) {
    for (const AxisLine& line : side) {
      const double length = line.high - line.low;
      if (length >= min_length && std::abs(line.slope) < most_bent) {
        sum += length * length * line.slope * line.slope;
        weight += length * length;
      }
    }
  }
  return weight > 0 ? std::sqrt(sum / weight) : 0;
}

AxisLines linesOfFrame(const std::vector<WallLine>& lines, const WallFrame& frame,
                       const AxisLineOptions& options) {
  const Eigen::Matrix2d to_frame = Eigen::Rotation2Dd(-frame.direction).toRotationMatrix();
  std::array<std::vector<Stretch>, 4> stretches;
  for (const WallLine& line : lines) {
    if (line.wall_share < options.min_wall_share) {
      continue;
    }
    const Eigen::Vector2d from = to_frame * line.from, to = to_frame * line.to;
    const Eigen::Vector2d normal = to_frame * line.normal();
    const double turns = std::atan2(normal.y(), normal.x()) / (M_PI / 2);
    const double nearest = std::round(turns);
    if (std::abs(turns - nearest) * 90 > options.max_tilt) {
      continue;
    }
    const Quarter side = (static_cast<int>(nearest) + 4) % 4;
    const int u = side % 2 == 0 ? 1 : 0, v = 1 - u;
    const Eigen::Vector2d& low = from[u] < to[u] ? from : to;
    const Eigen::Vector2d& high = from[u] < to[u] ? to : from;
    stretches[static_cast<size_t>(side)].push_back(
        {low[u], low[v], high[u], high[v], line.wall_share});
  }
  AxisLines result;
  for (size_t side = 0; side < 4; ++side) {
    result[side] = joinStretches(std::move(stretches[side]), options);
  }
  return result;
}

}  // namespace sbox
