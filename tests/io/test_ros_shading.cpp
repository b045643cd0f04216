// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/io/ros_shading.h"

using namespace sbox;

TEST_CASE("trinary shades are occupied, free or unknown by strict thresholds", "[ros_shading]") {
  const RosShading shading{RosMode::Trinary, false, 0.6, 0.2};
  CHECK(rosOccupancy(0, shading) == 100);
  CHECK(rosOccupancy(101, shading) == 100);
  CHECK(rosOccupancy(102, shading) == ros_unknown);  // an occupancy of exactly 0.6
  CHECK(rosOccupancy(204, shading) == ros_unknown);  // exactly 0.2
  CHECK(rosOccupancy(206, shading) == 0);
  CHECK(rosOccupancy(255, shading) == 0);
}

TEST_CASE("negate swaps black and white", "[ros_shading]") {
  const RosShading plain{RosMode::Trinary, false, 0.65, 0.25};
  const RosShading negated{RosMode::Trinary, true, 0.65, 0.25};
  for (int shade = 0; shade <= 255; ++shade) {
    CHECK(rosOccupancy(shade, negated) == rosOccupancy(255 - shade, plain));
  }
}

TEST_CASE("the grey that map_saver writes for unknown is never free", "[ros_shading]") {
  for (const double free_thresh : {0.1, 0.196, 0.25, 0.5}) {
    CHECK(rosOccupancy(205, {RosMode::Trinary, false, 0.65, free_thresh}) == ros_unknown);
    CHECK(rosOccupancy(205, {RosMode::Scale, false, 0.65, free_thresh}) == ros_unknown);
    CHECK(rosOccupancy(205, {RosMode::Raw, false, 0.65, free_thresh}) == ros_unknown);
  }
  CHECK(rosOccupancy(206, {RosMode::Trinary, false, 0.65, 0.25}) == 0);
  CHECK(rosOccupancy(205, {RosMode::Trinary, false, 0.1, 0.05}) == 100);
}

TEST_CASE("scaled shades rise in a line between the thresholds", "[ros_shading]") {
  const RosShading shading{RosMode::Scale, false, 0.75, 0.25};
  CHECK(rosOccupancy(255 * 0.8, shading) == 0);
  CHECK(rosOccupancy(255 * 0.2, shading) == 100);
  CHECK(rosOccupancy(127.5, shading) == 50);
  CHECK(rosOccupancy(255 * 0.6, shading) == 30);
  CHECK(rosOccupancy(255 * 0.3, shading) == 90);
}

TEST_CASE("raw shades are percent, whatever the thresholds", "[ros_shading]") {
  const RosShading shading{RosMode::Raw, true, 0.2, 0.1};
  for (int shade = 0; shade <= 255; ++shade) {
    CHECK(rosOccupancy(shade, shading) == (shade <= 100 ? shade : ros_unknown));
  }
}

TEST_CASE("cells hold the probability of being free", "[ros_shading]") {
  using Grid = mrpt::maps::COccupancyGridMap2D;
  CHECK(rosCell(ros_unknown) == 0);
  CHECK(Grid::l2p(rosCell(50)) == Approx(0.5));
  CHECK(Grid::l2p(rosCell(0)) == Approx(0.99).margin(0.002));
  CHECK(Grid::l2p(rosCell(100)) == Approx(0.01).margin(0.002));
  CHECK(Grid::l2p(rosCell(20)) == Approx(0.8).margin(0.02));
  CHECK(Grid::l2p(rosCell(90)) == Approx(0.1).margin(0.02));
}

TEST_CASE("the table holds the cell of each mean of colours", "[ros_shading]") {
  const int channels = GENERATE(1, 3);
  const RosShading shading{RosMode::Scale, false, 0.65, 0.25};
  const auto table = rosCellTable(shading, channels);
  REQUIRE(table.size() == static_cast<size_t>(255 * channels + 1));
  for (int sum = 0; sum <= 255 * channels; ++sum) {
    const double mean = static_cast<double>(sum) / channels;
    CHECK(table[static_cast<size_t>(sum)] == rosCell(rosOccupancy(mean, shading)));
  }
}
