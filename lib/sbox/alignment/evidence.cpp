// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/alignment/evidence.h"

#include <algorithm>
#include <cmath>

#include "sbox/features/field_lookup.h"

namespace sbox {
namespace {

/// Calls note(i, wall, depth) with what is found of each of the first `count` wall points of `from`
/// in the fields of `to`, per metre of wall, and how deep it lies there; `place` tells where a
/// point of the one lies in the other.
template <typename Place, typename Note>
void lookWallsUp(const MapFeatures& from, const MapFeatures& to, double heading, const Place& place,
                 size_t count, const EvidenceWeights& weights, const Note& note) {
  const ByteAngle turn = toByteAngle(heading);
  forEachField(
      to.fields, count, [&](size_t i) { return place(from.wall_points[i].position); },
      [&](size_t i) { return static_cast<ByteAngle>(from.wall_directions[i] + turn); },
      [&](size_t i, std::uint8_t distance, std::uint8_t depth) {
        const double agree = weights.agree[distance];
        // Where the other map is free, it knows of the wall in full.
        const WallSums wall = {std::max(agree, static_cast<double>(depth > 0)), agree,
                               weights.conflict[depth] * (1 - agree)};
        note(i, wall, depth);
      });
}

/// Free space of `from` that is free in `to`, square metres. Calls note(i, depth) with how deep the
/// i-th free point lies there.
template <typename Place, typename Note>
double freeInBoth(const MapFeatures& from, const MapFeatures& to, const Place& place, size_t count,
                  const Note& note) {
  size_t free = 0;
  forEachDepth(
      to.fields, count, [&](size_t i) { return place(from.free_points[i]); },
      [&](size_t i, std::uint8_t depth) {
        free += depth > 0 ? 1 : 0;
        note(i, depth);
      });
  return static_cast<double>(free) * from.freeAreaPerPoint(count);
}

/// What measureOverlap() finds of the walls and the free space of `from` alone.
Overlap overlapOneWay(const MapFeatures& from, const MapFeatures& to, const RigidTransform& to_from,
                      size_t most_points, const EvidenceWeights& weights) {
  const PointMover place(to_from);
  const size_t count = std::min(most_points, from.wall_points.size());
  WallSums sum;
  lookWallsUp(from, to, to_from.heading, place, count, weights,
              [&](size_t, const WallSums& wall, std::uint8_t) { sum += wall; });
  const size_t free_count = std::min(most_points, from.free_points.size());
  return {from.wallLengthPerPoint(count) * sum,
          freeInBoth(from, to, place, free_count, [](size_t, std::uint8_t) {})};
}

struct OneWay {
  Eigen::Matrix2d facing = Eigen::Matrix2d::Zero();  ///< In the frame of the walls' own map.
  WallSums straight, clutter;
  double shallow_conflict = 0, deep_conflict = 0;
  double free_free = 0, free_shallow = 0;
};

/// The walls and free space of `from` looked up in the fields of `to`. Calls note(i, wall) with
/// what was found of the i-th wall point, metres.
template <typename Place, typename Note>
OneWay lookUp(const MapFeatures& from, const MapFeatures& to, double heading, const Place& place,
              size_t most_points, const EvidenceWeights& weights, const Note& note) {
  OneWay sum;
  const size_t count = std::min(most_points, from.wall_points.size());
  const double per_point = from.wallLengthPerPoint(count);
  lookWallsUp(from, to, heading, place, count, weights,
              [&](size_t i, const WallSums& wall, std::uint8_t depth) {
                const WallPoint& point = from.wall_points[i];
                sum.facing += wall.agree * point.normal * point.normal.transpose();
                if (point.line_length >= weights.straight_from) {
                  sum.straight += wall;
                  sum.shallow_conflict += weights.shallow[depth] * (1 - wall.agree);
                  sum.deep_conflict += weights.deep[depth] * (1 - wall.agree);
                } else {
                  sum.clutter += wall;
                }
                note(i, per_point * wall);
              });
  sum.facing *= per_point;
  sum.shallow_conflict *= per_point;
  sum.deep_conflict *= per_point;
  sum.straight = per_point * sum.straight;
  sum.clutter = per_point * sum.clutter;
  const size_t free_count = std::min(most_points, from.free_points.size());
  size_t shallow = 0;
  sum.free_free = freeInBoth(from, to, place, free_count, [&](size_t i, std::uint8_t depth_there) {
    const double depth =
        std::min(depth_there, from.fields.depthAt(from.free_points[i])) * WallFields::depth_unit;
    shallow += depth_there > 0 && depth <= weights.shallow_until ? 1 : 0;
  });
  sum.free_shallow = static_cast<double>(shallow) * from.freeAreaPerPoint(free_count);
  return sum;
}

Evidence sumUp(const OneWay& there, const OneWay& back, double heading) {
  Evidence evidence;
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(heading).toRotationMatrix();
  evidence.facing = turn * there.facing * turn.transpose() + back.facing;
  evidence.straight = there.straight + back.straight;
  static_cast<WallSums&>(evidence) = evidence.straight + (there.clutter + back.clutter);
  evidence.shallow_conflict = there.shallow_conflict + back.shallow_conflict;
  evidence.deep_conflict = there.deep_conflict + back.deep_conflict;
  evidence.free_free = 0.5 * (there.free_free + back.free_free);
  evidence.free_shallow = 0.5 * (there.free_shallow + back.free_shallow);
  return evidence;
}

/// Rises from 0 at `from` to 1 at `full`; 0 of what is not free.
double weightOfDepth(double depth, double from, double full) {
  if (depth <= 0) {
    return 0;
  }
  if (depth >= full) {
    return 1;
  }
  return depth <= from ? 0 : (depth - from) / (full - from);
}

}  // namespace

EvidenceWeights::EvidenceWeights(const EvidenceOptions& options)
    : straight_from(options.straight_from), shallow_until(options.shallow_until) {
  for (size_t i = 0; i < 256; ++i) {
    const double distance = static_cast<double>(i) * WallFields::unit;
    // At the largest value there is no wall within reach.
    agree[i] = i < WallFields::far ? std::exp(-0.5 * std::pow(distance / options.kernel, 2)) : 0;
    const double depth = static_cast<double>(i) * WallFields::depth_unit;
    conflict[i] = conflictWeight(depth, options);
    shallow[i] = depth <= shallow_until ? conflict[i] : 0;
    deep[i] = deepWeight(depth, options);
  }
}

double conflictWeight(double depth, const EvidenceOptions& options) {
  return weightOfDepth(depth, options.conflict_from, options.conflict_full);
}

double deepWeight(double depth, const EvidenceOptions& options) {
  return weightOfDepth(depth, options.deep_from, options.deep_full);
}

Overlap measureOverlap(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
                       size_t most_points, const EvidenceWeights& weights) {
  const Overlap there = overlapOneWay(b, a, b_in_a, most_points, weights);
  const Overlap back = overlapOneWay(a, b, b_in_a.inverse(), most_points, weights);
  return {there + back, 0.5 * (there.free_free + back.free_free)};
}

Evidence gatherEvidence(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
                        size_t most_points, const EvidenceWeights& weights) {
  const auto ignore = [](size_t, const WallSums&) {};
  return sumUp(
      lookUp(b, a, b_in_a.heading, PointMover(b_in_a), most_points, weights, ignore),
      lookUp(a, b, -b_in_a.heading, PointMover(b_in_a.inverse()), most_points, weights, ignore),
      b_in_a.heading);
}

Evidence gatherEvidence(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
                        const DriftField& drift, size_t most_points,
                        const EvidenceWeights& weights) {
  const PointMover to_a(b_in_a), to_b(b_in_a.inverse());
  const auto bent_to_a = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d rigid = to_a(p);
    return Eigen::Vector2d(rigid + drift.at(rigid));
  };
  const auto bent_to_b = [&](const Eigen::Vector2d& p) { return to_b(p - drift.at(p)); };
  RoomTally rooms({0, 0}, {a.width, a.height});
  const OneWay there = lookUp(
      b, a, b_in_a.heading, bent_to_a, most_points, weights,
      [&](size_t i, const WallSums& wall) { rooms.add(to_a(b.wall_points[i].position), wall); });
  const OneWay back =
      lookUp(a, b, -b_in_a.heading, bent_to_b, most_points, weights,
             [&](size_t i, const WallSums& wall) { rooms.add(a.wall_points[i].position, wall); });
  Evidence evidence = sumUp(there, back, b_in_a.heading);
  evidence.rooms = rooms.counts();
  return evidence;
}

}  // namespace sbox
