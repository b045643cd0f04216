// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/methods/hough_matching.h"

#include <algorithm>
#include <cmath>

#include "sbox-bench/methods/hough_spectrum.h"
#include "sbox/core/state_grid.h"
#include "sbox/core/stopwatch.h"

namespace sbox::bench {
namespace {

struct HoughFeatures {
  StateGrid grid;
  std::vector<Point2D> walls;  ///< In the grid's frame, metres.
  std::vector<double> spectrum;
  int known_cells = 0;
};

/// How two grids agree where both are known.
struct Agreement {
  int agree = 0;
  int disagree = 0;
  /// The paper's acceptance index omega.
  [[nodiscard]] double index() const {
    return agree == 0 ? 0.0 : static_cast<double>(agree) / (agree + disagree);
  }
};

HoughFeatures extract(const Map& map, const HoughOptions& options) {
  HoughFeatures features;
  features.grid = resample(classifyCells(map), options.resolution);
  features.walls = wallPoints(features.grid);
  features.spectrum = houghSpectrum(features.walls, options.direction_bins, options.resolution);
  features.known_cells =
      static_cast<int>(std::count_if(features.grid.cells.begin(), features.grid.cells.end(),
                                     [](CellState state) { return state != CellState::Unknown; }));
  return features;
}

/// Sum over i of a[i + shift] b[i] for each shift; indices wrap round.
std::vector<double> circularCorrelation(const std::vector<double>& a,
                                        const std::vector<double>& b) {
  const size_t n = a.size();
  std::vector<double> result(n, 0.0);
  for (size_t shift = 0; shift < n; ++shift) {
    for (size_t i = 0; i < n; ++i) {
      result[shift] += a[(i + shift) % n] * b[i];
    }
  }
  return result;
}

/// Indices of the highest local maxima, highest first; the neighbours of the ends wrap round.
std::vector<int> highestPeaks(const std::vector<double>& values, int count) {
  const size_t n = values.size();
  std::vector<int> peaks;
  for (size_t i = 0; i < n; ++i) {
    if (values[i] > values[(i + n - 1) % n] && values[i] >= values[(i + 1) % n]) {
      peaks.push_back(static_cast<int>(i));
    }
  }
  std::stable_sort(peaks.begin(), peaks.end(), [&](int left, int right) {
    return values[static_cast<size_t>(left)] > values[static_cast<size_t>(right)];
  });
  peaks.resize(std::min(peaks.size(), static_cast<size_t>(count)));
  return peaks;
}

/// The best shifts along one axis, in metres: a[x + shift] over b[x], for the points' projections
/// on direction (c, s).
std::vector<double> bestShifts(const std::vector<Point2D>& a, double angle_a,
                               const std::vector<Point2D>& b, double angle_b, bool along_y,
                               const HoughOptions& options) {
  const auto project = [&](const std::vector<Point2D>& points, double angle) {
    std::vector<double> places;
    places.reserve(points.size());
    for (const Point2D& point : points) {
      places.push_back(along_y ? point.x * std::sin(angle) + point.y * std::cos(angle)
                               : point.x * std::cos(angle) - point.y * std::sin(angle));
    }
    return places;
  };
  const std::vector<double> places_a = project(a, angle_a), places_b = project(b, angle_b);
  const double low_a = *std::min_element(places_a.begin(), places_a.end());
  const double low_b = *std::min_element(places_b.begin(), places_b.end());
  const double high_a = *std::max_element(places_a.begin(), places_a.end());
  const double high_b = *std::max_element(places_b.begin(), places_b.end());
  const auto bins = [&](double length) {
    return static_cast<size_t>(length / options.resolution) + 1;
  };
  // Room for every shift without overlap of the two ends.
  const size_t n = bins(high_a - low_a) + bins(high_b - low_b);
  std::vector<double> spectrum_a(n, 0.0), spectrum_b(n, 0.0);
  for (const double place : places_a) {
    ++spectrum_a[bins(place - low_a) - 1];
  }
  for (const double place : places_b) {
    ++spectrum_b[bins(place - low_b) - 1];
  }
  std::vector<double> shifts;
  for (const int peak : highestPeaks(circularCorrelation(spectrum_a, spectrum_b), options.shifts)) {
    const auto size_a = static_cast<int>(bins(high_a - low_a));
    const int bin = peak >= size_a ? peak - static_cast<int>(n) : peak;
    shifts.push_back(bin * options.resolution + low_a - low_b);
  }
  return shifts;
}

Agreement agreement(const StateGrid& a, const StateGrid& b, const Pose2D& grid_b_in_grid_a) {
  Agreement result;
  const double c = std::cos(grid_b_in_grid_a.phi), s = std::sin(grid_b_in_grid_a.phi);
  const double x0 = grid_b_in_grid_a.x / a.resolution, y0 = grid_b_in_grid_a.y / a.resolution;
  for (int y = 0; y < b.height; ++y) {
    for (int x = 0; x < b.width; ++x) {
      const CellState of_b = b.at(x, y);
      if (of_b == CellState::Unknown) {
        continue;
      }
      const double ax = c * (x + 0.5) - s * (y + 0.5) + x0;
      const double ay = s * (x + 0.5) + c * (y + 0.5) + y0;
      const CellState of_a =
          a.at(static_cast<int>(std::floor(ax)), static_cast<int>(std::floor(ay)));
      if (of_a != CellState::Unknown) {
        ++(of_a == of_b ? result.agree : result.disagree);
      }
    }
  }
  return result;
}

/// Every transform that the spectra propose.
std::vector<Pose2D> hypotheses(const HoughFeatures& a, const HoughFeatures& b,
                               const HoughOptions& options) {
  std::vector<Pose2D> poses;
  // Walls along the axes make the sharpest projections.
  const double align = -dominantDirection(a.spectrum);
  for (const int peak :
       highestPeaks(circularCorrelation(a.spectrum, b.spectrum), options.rotations)) {
    for (const double half_turn : {0.0, M_PI}) {
      const double turn = M_PI * peak / options.direction_bins + half_turn;
      for (const double x : bestShifts(a.walls, align, b.walls, turn + align, false, options)) {
        for (const double y : bestShifts(a.walls, align, b.walls, turn + align, true, options)) {
          // Back from the aligned frame to a's.
          poses.emplace_back(x * std::cos(align) + y * std::sin(align),
                             -x * std::sin(align) + y * std::cos(align), wrapAngle(turn));
        }
      }
    }
  }
  return poses;
}

PairResult match(const HoughFeatures& a, const HoughFeatures& b, const HoughOptions& options) {
  PairResult result;
  if (a.walls.empty() || b.walls.empty()) {
    result.reason = "a map has no wall";
    return result;
  }
  Stopwatch stopwatch;
  const std::vector<Pose2D> poses = hypotheses(a, b, options);
  result.seconds.matching = stopwatch.seconds();
  stopwatch = Stopwatch();
  const double least = options.least_share * std::min(a.known_cells, b.known_cells);
  for (const Pose2D& pose : poses) {
    const Agreement cells = agreement(a.grid, b.grid, pose);
    if (cells.agree + cells.disagree >= least && cells.index() > result.confidence) {
      result.has_pose = true;
      result.confidence = cells.index();
      result.pose_b_in_a = a.grid.corner_in_map + (pose + inverse(b.grid.corner_in_map));
      result.overlap_m2 = (cells.agree + cells.disagree) * options.resolution * options.resolution;
    }
  }
  result.seconds.verification = stopwatch.seconds();
  const bool accepted = result.has_pose && result.confidence >= options.accept_index;
  result.verdict = accepted ? Verdict::Accepted : Verdict::Rejected;
  result.reason = accepted          ? "the acceptance index is high"
                  : result.has_pose ? "the acceptance index is low"
                                    : "no transform makes the maps overlap enough";
  return result;
}

}  // namespace

Method houghMethod(const HoughOptions& options) {
  return makeMethod(
      "hough", [options](const Map& map) { return extract(map, options); },
      [options](const HoughFeatures& a, const HoughFeatures& b) { return match(a, b, options); });
}

}  // namespace sbox::bench
