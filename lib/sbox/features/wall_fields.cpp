// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/features/wall_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sbox/core/round.h"

namespace sbox {
namespace {

/// Calls take(sector) for each that a normal belongs to: its own, and a neighbour if it is near to
/// that.
template <typename Take>
void forEachSector(const Eigen::Vector2d& normal, double overlap, const Take& take) {
  const double turns = std::atan2(normal.y(), normal.x()) / (M_PI / 4);
  const double nearest = std::round(turns), off = turns - nearest;
  const int own = (static_cast<int>(nearest) + kSectors) % kSectors;
  take(static_cast<size_t>(own));
  if (0.5 - std::abs(off) <= overlap / 45) {
    take(static_cast<size_t>((own + (off > 0 ? 1 : kSectors - 1)) % kSectors));
  }
}

/// Offers a wall point to the cells within `radius` cells along rows and columns;
/// `squared_distances` and `nearest` are of the points offered so far.
void offer(const WallFields& fields, const Eigen::Vector2d& position, std::uint16_t index,
           double radius, std::vector<float>& squared_distances,
           std::vector<std::uint16_t>& nearest) {
  const double column = (position.x() - fields.origin.x()) / fields.resolution - 0.5;
  const double row = (position.y() - fields.origin.y()) / fields.resolution - 0.5;
  const int x_first = std::max(0, ceilToInt(column - radius));
  const int x_last = std::min(fields.width - 1, floorToInt(column + radius));
  const int y_first = std::max(0, ceilToInt(row - radius));
  const int y_last = std::min(fields.height - 1, floorToInt(row + radius));
  for (int y = y_first; y <= y_last; ++y) {
    const auto dy = static_cast<float>(y - row);
    const size_t row_start = static_cast<size_t>(y) * static_cast<size_t>(fields.width);
    float* squared = squared_distances.data() + row_start;
    std::uint16_t* indices = nearest.data() + row_start;
    for (int x = x_first; x <= x_last; ++x) {
      const float dx = static_cast<float>(x) - static_cast<float>(column);
      const float d = dx * dx + dy * dy;
      indices[x] = d < squared[x] ? index : indices[x];
      squared[x] = std::min(d, squared[x]);
    }
  }
}

/// The indices of the points that face each sector, row by row of the field's cells: they come
/// scattered, but neighbours one after the other find their cells in the cache.
std::array<std::vector<std::uint16_t>, kSectors> bySector(const std::vector<WallPoint>& points,
                                                          double resolution, double overlap) {
  // Row, column and index in one number, which sorts fastest.
  std::array<std::vector<std::uint64_t>, kSectors> keys;
  constexpr int bits = 24, index_bits = 16;
  const auto cell = [&](double place) {
    return static_cast<std::uint64_t>(floorToInt(place / resolution)) & ((1U << bits) - 1);
  };
  for (size_t i = 0; i < std::min(points.size(), size_t{WallFields::most_points}); ++i) {
    const Eigen::Vector2d& position = points[i].position;
    const std::uint64_t key = (cell(position.y()) << bits | cell(position.x())) << index_bits | i;
    forEachSector(points[i].normal, overlap, [&](size_t sector) { keys[sector].push_back(key); });
  }
  std::array<std::vector<std::uint16_t>, kSectors> facing;
  for (size_t sector = 0; sector < kSectors; ++sector) {
    std::sort(keys[sector].begin(), keys[sector].end());
    for (const std::uint64_t key : keys[sector]) {
      facing[sector].push_back(static_cast<std::uint16_t>(key));
    }
  }
  return facing;
}

/// How far the cells in a band of rows are from the nearest that is not free, as the shortest way
/// within the band by steps along rows, columns and diagonals (a chamfer distance). What lies
/// beyond the grid is not free. Only free cells take time.
class ChamferBand {
 public:
  /// Depths up to `deepest` metres are told apart.
  ChamferBand(const StateGrid& grid, double deepest)
      : grid_(grid),
        stride_(static_cast<size_t>(grid.width) + 2),
        scale_(std::min(kMostScale, std::floor(kFarthest / (deepest / grid.resolution + 1)))),
        side_(static_cast<int>(std::lround(kSide * scale_))),
        diagonal_(static_cast<int>(std::lround(kDiagonal * scale_))) {}

