// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/alignment/drift_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sbox/alignment/robust_kernel.h"
#include "sbox/core/cholesky.h"
#include "sbox/features/field_lookup.h"

namespace sbox {
namespace {

/// The four nodes round a point and their bilinear weights.
struct Stencil {
  std::array<int, 4> nodes;
  std::array<double, 4> weights;
};

Stencil stencilAt(const DriftField& field, const Eigen::Vector2d& point) {
  const auto split = [](double place, int count, int& index, double& share) {
    place = std::clamp(place, 0.0, static_cast<double>(count - 1));
    index = std::min(static_cast<int>(place), std::max(0, count - 2));
    share = place - index;
  };
  int column = 0, row = 0;
  double x = 0, y = 0;
  split((point.x() - field.origin.x()) / field.spacing, field.columns, column, x);
  split((point.y() - field.origin.y()) / field.spacing, field.rows, row, y);
  const int right = field.columns > 1 ? 1 : 0, up = field.rows > 1 ? field.columns : 0;
  const int node = row * field.columns + column;
  return {{node, node + right, node + up, node + up + right},
          {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y}};
}

Eigen::Vector2d displacementAt(const DriftField& field, const Stencil& stencil) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (size_t i = 0; i < 4; ++i) {
    sum += stencil.weights[i] * field.displacements[static_cast<size_t>(stencil.nodes[i])];
  }
  return sum;
}

DriftField latticeOver(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
                       const DriftOptions& options) {
  // Where the maps lie over each other; nothing is known of the drift elsewhere.
  Eigen::Vector2d low(1e18, 1e18), high(-1e18, -1e18);
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(b.width, 0), Eigen::Vector2d(0, b.height),
        Eigen::Vector2d(b.width, b.height)}) {
    const Eigen::Vector2d p = b_in_a * corner;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  low = low.cwiseMax(Eigen::Vector2d::Zero());
  high = high.cwiseMin(Eigen::Vector2d(a.width, a.height));
  const Eigen::Vector2d size = (high - low).cwiseMax(Eigen::Vector2d::Zero());
  DriftField field;
  field.origin = low;
  field.spacing = std::max(options.node_spacing, size.maxCoeff() / (options.most_nodes - 1));
  field.columns = static_cast<int>(std::ceil(size.x() / field.spacing)) + 1;
  field.rows = static_cast<int>(std::ceil(size.y() / field.spacing)) + 1;
  field.displacements.assign(static_cast<size_t>(field.columns * field.rows),
                             Eigen::Vector2d::Zero());
  return field;
}

/// Normal equations over the displacements of all nodes.
class DriftEquations {
 public:
  DriftEquations(const DriftField& field, const DriftOptions& options)
      : field_(field),
        matrix_(Eigen::MatrixXd::Zero(2 * nodes(), 2 * nodes())),
        vector_(Eigen::VectorXd::Zero(2 * nodes())) {
    const double stiffness = std::pow(options.wall_noise / options.bending, 2);
    for (int row = 0; row < field.rows; ++row) {
      for (int column = 0; column < field.columns; ++column) {
        const int node = row * field.columns + column;
        if (column + 1 < field.columns) {
          tie(node, node + 1, stiffness);
        }
        if (row + 1 < field.rows) {
          tie(node, node + field.columns, stiffness);
        }
        constexpr double anchor = 0.02;  // Without walls a node stays where it is.
        matrix_(2 * node, 2 * node) += anchor;
        matrix_(2 * node + 1, 2 * node + 1) += anchor;
      }
    }
  }

  /// A wall at the stencil's place should move by `offset` as far as the normal tells.
  void add(const Stencil& stencil, const Eigen::Vector2d& offset, const Eigen::Vector2d& normal,
           double weight) {
    const double residual = normal.dot(offset);
    for (size_t i = 0; i < 4; ++i) {
      const double wi = weight * stencil.weights[i];
      const int row = 2 * stencil.nodes[i];
      vector_.segment<2>(row) += wi * residual * normal;
      // Only the lower triangle is read; nodes ascend.
      for (size_t j = 0; j <= i; ++j) {
        matrix_.block<2, 2>(row, 2 * stencil.nodes[j]) +=
            (wi * stencil.weights[j]) * normal * normal.transpose();
      }
    }
  }

