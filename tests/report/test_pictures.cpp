// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "catch.h"
#include "sbox/report/drawing/palette.h"
#include "sbox/report/overlay_picture.h"
#include "sbox/report/pictures.h"

using namespace sbox;

namespace {

/// A room of width x height cells with walls all round.
Map room(const std::string& name, int width, int height, double resolution) {
  Map map = makeMap(name, width, height, resolution);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool wall = x == 0 || y == 0 || x == width - 1 || y == height - 1;
      map.grid.setCell(x, y, wall ? 0.05F : 0.95F);
    }
  }
  return map;
}

int pixelsOf(const cv::Mat& picture, const palette::Colour& colour) {
  cv::Mat same;
  cv::inRange(picture, palette::scalar(colour), palette::scalar(colour), same);
  return cv::countNonZero(same);
}

MergeResult resultOf(const std::vector<Map>& maps) {
  MergeResult result;
  for (const Map& map : maps) {
    MapOutcome outcome;
    outcome.name = map.name;
    outcome.features.boxes = {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
    outcome.features.vertical_points = {{0, 0}, {1, 1}};
    outcome.features.lines = {{{0, 0}, {1, 0}}};
    result.maps.push_back(outcome);
  }
  for (int a = 0; a < static_cast<int>(maps.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(maps.size()); ++b) {
      MapPair pair{a, b, {}};
      pair.result.has_pose = true;
      pair.result.confidence = b == a + 1 ? 0.9 : 0.1;
      pair.result.matched_boxes = {{0, 0}};
      result.pairs.push_back(pair);
    }
  }
  return result;
}

std::set<std::string> fileNames(const std::vector<Picture>& pictures) {
  std::set<std::string> names;
  for (const Picture& picture : pictures) {
    names.insert(picture.file_name);
  }
  return names;
}

}  // namespace

TEST_CASE("two maps give features, boxes, overlay and the merged map") {
  const std::vector<Map> maps{room("x/map.yaml", 60, 40, 0.05), room("y/map.yaml", 60, 40, 0.05)};
  MergeResult result = resultOf(maps);
  result.merged.resize(1);
  result.merged[0].members = {0, 1};
  result.merged[0].map = maps[0];
  const std::vector<Picture> pictures = drawPictures(maps, result, 2);
  CHECK(pictures.size() == 5);
  CHECK(fileNames(pictures) == std::set<std::string>{"features_x_map.png", "features_y_map.png",
                                                     "boxes_x_map_y_map.png",
                                                     "overlay_x_map_y_map.png", "merged.png"});
  for (const Picture& picture : pictures) {
    const cv::Mat read = cv::imdecode(picture.png, cv::IMREAD_COLOR);
    INFO(picture.file_name);
    CHECK(std::max(read.cols, read.rows) <= 2000);
    CHECK(std::max(read.cols, read.rows) >= 1000);
  }
}

TEST_CASE("pictures of names that could be joined in two ways stay apart") {
  const std::vector<Map> maps{room("a", 9, 9, 0.1), room("b_c", 9, 9, 0.1), room("a_b", 9, 9, 0.1),
                              room("c", 9, 9, 0.1)};
  const std::vector<Picture> pictures = drawPictures(maps, resultOf(maps), 1);
  CHECK(fileNames(pictures).size() == pictures.size());
}

TEST_CASE("each map shows its most confident pair and no more") {
  std::vector<Map> maps;
  for (int i = 0; i < 6; ++i) {
    maps.push_back(room("r" + std::to_string(i), 9, 9, 0.1));
  }
  const std::set<std::string> names = fileNames(drawPictures(maps, resultOf(maps), 0));
  CHECK(names.count("overlay_r0_r1.png") == 1);
  CHECK(names.count("overlay_r0_r5.png") == 0);
  CHECK(names.size() <= 6 + 2 * 6);
}

TEST_CASE("pictures do not depend on the number of threads") {
  const std::vector<Map> maps{room("a", 50, 30, 0.05), room("b", 30, 50, 0.05)};
  const std::vector<Picture> one = drawPictures(maps, resultOf(maps), 1);
  const std::vector<Picture> many = drawPictures(maps, resultOf(maps), 3);
  REQUIRE(one.size() == many.size());
  for (size_t i = 0; i < one.size(); ++i) {
    CHECK(one[i].png == many[i].png);
  }
}

TEST_CASE("maps of any size and without any known cell can be drawn") {
  const std::vector<Map> maps{room("dot", 1, 1, 0.05), makeMap("blank", 5, 5, 0.05),
                              room("long", 30000, 3, 0.02)};
  for (const Picture& picture : drawPictures(maps, resultOf(maps), 1)) {
    const cv::Mat read = cv::imdecode(picture.png, cv::IMREAD_COLOR);
    INFO(picture.file_name);
    CHECK(std::max(read.cols, read.rows) <= 2000);
  }
}

TEST_CASE("the overlay tells agreeing, lone and conflicting walls apart") {
  const StateGrid small = classifyCells(room("small", 60, 60, 0.05));
  const StateGrid large = classifyCells(room("large", 120, 120, 0.05));
  const Pose2D same, far{20, 0, 0}, inside{1.5, 1.5, 0};

  const cv::Mat agreeing = drawOverlay(small, small, same, "", "a", "b");
  const cv::Mat apart = drawOverlay(small, small, far, "", "a", "b");
  const cv::Mat conflicting = drawOverlay(large, small, inside, "", "a", "b");
  // The legend shows each colour once, on a few hundred pixels.
  const int legend = 1500;
  CHECK(pixelsOf(agreeing, palette::agreeing_wall) > legend);
  CHECK(pixelsOf(agreeing, palette::blue) < legend);
  CHECK(pixelsOf(agreeing, palette::orange) < legend);
  CHECK(pixelsOf(apart, palette::blue) > legend);
  CHECK(pixelsOf(apart, palette::orange) > legend);
  CHECK(pixelsOf(apart, palette::agreeing_wall) < legend);
  CHECK(pixelsOf(apart, palette::magenta) < legend);
  CHECK(pixelsOf(conflicting, palette::magenta) > legend);
}