  /// Works out the rows from `first` to before `last`.
  void measure(int first, int last) {
    first_ = first;
    distances_.assign(stride_ * static_cast<size_t>(last - first + 2), 0);
    const auto rim = static_cast<std::ptrdiff_t>(stride_);
    if (first > 0) {
      std::fill(distances_.begin(), distances_.begin() + rim, kFarthest);
    }
    if (last < grid_.height) {
      std::fill(distances_.end() - rim, distances_.end(), kFarthest);
    }
    findRuns(first, last);
    for (const Run& run : runs_) {
      std::uint16_t* cells = distances_.data() + run.first;
      const size_t count = run.count;
      std::fill_n(cells, count, kFarthest);
      stepFromRow(cells - stride_, count, cells);
      stepAlong(cells, cells + count);
    }
    for (auto run = runs_.rbegin(); run != runs_.rend(); ++run) {
      std::uint16_t* cells = distances_.data() + run->first;
      stepFromRow(cells + stride_, run->count, cells);
      stepAlong(std::make_reverse_iterator(cells + run->count), std::make_reverse_iterator(cells));
    }
  }

  /// Of the cells of a row, in fractions of a cell's edge; 0 where the cell itself is not free.
  [[nodiscard]] const std::uint16_t* row(int row) const {
    return distances_.data() + indexOf(0, row);
  }

  /// How many fractions make an edge.
  [[nodiscard]] double scale() const { return scale_; }

 private:
  static constexpr double kMostScale = 1000;
  /// Steps to a side and across a corner, in cells: those by which ways come nearest to straight
  /// ones (Borgefors 1986).
  static constexpr double kSide = 0.955, kDiagonal = 1.369;
  /// No distance is greater; a step more fits in 16 bits.
  static constexpr std::uint16_t kFarthest = 64'000;

  /// Free cells side by side in a row, from this index on.
  struct Run {
    size_t first, count;
  };

  /// There is a rim of one cell about the band.
  [[nodiscard]] size_t indexOf(int column, int row) const {
    return static_cast<size_t>(row - first_ + 1) * stride_ + static_cast<size_t>(column + 1);
  }

  void findRuns(int first_row, int last_row) {
    runs_.clear();
    for (int row = first_row; row < last_row; ++row) {
      const auto begin = grid_.cells.begin() + static_cast<std::ptrdiff_t>(row) * grid_.width;
      const auto end = begin + grid_.width;
      const size_t start = indexOf(0, row);
      const auto is_other = [](CellState state) { return state != CellState::Free; };
      for (auto first = std::find(begin, end, CellState::Free); first != end;) {
        const auto last = std::find_if(first, end, is_other);
        runs_.push_back(
            {start + static_cast<size_t>(first - begin), static_cast<size_t>(last - first)});
        first = std::find(last, end, CellState::Free);
      }
    }
  }

  /// Steps to `count` cells from those of the row that a sweep has passed before. Apart from
  /// stepAlong(), so that compilers work on many cells at once.
  void stepFromRow(const std::uint16_t* passed, size_t count, std::uint16_t* cells) const {
    const auto step = [](std::uint16_t from, int length) {
      return static_cast<std::uint16_t>(from + length);
    };
    const std::uint16_t *left = passed - 1, *right = passed + 1;
    const int side = side_, diagonal = diagonal_;
    for (size_t i = 0; i < count; ++i) {
      const std::uint16_t across = step(std::min(left[i], right[i]), diagonal);
      cells[i] = std::min(cells[i], std::min(across, step(passed[i], side)));
    }
  }

  /// Steps along a run of free cells; at its ends there is what is not free. Each cell waits for
  /// the one before it, so what it waits for is but one minimum: less the way along the run.
  template <typename Iterator>
  void stepAlong(Iterator cell, Iterator end) const {
    const int side = side_;
    int way = 0, least = 0;
    for (; cell != end; ++cell) {
      way += side;
      least = std::min(least, *cell - way);
      *cell = static_cast<std::uint16_t>(least + way);
    }
  }

