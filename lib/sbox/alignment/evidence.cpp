// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/alignment/evidence.h"

#include <algorithm>
#include <cmath>

#include "sbox/features/field_lookup.h"

namespace sbox {
namespace {

struct OneWay {
  Eigen::Matrix2d facing = Eigen::Matrix2d::Zero();  ///< In the frame of the walls' own map.
  WallSums straight, clutter;
  double free_free = 0;
};

/// The walls and free space of `from` looked up in the fields of `to`; `place` tells where a point
/// of the one lies in the other. Calls note(i, wall) with what was found of the i-th wall point,
/// metres.
template <typename Place, typename Note>
OneWay lookUp(const MapFeatures& from, const MapFeatures& to, double heading, const Place& place,
              size_t most_points, const EvidenceWeights& weights, const Note& note) {
  const WallFields& fields = to.fields;
  const ByteAngle turn = toByteAngle(heading);
  OneWay sum;
  const size_t walls = std::min(most_points, from.wall_points.size());
  const double per_point = from.wallLengthPerPoint(walls);
  forEachField(
      fields, walls, [&](size_t i) { return place(from.wall_points[i].position); },
      [&](size_t i) { return static_cast<ByteAngle>(from.wall_directions[i] + turn); },
      [&](size_t i, std::uint8_t distance, std::uint8_t depth) {
        const auto agree = static_cast<double>(weights.agree[distance]);
        const WallPoint& point = from.wall_points[i];
        sum.facing += agree * point.normal * point.normal.transpose();
        // Where the other map is free, it knows of the wall in full.
        const WallSums wall = {std::max(agree, static_cast<double>(depth > 0)), agree,
                               static_cast<double>(weights.conflict[depth]) * (1 - agree)};
        (point.line_length >= weights.straight_from ? sum.straight : sum.clutter) += wall;
        note(i, per_point * wall);
      });
  sum.facing *= per_point;
  sum.straight = per_point * sum.straight;
  sum.clutter = per_point * sum.clutter;

  const size_t free = std::min(most_points, from.free_points.size());
  size_t free_free = 0;
  forEachCell(
      fields, free, [&](size_t i) { return place(from.free_points[i]); },
      [&](size_t, const Eigen::Vector2d&, size_t cell) {
        free_free += fields.free_depth[cell] > 0 ? 1 : 0;
      });
  sum.free_free =
      static_cast<double>(free_free) * (free > 0 ? from.freeArea() / static_cast<double>(free) : 0);
  return sum;
}

Evidence sumUp(const OneWay& there, const OneWay& back, double heading) {
  Evidence evidence;
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(heading).toRotationMatrix();
  evidence.facing = turn * there.facing * turn.transpose() + back.facing;
  evidence.straight = there.straight + back.straight;
  static_cast<WallSums&>(evidence) = evidence.straight + (there.clutter + back.clutter);
  evidence.free_free = 0.5 * (there.free_free + back.free_free);
  return evidence;
}

}  // namespace

EvidenceWeights::EvidenceWeights(const EvidenceOptions& options)
    : straight_from(options.straight_from) {
  for (size_t i = 0; i < 256; ++i) {
    const double metres = static_cast<double>(i) * WallFields::unit;
    // At the largest value there is no wall within reach.
    agree[i] = i < WallFields::far
                   ? static_cast<float>(std::exp(-0.5 * std::pow(metres / options.kernel, 2)))
                   : 0.F;
    conflict[i] = static_cast<float>(conflictWeight(metres, options));
  }
}

double conflictWeight(double depth, const EvidenceOptions& options) {
  return std::clamp(
      (depth - options.conflict_from) / (options.conflict_full - options.conflict_from), 0.0, 1.0);
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
