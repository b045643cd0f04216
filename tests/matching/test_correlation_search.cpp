// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "catch.h"
#include "drawing.h"
#include "sbox/alignment/plausibility.h"
#include "sbox/matching/correlation_search.h"

using namespace sbox;
using Eigen::Vector2d;

namespace {

constexpr double kCell = 0.8;

/// Walls and free points in the middles of cells of 0.8 m, so that pictures of the map hold them as
/// they are. Walls face along the axes.
MapFeatures cellularMap(unsigned seed, int columns, int rows, int walls) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  MapFeatures map;
  map.width = columns * kCell;
  map.height = rows * kCell;
  map.point_spacing = 0.4;
  map.free_point_area = kCell * kCell;
  StateGrid grid = test::freeGrid(columns * 8, rows * 8, 0.1);
  for (int i = 0; i < walls; ++i) {
    const Vector2d position = kCell * Vector2d(below(columns) + 0.5, below(rows) + 0.5);
    // Unequal shares of the four, so that no turned map fits as well.
    const int facing = below(8) < 4 ? 0 : below(4);
    const std::vector<Vector2d> normals{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    map.wall_points.push_back({position, normals[static_cast<size_t>(facing)]});
    map.wall_directions.push_back(static_cast<ByteAngle>(64 * facing));
    test::drawWall(grid, {{position.x(), position.y()}, {position.x() + 0.05, position.y()}});
  }
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      if (below(4) != 0) {
        map.free_points.emplace_back(kCell * (x + 0.5), kCell * (y + 0.5));
      }
    }
  }
  map.fields = makeFields(grid, map.wall_points);
  return map;
}

std::pair<int, int> cellOf(const Vector2d& p) {
  return {static_cast<int>(std::floor(p.x() / kCell)), static_cast<int>(std::floor(p.y() / kCell))};
}

/// Whether cells are free, and the share of each in which a wall conflicts.
struct CellSums {
  std::map<std::pair<int, int>, double> wall, free, conflict;

  CellSums(const MapFeatures& map, const EvidenceOptions& evidence) {
    for (const WallPoint& point : map.wall_points) {
      wall[cellOf(point.position)] += map.point_spacing;
    }
    for (const Vector2d& p : map.free_points) {
      free[cellOf(p)] += 1;
      conflict[cellOf(p)] +=
          conflictWeight(map.fields.depthAt(p) * WallFields::depth_unit, evidence);
    }
  }
};

double product(const std::map<std::pair<int, int>, double>& a,
               const std::map<std::pair<int, int>, double>& b, int shift_x, int shift_y) {
  double sum = 0;
  for (const auto& [cell, value] : b) {
    const auto in_a = a.find({cell.first + shift_x, cell.second + shift_y});
    sum += in_a != a.end() ? value * in_a->second : 0;
  }
  return sum;
}

/// How strongly the walls of a speak for a wall in this cell, by the direction it faces.
Vector2d agreementAt(const MapFeatures& a, const std::pair<int, int>& cell, double blur) {
  Vector2d sum = Vector2d::Zero();
  for (const WallPoint& point : a.wall_points) {
    const auto [x, y] = cellOf(point.position);
    const double squared =
        std::pow(kCell * (cell.first - x), 2) + std::pow(kCell * (cell.second - y), 2);
    sum += a.point_spacing / (std::sqrt(2 * M_PI) * blur) *
           std::exp(-0.5 * squared / (blur * blur)) * point.normal;
  }
  return sum.cwiseMin(1.0).cwiseMax(-1.0);
}

/// The score of every shift, each summed by itself; unturned maps.
std::map<std::pair<int, int>, double> scoresOfAllShifts(const MapFeatures& a, const MapFeatures& b,
                                                        const CorrelationSearchOptions& options,
                                                        const EvidenceOptions& weights) {
  const double blur = std::max(options.wall_blur, 0.8 * kCell);
  const CellSums sums_a(a, weights), sums_b(b, weights);
  std::map<std::pair<int, int>, double> scores;
  const int reach = 30;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      Evidence evidence;
      double agree = 0;
      for (const WallPoint& point : b.wall_points) {
        const auto [cx, cy] = cellOf(point.position);
        agree += b.point_spacing * agreementAt(a, {cx + x, cy + y}, blur).dot(point.normal);
      }
      evidence.agree = 2 * std::max(0.0, agree);
      evidence.known = product(sums_a.free, sums_b.wall, x, y) +
                       product(sums_a.wall, sums_b.free, x, y) + evidence.agree;
      evidence.conflict =
          product(sums_a.conflict, sums_b.wall, x, y) + product(sums_a.wall, sums_b.conflict, x, y);
      evidence.free_free = product(sums_a.free, sums_b.free, x, y) * kCell * kCell;
      scores[{x, y}] = evidence.agree < options.min_agree * evidence.known ? kImplausible
                                                                           : plausibility(evidence);
    }
  }
  return scores;
}

}  // namespace

