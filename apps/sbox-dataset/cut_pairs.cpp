// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/cut_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sbox-bench/judge.h"
#include "sbox-bench/load_folder.h"
#include "sbox-dataset/output_folder.h"
#include "sbox/core/principal_axes.h"
#include "sbox/core/rigid_fit.h"
#include "sbox/core/state_grid.h"
#include "sbox/io/save_map.h"

namespace sbox::dataset {
namespace {

using Points = std::vector<Eigen::Vector2d>;

Eigen::Vector2d toVector(const Point2D& point) { return {point.x, point.y}; }

/// Adds the centres of a map's free cells, seen from the frame that `map_in_frame` is a pose in.
void addFreeCells(const Map& map, const Pose2D& map_in_frame, Points& points) {
  const StateGrid grid = classifyCells(map);
  const Pose2D corner_in_frame = map_in_frame + grid.corner_in_map;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (grid.at(x, y) == CellState::Free) {
        points.push_back(toVector(corner_in_frame.composePoint(
            {(x + 0.5) * grid.resolution, (y + 0.5) * grid.resolution})));
      }
    }
  }
}

/// The direction in which points are spread most, towards positive x.
Eigen::Vector2d mainAxis(const Points& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) {
    mean += point / static_cast<double>(points.size());
  }
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& point : points) {
    scatter += (point - mean) * (point - mean).transpose();
  }
  const Eigen::Vector2d across = principalAxes(scatter).smallest_axis;
  const Eigen::Vector2d along(across.y(), -across.x());
  return along.x() < 0 ? Eigen::Vector2d(-along) : along;
}

double quantile(std::vector<double>& values, double share) {
  const auto last = static_cast<double>(values.size() - 1);
  const auto nth = values.begin() + std::lround(std::clamp(share, 0.0, 1.0) * last);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// Makes the cells unknown whose centres, seen from the map's frame, are not kept.
template <typename Keep>
void blank(Map& map, const Keep& keeps) {
  constexpr float unknown = 0.5F;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (!keeps(map.cellCentre(x, y))) {
        map.grid.setCell(x, y, unknown);
      }
    }
  }
}

/// Makes the best rigid fit of the pair's points its truth.
void fitTruth(bench::AnnotatedPair& pair) {
  const Pose2D a_in_b = fitRigid(pair.points_a, pair.points_b);
  pair.theta_deg = a_in_b.phi * 180 / M_PI;
  pair.offset = {a_in_b.x, a_in_b.y};
  double sum = 0;
  for (size_t i = 0; i < pair.points_a.size(); ++i) {
    sum += (a_in_b.composePoint(pair.points_a[i]) - pair.points_b[i]).sqrNorm();
  }
  pair.floor_cells = std::sqrt(sum / static_cast<double>(pair.points_a.size()));
}

}  // namespace

CutPair cutPair(const Map& a, const Map& b, const bench::AnnotatedPair& pair, double resolution,
                const CutOptions& options) {
  if (pair.negative) {
    throw std::invalid_argument("maps with nothing in common cannot be cut along one line");
  }
  const Pose2D pose_b_in_a = bench::poseFromCorners(bench::trueCornerAInCornerB(pair, resolution),
                                                    a.corner_in_map, b.corner_in_map);
  Points free;
  addFreeCells(a, {}, free);
  addFreeCells(b, pose_b_in_a, free);
  if (free.empty()) {
    throw std::runtime_error(a.name + " and " + b.name + ": no cell is free");
  }
  const Eigen::Vector2d axis = Eigen::Rotation2Dd(options.tilt_deg * M_PI / 180) * mainAxis(free);
  std::vector<double> along;
  along.reserve(free.size());
  for (const Eigen::Vector2d& point : free) {
    along.push_back(axis.dot(point));
  }
  const double a_end = quantile(along, options.a_until), b_begin = quantile(along, options.b_from);
  const auto a_keeps = [&](const Point2D& in_a) { return axis.dot(toVector(in_a)) <= a_end; };
  const auto b_keeps = [&](const Point2D& in_b) {
    return axis.dot(toVector(pose_b_in_a.composePoint(in_b))) >= b_begin;
  };
  CutPair cut{a, b, pair};
  blank(cut.a, a_keeps);
  blank(cut.b, b_keeps);
  if (options.a_until <= options.b_from) {
    cut.pair.negative = true;
    return cut;
  }
  std::vector<Point2D> kept_a, kept_b;
  for (size_t i = 0; i < pair.points_a.size(); ++i) {
    if (a_keeps(a.corner_in_map.composePoint(pair.points_a[i] * resolution)) &&
        b_keeps(b.corner_in_map.composePoint(pair.points_b[i] * resolution))) {
      kept_a.push_back(pair.points_a[i]);
      kept_b.push_back(pair.points_b[i]);
    }
  }
  constexpr size_t enough = 4;
  if (kept_a.size() >= enough) {
    cut.pair.points_a = kept_a;
    cut.pair.points_b = kept_b;
    cut.pair.theta_local = pair.theta_deg;
    fitTruth(cut.pair);
  }
  return cut;
}

void cutPairs(const std::string& from, const std::string& to, const CutOptions& options) {
  bench::LoadedFolder loaded = bench::loadFolder(bench::readPairFolder(from));
  makeFolder(to);
  std::vector<bench::AnnotatedPair> all;
  for (size_t i = 0; i < loaded.map_of_pair.size(); ++i) {
    const bench::AnnotatedPair& pair = loaded.folder.pairs[i];
    if (pair.negative) {
      continue;
    }
    const auto [a, b] = loaded.map_of_pair[i];
    CutPair cut = cutPair(loaded.maps[static_cast<size_t>(a)], loaded.maps[static_cast<size_t>(b)],
                          pair, loaded.folder.resolution, options);
    std::string number = std::to_string(all.size());
    number.insert(0, 3 - std::min<size_t>(3, number.size()), '0');
    cut.pair.a = number + "a";
    cut.pair.b = number + "b";
    // The truth is between the corners of the grids, and a .gridmap knows no yaw.
    cut.a.corner_in_map = cut.b.corner_in_map = {};
    const std::filesystem::path base(to);
    saveMap(cut.a, (base / (cut.pair.a + ".gridmap.gz")).string());
    saveMap(cut.b, (base / (cut.pair.b + ".gridmap.gz")).string());
    all.push_back(std::move(cut.pair));
  }
  loaded.folder.path = to;
  loaded.folder.pairs = std::move(all);
  bench::writePairFolder(loaded.folder);
}

}  // namespace sbox::dataset
