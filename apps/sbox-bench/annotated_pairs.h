// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Folders of map pairs with known truth: the `pairs.json` format.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sbox/core/pose.h"

namespace sbox::bench {

/// Two maps and what is known about them. Lengths are in cells of the folder's `resolution`,
/// whatever the maps' own cells; points are seen from the lower-left corner of their map's grid,
/// y up.
struct AnnotatedPair {
  std::string group;                  ///< The building or data set ("env").
  std::string a;                      ///< Name of map a, as written in the file.
  std::string b;                      ///< Name of map b.
  bool negative = false;              ///< Nothing in common: refusing is right.
  double theta_deg = 0;               ///< Rotation of the best rigid fit, p_b = R p_a + t.
  std::optional<double> theta_local;  ///< A second rotation that counts as right, degrees.
  Point2D offset;                     ///< t of the best rigid fit, cells.
  std::vector<Point2D> points_a;      ///< Annotated points in map a, cells.
  std::vector<Point2D> points_b;      ///< The same points in map b, cells.
  double floor_cells = 0;             ///< RMS residual of the best rigid fit.
  double tolerance_cells = 15;        ///< How far above the floor is still right.
};

/// A `pairs.json` and where it lies.
struct PairFolder {
  std::string path;          ///< The folder.
  std::string name;          ///< The path's last part, what tables call it.
  double resolution = 0.05;  ///< Metres a cell of the lengths above.
  std::vector<AnnotatedPair> pairs;
};

/// Reads FOLDER/pairs.json. Throws std::runtime_error with "PATH: reason" if it is missing or not
/// in the format.
[[nodiscard]] PairFolder readPairFolder(const std::string& folder);

/// Writes FOLDER/pairs.json, which readPairFolder reads. Throws std::runtime_error with "PATH:
/// reason".
void writePairFolder(const PairFolder& folder);

/// The file of the map that pairs.json calls `name`: .gridmap, .gridmap.gz, .yaml or .png, first
/// in the folder, then in its parent. Throws std::runtime_error naming both if there is none.
[[nodiscard]] std::string findMapFile(const std::string& folder, const std::string& name);

/// The annotated pose of the corner of a's grid seen from the corner of b's, in metres.
[[nodiscard]] Pose2D trueCornerAInCornerB(const AnnotatedPair& pair, double resolution);

}  // namespace sbox::bench