TEST_CASE("the transform of Fourier finds what trying every shift finds", "[matching]") {
  CorrelationSearchOptions options;
  options.resolution = kCell;
  options.headings.min_share = 0;
  options.min_agree = 0.02;  // Walls anywhere agree on little.
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const EvidenceOptions evidence =
        seed % 2 == 0 ? EvidenceOptions{} : EvidenceOptions{0.5, 0.05, 0.2};
    const MapFeatures a = cellularMap(seed, 20, 14, 60), b = cellularMap(seed + 30, 12, 16, 40);
    const auto scores = scoresOfAllShifts(a, b, options, evidence);
    std::vector<std::pair<double, std::pair<int, int>>> found;
    for (const Hypothesis& hypothesis : searchByCorrelation(a, b, options, evidence)) {
      if (std::abs(hypothesis.b_in_a.heading) < 1e-9) {
        const Vector2d shift = hypothesis.b_in_a.translation / kCell;
        CHECK(shift.x() == Approx(std::round(shift.x())).margin(1e-6));
        found.push_back(
            {hypothesis.votes,
             {static_cast<int>(std::lround(shift.x())), static_cast<int>(std::lround(shift.y()))}});
      }
    }
    INFO("seed " << seed);
    REQUIRE(found.size() >= 3);
    // Each has the score that it should ...
    for (const auto& [score, shift] : found) {
      REQUIRE(scores.count(shift) == 1);
      CHECK(score == Approx(scores.at(shift)).margin(0.02));
    }
    // ... and none that is better than all about it was passed over.
    const double least = found.back().first;
    int peaks = 0;
    for (const auto& [shift, score] : scores) {
      double about = kImplausible;
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) {
          const auto beside = scores.find({shift.first + dx, shift.second + dy});
          if ((dx != 0 || dy != 0) && beside != scores.end()) {
            about = std::max(about, beside->second);
          }
        }
      }
      if (score > about + 0.05 && score > least + 0.05) {
        ++peaks;
        const auto same = [&wanted = shift](const auto& entry) { return entry.second == wanted; };
        INFO("shift " << shift.first << " " << shift.second << " score " << score);
        CHECK(std::any_of(found.begin(), found.end(), same));
      }
    }
    CHECK(peaks >= 3);
  }
}

TEST_CASE("a part of a floor is found wherever it lies", "[matching]") {
  const test::Floor floor = test::officeFloor();
  const MapFeatures whole = extractFeatures(test::exploreMap(floor, {}, 0.1));
  for (const test::Window& window : {test::Window{{-1, -1}, {13, 15}},
                                     {{11, -1}, {25, 15}},
                                     {{-1, 4}, {25, 15}},
                                     {{-1, -1}, {25, 9}}}) {
    for (const double heading : {0.0, 2.0}) {
      const Pose2D b_in_world(3, -2, heading);
      const MapFeatures part = extractFeatures(test::exploreMap(floor, b_in_world, 0.1, window));
      const Pose2D truth = inverse(whole.grid_in_map) + b_in_world + part.grid_in_map;
      const RigidTransform part_in_whole{truth.phi, {truth.x, truth.y}};
      const Vector2d middle(part.width / 2, part.height / 2);
      // Either way round, among the best.
      for (const bool swapped : {false, true}) {
        const auto found =
            swapped ? searchByCorrelation(part, whole) : searchByCorrelation(whole, part);
        const auto isRight = [&](const Hypothesis& hypothesis) {
          const RigidTransform answer = swapped ? hypothesis.b_in_a.inverse() : hypothesis.b_in_a;
          return (answer * middle - part_in_whole * middle).norm() < 0.8 &&
                 std::abs(std::remainder(answer.heading - truth.phi, 2 * M_PI)) < 0.06;
        };
        INFO("from " << window.low.x << " " << window.low.y << " turned " << heading << " swapped "
                     << swapped);
        CHECK(std::any_of(
            found.begin(),
            found.begin() + std::min<std::ptrdiff_t>(20, static_cast<std::ptrdiff_t>(found.size())),
            isRight));
      }
    }
  }
}

TEST_CASE("the best shifts of all headings come first, and no heading has more than its share",
          "[matching]") {
  const MapFeatures a = cellularMap(1, 20, 14, 60), b = cellularMap(2, 12, 16, 40);
  CorrelationSearchOptions options;
  options.per_heading = 3;
  options.min_agree = 0;
  const auto found = searchByCorrelation(a, b, options);
  REQUIRE(!found.empty());
  std::map<double, int> per_heading;
  for (size_t i = 0; i < found.size(); ++i) {
    CHECK((i == 0 || found[i].votes <= found[i - 1].votes));
    ++per_heading[found[i].b_in_a.heading];
  }
  for (const auto& [heading, count] : per_heading) {
    CHECK(count <= 3);
  }
}
