// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/office.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace sbox::dataset {
namespace {

struct Interval {
  double from = 0;
  double to = 0;

  [[nodiscard]] double length() const { return to - from; }
  [[nodiscard]] double middle() const { return (from + to) / 2; }
};

/// A rectangle that furniture can stand in.
struct Room {
  Interval x;
  Interval y;
};

constexpr double kDoorFree = 0.9;  // Metres round a door's middle that furniture keeps away from.

class OfficeBuilder {
 public:
  OfficeBuilder(std::uint32_t seed, const OfficeOptions& options)
      : options_(options), random_(seed) {}

  World build();

 private:
  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }

  std::vector<Interval> splitRow(const Interval& row);
  Interval doorIn(const Interval& wall);
  void addWallAlongX(double y, const Interval& x, std::vector<Interval> openings);
  void addWallAlongY(double x, const Interval& y, const std::vector<Interval>& openings);
  void addRow(const Interval& corridor_x, double corridor_y, double outer_y);
  void addRoom(const Interval& x, double corridor_y, double outer_y);
  void furnish(const Room& room);
  bool placeBox(const Pose2D& centre, double length, double width);
  void furnishCorridor(const Interval& x, const Interval& y);

  const OfficeOptions& options_;
  std::mt19937 random_;
  World world_;
  double thickness_ = 0.15;
  std::vector<Point2D> doors_;     ///< Middles.
  std::vector<Pose2D> furniture_;  ///< Middles, with the half diagonal in phi.
};

std::vector<Interval> OfficeBuilder::splitRow(const Interval& row) {
  std::vector<Interval> rooms;
  double at = row.from;
  while (row.to - at > options_.least_room) {
    double width = uniform(options_.least_room, options_.most_room);
    if (row.to - at - width < options_.least_room) {
      width = row.to - at;
    }
    rooms.push_back({at, at + width});
    at += width;
  }
  return rooms;
}

Interval OfficeBuilder::doorIn(const Interval& wall) {
  const double width = uniform(0.85, 1.15), edge = 0.3;
  const double from = uniform(wall.from + edge, wall.to - edge - width);
  return {from, from + width};
}

