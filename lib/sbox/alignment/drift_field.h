// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How two maps of one place are bent against each other: a smooth field of small displacements on
// top of a rigid transform. Maps that belong together fit closely once it is taken out; maps that
// do not need a rougher field and still conflict.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sbox/core/rigid_transform.h"
#include "sbox/features/map_features.h"

namespace sbox {

/// How stiff the field is, and what it is fitted to.
struct DriftOptions {
  double node_spacing = 8.0;  ///< Of the lattice that carries the field, metres.
  int most_nodes = 12;        ///< Along each axis: large maps get a wider lattice.
  double bending = 0.3;       ///< Expected change between neighbouring nodes, metres.
  double wall_noise = 0.2;    ///< Expected offset of walls that agree, metres.
  double first_kernel = 1.0;  ///< Scale of the robust kernel in the first round, metres; ...
  double last_kernel = 0.25;  ///< ... it shrinks to this in the last.
  int rounds = 5;             ///< Of reweighted least squares.
  size_t most_points = 800;   ///< Wall points used of each map.
};

/// Displacements at the nodes of a lattice, bilinear in between, constant beyond.
struct DriftField {
  Eigen::Vector2d origin =
      Eigen::Vector2d::Zero();  ///< Of node (0, 0), in the grid frame of map a.
  double spacing = 1;           ///< Metres.
  int columns = 1;              ///< Nodes in a row.
  int rows = 1;                 ///< Rows of nodes.
  std::vector<Eigen::Vector2d> displacements = {Eigen::Vector2d::Zero()};  ///< Row by row, metres.

  /// Displacement at a point of the grid frame of map a, metres.
  [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& point) const;
  /// Root mean square change between neighbouring nodes, metres.
  [[nodiscard]] double roughness() const;
};

/// The field that lays the walls of map b, after the transform, on those of map a.
[[nodiscard]] DriftField estimateDrift(const MapFeatures& a, const MapFeatures& b,
                                       const RigidTransform& b_in_a,
                                       const DriftOptions& options = {});

}  // namespace sbox
