// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <limits>
#include <stdexcept>

#include "sbox-dataset/text_lines.h"

namespace sbox::dataset {
void addBox(World& world, const Pose2D& centre_in_world, double length, double width) {
  const std::array<Point2D, 4> corners{
      centre_in_world.composePoint({-length / 2, -width / 2}),
      centre_in_world.composePoint({length / 2, -width / 2}),
      centre_in_world.composePoint({length / 2, width / 2}),
      centre_in_world.composePoint({-length / 2, width / 2}),
  };
  for (size_t i = 0; i < corners.size(); ++i) {
    world.walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
}

World loadWorld(const std::string& path) {
  World world;
  for (const TextLine& line : readTextLines(path)) {
    const std::vector<double>& n = line.numbers;
    if (line.keyword == "wall") {
      line.expect(n.size() >= 4 && n.size() % 2 == 0, "wall x y x y [x y ...]");
      for (size_t i = 3; i < n.size(); i += 2) {
        world.walls.push_back({{n[i - 3], n[i - 2]}, {n[i - 1], n[i]}});
      }
    } else if (line.keyword == "slab") {
      line.expect(n.size() == 5, "slab x y x y thickness");
      const double dx = n[2] - n[0], dy = n[3] - n[1];
      addBox(world, {(n[0] + n[2]) / 2, (n[1] + n[3]) / 2, std::atan2(dy, dx)}, std::hypot(dx, dy),
             n[4]);
    } else if (line.keyword == "place") {
      line.expect(n.size() == 2, "place x y");
      world.places.emplace_back(n[0], n[1]);
    } else if (line.keyword == "yardstick") {
      line.expect(n.size() == 4, "yardstick x y x y");
      world.yardsticks.push_back({{n[0], n[1]}, {n[2], n[3]}});
    } else {
      line.expect(line.keyword == "box" && n.size() == 5, "box x y length width angle_deg");
      addBox(world, {n[0], n[1], n[4] * M_PI / 180}, n[2], n[3]);
    }
  }
  return world;
}

void saveWorld(const World& world, const std::string& path) {
  std::ofstream file(path);
  file << std::setprecision(10);
  const auto writeSegments = [&](const char* keyword, const std::vector<LineSegment>& segments) {
    for (const LineSegment& s : segments) {
      file << keyword << ' ' << s.from.x << ' ' << s.from.y << "  " << s.to.x << ' ' << s.to.y
           << '\n';
    }
  };
  writeSegments("wall", world.walls);
  for (const Point2D& place : world.places) {
    file << "place " << place.x << ' ' << place.y << '\n';
  }
  writeSegments("yardstick", world.yardsticks);
  if (!file.flush()) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

double distanceToWall(const World& world, const Point2D& eye, double angle) {
  const Point2D ray(std::cos(angle), std::sin(angle));
  double nearest = std::numeric_limits<double>::infinity();
  for (const LineSegment& wall : world.walls) {
    // eye + distance * ray = wall.from + share * along, by Cramer's rule.
    const Point2D along = wall.to - wall.from, to_wall = wall.from - eye;
    const double determinant = along.x * ray.y - along.y * ray.x;
    if (determinant == 0) {
      continue;
    }
    const double distance = (along.x * to_wall.y - along.y * to_wall.x) / determinant;
    const double share = (ray.x * to_wall.y - ray.y * to_wall.x) / determinant;
    if (distance >= 0 && share >= 0 && share <= 1) {
      nearest = std::min(nearest, distance);
    }
  }
  return nearest;
}

}  // namespace sbox::dataset