void OfficeBuilder::addWallAlongX(double y, const Interval& x, std::vector<Interval> openings) {
  std::sort(openings.begin(), openings.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  openings.push_back({x.to + thickness_ / 2, x.to + thickness_ / 2});
  double at = x.from - thickness_ / 2;
  for (const Interval& opening : openings) {
    if (opening.from > at) {
      addBox(world_, {(at + opening.from) / 2, y, 0}, opening.from - at, thickness_);
    }
    at = std::max(at, opening.to);
    if (opening.length() > 0) {
      doors_.emplace_back(opening.middle(), y);
    }
  }
}

void OfficeBuilder::addWallAlongY(double x, const Interval& y,
                                  const std::vector<Interval>& openings) {
  double at = y.from;
  for (const Interval& opening : openings) {
    addBox(world_, {x, (at + opening.from) / 2, 0}, thickness_, opening.from - at);
    at = opening.to;
    doors_.emplace_back(x, opening.middle());
  }
  addBox(world_, {x, (at + y.to) / 2, 0}, thickness_, y.to - at);
}

void OfficeBuilder::addRow(const Interval& corridor_x, double corridor_y, double outer_y) {
  const std::vector<Interval> rooms = splitRow(corridor_x);
  std::vector<Interval> front_doors;
  // Blocks of rooms end at depths of their own, so that the outline has steps.
  std::vector<double> ends;
  double outer = outer_y;
  const double inwards = outer_y > corridor_y ? -1 : 1;
  for (size_t i = 0; i < rooms.size(); ++i) {
    if (chance(0.3)) {
      outer = outer_y + inwards * (chance(0.5) ? 0 : uniform(0.3, 1.2));
    }
    ends.push_back(outer);
  }
  for (size_t i = 0; i < rooms.size(); ++i) {
    const Interval& x = rooms[i];
    if (chance(0.1)) {
      front_doors.push_back({x.from + 0.4, x.to - 0.4});  // A room that is open to the corridor.
    } else {
      front_doors.push_back(doorIn(x));
    }
    addWallAlongX(ends[i], x, {});
    if (i > 0) {
      const double end =
          inwards < 0 ? std::max(ends[i - 1], ends[i]) : std::min(ends[i - 1], ends[i]);
      const Interval y{std::min(corridor_y, end), std::max(corridor_y, end)};
      const double share =
          std::min(std::abs(ends[i - 1] - corridor_y), std::abs(ends[i] - corridor_y));
      std::vector<Interval> openings;
      if (chance(0.2)) {
        openings.push_back(inwards < 0 ? doorIn({corridor_y, corridor_y + share})
                                       : doorIn({corridor_y - share, corridor_y}));
      }
      addWallAlongY(x.from, y, openings);
    }
  }
  addWallAlongY(corridor_x.from,
                {std::min(corridor_y, ends.front()), std::max(corridor_y, ends.front())}, {});
  addWallAlongY(corridor_x.to,
                {std::min(corridor_y, ends.back()), std::max(corridor_y, ends.back())}, {});
  addWallAlongX(corridor_y, corridor_x, front_doors);
  for (size_t i = 0; i < rooms.size(); ++i) {
    addRoom(rooms[i], corridor_y, ends[i]);
  }
}

void OfficeBuilder::addRoom(const Interval& x, double corridor_y, double outer_y) {
  const double half = thickness_ / 2;
  const Interval y{std::min(corridor_y, outer_y) + half, std::max(corridor_y, outer_y) - half};
  const Room room{{x.from + half, x.to - half}, y};
  if (chance(0.2)) {  // A corner of the room is cut off.
    const double cut = uniform(0.8, 1.5);
    const double far = outer_y > corridor_y ? y.to : y.from;
    const double towards = outer_y > corridor_y ? -cut : cut;
    if (chance(0.5)) {
      world_.walls.push_back({{room.x.from, far + towards}, {room.x.from + cut, far}});
    } else {
      world_.walls.push_back({{room.x.to, far + towards}, {room.x.to - cut, far}});
    }
  }
  furnish(room);
  world_.places.emplace_back(x.middle() + uniform(-0.2, 0.2), y.middle() + uniform(-0.3, 0.3));
}

bool OfficeBuilder::placeBox(const Pose2D& centre, double length, double width) {
  const double reach = std::hypot(length, width) / 2;
  for (const Point2D& door : doors_) {
    if (std::hypot(door.x - centre.x, door.y - centre.y) < reach + kDoorFree) {
      return false;
    }
  }
  for (const Pose2D& other : furniture_) {
    if (std::hypot(other.x - centre.x, other.y - centre.y) < reach + other.phi) {
      return false;
    }
  }
  furniture_.emplace_back(centre.x, centre.y, reach);
  addBox(world_, centre, length, width);
  return true;
}

void OfficeBuilder::furnish(const Room& room) {
  const double area = room.x.length() * room.y.length();
  const int pieces =
      static_cast<int>(std::lround(area * options_.furniture_per_m2 + uniform(-1, 1)));
  // Not every try finds room.
  for (int placed = 0, tries = 0; placed < pieces && tries < 5 * pieces; ++tries) {
    const double length = uniform(0.6, 1.8), width = uniform(0.4, 0.9);
    if (chance(0.7)) {  // Against a wall.
      const int side = static_cast<int>(uniform(0, 4));
      const bool along_x = side < 2;
      const double gap = chance(0.7) ? 0 : 0.1;
      const double off = width / 2 + gap;
      const double x = along_x     ? uniform(room.x.from + length / 2, room.x.to - length / 2)
                       : side == 2 ? room.x.from + off
                                   : room.x.to - off;
      const double y = !along_x    ? uniform(room.y.from + length / 2, room.y.to - length / 2)
                       : side == 0 ? room.y.from + off
                                   : room.y.to - off;
      placed += placeBox({x, y, along_x ? 0 : M_PI / 2}, length, width) ? 1 : 0;
    } else if (room.x.length() > 4 && room.y.length() > 4) {  // In the room.
      const double x = uniform(room.x.from + 1, room.x.to - 1);
      const double y = uniform(room.y.from + 1, room.y.to - 1);
      const double turn = chance(0.5) ? 0 : uniform(-M_PI / 4, M_PI / 4);
      placed += placeBox({x, y, turn}, length, width) ? 1 : 0;
    }
  }
}

void OfficeBuilder::furnishCorridor(const Interval& x, const Interval& y) {
  for (double at = x.from + 2; at < x.to - 2; at += uniform(2, 7)) {
    const double length = uniform(0.5, 1.4), width = uniform(0.25, 0.4);
    const bool low = chance(0.5);
    placeBox({at, low ? y.from + width / 2 : y.to - width / 2, 0}, length, width);
  }
}

World OfficeBuilder::build() {
  thickness_ = uniform(0.1, 0.2);
  const Interval x{0, uniform(options_.least_length, options_.most_length)};
  const double lower = uniform(options_.least_depth, options_.most_depth);
  const double corridor = uniform(1.8, 2.6);
  const double upper = uniform(options_.least_depth, options_.most_depth);
  const Interval y{lower, lower + corridor};
  addRow(x, y.from, 0);
  addRow(x, y.to, y.to + upper);
  addWallAlongY(x.from, y, {});
  addWallAlongY(x.to, y, {});
  furnishCorridor({x.from + thickness_ / 2, x.to - thickness_ / 2},
                  {y.from + thickness_ / 2, y.to - thickness_ / 2});
  for (double at = x.from + 1.5; at < x.to - 1; at += 6) {
    world_.places.emplace_back(at, y.middle());
  }
  return std::move(world_);
}

}  // namespace

World randomOffice(std::uint32_t seed, const OfficeOptions& options) {
  return OfficeBuilder(seed, options).build();
}

}  // namespace sbox::dataset