  const StateGrid& grid_;
  size_t stride_;
  double scale_;
  int side_, diagonal_;
  int first_ = 0;
  std::vector<Run> runs_;
  std::vector<std::uint16_t> distances_;  ///< Row by row, with the rim.
};

/// Index of the grid's row or column that holds the centre of the i-th of the fields.
int gridIndex(double origin, int i, const WallFields& fields, const StateGrid& grid) {
  return floorToInt((origin + (i + 0.5) * fields.resolution) / grid.resolution);
}

void fillDepth(const StateGrid& grid, WallFields& fields) {
  // Band by band, which stays in the cache: nothing further off than a margin matters.
  constexpr int band = 128;
  constexpr double deepest = 255 * WallFields::depth_unit;
  const int margin = ceilToInt(deepest / (0.95 * grid.resolution)) + 1;
  std::vector<int> columns;
  for (int x = 0; x < fields.width; ++x) {
    columns.push_back(gridIndex(fields.origin.x(), x, fields, grid));
  }
  ChamferBand distances(grid, deepest);
  const double to_units = grid.resolution / (distances.scale() * WallFields::depth_unit);
  int measured = 0;  // The first row of the grid that is not.
  for (int y = 0; y < fields.height; ++y) {
    const int row = gridIndex(fields.origin.y(), y, fields, grid);
    if (row < 0 || row >= grid.height) {
      continue;
    }
    if (row >= measured) {
      measured = row + band;
      distances.measure(std::max(row - margin, 0), std::min(measured + margin, grid.height));
    }
    const std::uint16_t* grid_row = distances.row(row);
    std::uint8_t* field_row =
        fields.free_depth.data() + static_cast<size_t>(y) * static_cast<size_t>(fields.width);
    for (int x = 0; x < fields.width; ++x) {
      const int column = columns[static_cast<size_t>(x)];
      if (column >= 0 && column < grid.width) {
        field_row[x] =
            static_cast<std::uint8_t>(std::min(255.0, grid_row[column] * to_units + 0.5));
      }
    }
  }
}

}  // namespace

ByteAngle toByteAngle(double radians) {
  return static_cast<ByteAngle>(static_cast<int>(std::lround(radians / (2 * M_PI) * 256)) & 0xFF);
}

WallFields makeFields(const StateGrid& grid, const std::vector<WallPoint>& points,
                      const FieldOptions& options) {
  WallFields fields;
  fields.resolution = options.resolution;
  if (grid.empty()) {
    return fields;
  }
  const double area = grid.resolution * grid.resolution * grid.width * grid.height;
  fields.resolution = std::max(options.resolution, std::sqrt(area / options.most_cells));
  fields.origin = Eigen::Vector2d::Constant(-options.reach);
  const auto cells = [&](int size) {
    return static_cast<int>(
        std::ceil((size * grid.resolution + 2 * options.reach) / fields.resolution));
  };
  fields.width = cells(grid.width);
  fields.height = cells(grid.height);
  const size_t count = static_cast<size_t>(fields.width) * static_cast<size_t>(fields.height);
  fields.free_depth.assign(count, 0);
  fillDepth(grid, fields);

  const auto facing = bySector(points, fields.resolution, options.sector_overlap);
  const double radius = options.reach / fields.resolution;
  // What lies further off is no nearer than nothing.
  const auto nothing = static_cast<float>(radius * radius);
  const auto to_units = static_cast<float>(fields.resolution / WallFields::unit);
  std::vector<float> squared;
  for (size_t sector = 0; sector < kSectors; ++sector) {
    std::vector<std::uint16_t>& nearest = fields.nearest[sector];
    squared.assign(count, nothing);
    nearest.assign(count, WallFields::none);
    for (const std::uint16_t index : facing[sector]) {
      offer(fields, points[index].position, index, radius, squared, nearest);
    }
    std::vector<std::uint8_t>& distances = fields.distances[sector];
    distances.resize(count);
    std::transform(squared.begin(), squared.end(), distances.begin(), [=](float square) {
      const float rounded = std::sqrt(square) * to_units + 0.5F;
      const int units = std::min(255, static_cast<int>(rounded));
      return static_cast<std::uint8_t>(units | 255 * static_cast<int>(square >= nothing));
    });
  }
  return fields;
}

}  // namespace sbox