  [[nodiscard]] std::vector<Eigen::Vector2d> solve() const {
    const Eigen::VectorXd solution = solvePositiveDefinite(matrix_, vector_);
    std::vector<Eigen::Vector2d> displacements(static_cast<size_t>(nodes()));
    for (int node = 0; node < nodes(); ++node) {
      displacements[static_cast<size_t>(node)] = solution.segment<2>(2 * node);
    }
    return displacements;
  }

 private:
  [[nodiscard]] int nodes() const { return field_.columns * field_.rows; }

  void tie(int i, int j, double stiffness) {
    for (int axis = 0; axis < 2; ++axis) {
      const int p = 2 * i + axis, q = 2 * j + axis;
      matrix_(p, p) += stiffness;
      matrix_(q, q) += stiffness;
      matrix_(p, q) -= stiffness;
      matrix_(q, p) -= stiffness;
    }
  }

  const DriftField& field_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd vector_;
};

double robustWeight(double squared_distance, double kernel) {
  const double share = gemanMcClureShare(squared_distance, kernel);
  return share * share;
}

}  // namespace

Eigen::Vector2d DriftField::at(const Eigen::Vector2d& point) const {
  return displacementAt(*this, stencilAt(*this, point));
}

double DriftField::roughness() const {
  double sum = 0;
  int edges = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto node = static_cast<size_t>(row * columns + column);
      if (column + 1 < columns) {
        sum += (displacements[node + 1] - displacements[node]).squaredNorm();
        ++edges;
      }
      if (row + 1 < rows) {
        sum += (displacements[node + static_cast<size_t>(columns)] - displacements[node])
                   .squaredNorm();
        ++edges;
      }
    }
  }
  return edges > 0 ? std::sqrt(sum / edges) : 0;
}

DriftField estimateDrift(const MapFeatures& a, const MapFeatures& b, const RigidTransform& b_in_a,
                         const DriftOptions& options) {
  DriftField field = latticeOver(a, b, b_in_a, options);
  const PointMover to_a(b_in_a), to_b(b_in_a.inverse());
  const ByteAngle byte_turn = toByteAngle(b_in_a.heading);
  const size_t count_a = std::min(options.most_points, a.wall_points.size());
  const size_t count_b = std::min(options.most_points, b.wall_points.size());
  const double length_a = a.wallLengthPerPoint(count_a);
  const double length_b = b.wallLengthPerPoint(count_b);
  std::vector<Eigen::Vector2d> rigid_b(count_b);
  std::vector<Stencil> stencils_b(count_b), stencils_a(count_a);
  for (size_t i = 0; i < count_b; ++i) {
    rigid_b[i] = to_a(b.wall_points[i].position);
    stencils_b[i] = stencilAt(field, rigid_b[i]);
  }
  for (size_t i = 0; i < count_a; ++i) {
    stencils_a[i] = stencilAt(field, a.wall_points[i].position);
  }
  for (int round = 0; round < options.rounds; ++round) {
    const double kernel =
        scaleOfRound(round, options.rounds, options.first_kernel, options.last_kernel);
    DriftEquations equations(field, options);
    forEachNearest(
        a.fields, a.wall_points, count_b,
        [&](size_t i) {
          return Eigen::Vector2d(rigid_b[i] + displacementAt(field, stencils_b[i]));
        },
        [&](size_t i) { return static_cast<ByteAngle>(b.wall_directions[i] + byte_turn); },
        [&](size_t i, const Eigen::Vector2d& p, const WallPoint& target) {
          equations.add(stencils_b[i], target.position - rigid_b[i], target.normal,
                        length_b * robustWeight((target.position - p).squaredNorm(), kernel));
        });
    forEachNearest(
        b.fields, b.wall_points, count_a,
        [&](size_t i) {
          return to_b(a.wall_points[i].position - displacementAt(field, stencils_a[i]));
        },
        [&](size_t i) { return static_cast<ByteAngle>(a.wall_directions[i] - byte_turn); },
        [&](size_t i, const Eigen::Vector2d&, const WallPoint& source) {
          const Eigen::Vector2d& p = a.wall_points[i].position;
          const Eigen::Vector2d rigid = to_a(source.position);
          const Stencil stencil = stencilAt(field, rigid);
          const Eigen::Vector2d left = p - rigid - displacementAt(field, stencil);
          equations.add(stencil, p - rigid, to_a.turn(source.normal),
                        length_a * robustWeight(left.squaredNorm(), kernel));
        });
    field.displacements = equations.solve();
  }
  return field;
}

}  // namespace sbox
