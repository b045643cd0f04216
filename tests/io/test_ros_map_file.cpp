// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/stat.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <random>

#include "catch.h"
#include "io/scratch_folder.h"
#include "io/test_maps.h"
#include "sbox/io/file_error.h"
#include "sbox/io/load_map.h"
#include "sbox/io/ros_map_file.h"

using namespace sbox;

namespace {

/// nav2's formula for one pixel, written down a second time: percent, or -1 for unknown.
double nav2Occupancy(const std::string& mode, bool negate, double occupied_thresh,
                     double free_thresh, double mean, int alpha) {
  if (mode == "raw") {
    return std::round(mean) > 100 ? -1 : std::round(mean);
  }
  const double shade = mean / 255;
  const double occupancy = negate ? shade : 1.0 - shade;
  if (alpha != 255) {
    return -1;
  }
  if (occupied_thresh < occupancy) {
    return 100;
  }
  if (mean == (negate ? 50 : 205)) {
    return -1;  // our departure: map_saver's grey for unknown
  }
  if (occupancy < free_thresh) {
    return 0;
  }
  return mode == "trinary"
             ? -1
             : std::rint((occupancy - free_thresh) / (occupied_thresh - free_thresh) * 100.0);
}

cv::Mat randomImage(int type) {
  cv::Mat image(23, 31, type);
  cv::RNG random(5);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  if (image.channels() == 4) {
    // Some pixels fully opaque, as most are in real images.
    for (int y = 0; y < image.rows; ++y) {
      for (int x = y % 2; x < image.cols; x += 2) {
        image.at<cv::Vec4b>(y, x)[3] = 255;
      }
    }
  }
  return image;
}

std::string yamlText(const std::string& image, const std::string& more = "") {
  return "image: " + image + "\nresolution: 0.05\norigin: [1, 2, 0]\n" + more;
}

/// Four grey pixels: top row black and white, bottom row 205 and 254.
const std::string four_pixels = std::string("P5\n2 2\n255\n") + "\x01\xFF\xCD\xFE";

}  // namespace

TEST_CASE("each pixel is read as nav2 reads it", "[ros_map_file]") {
  const ScratchFolder folder;
  const std::string mode = GENERATE("trinary", "scale", "raw");
  const bool negate = GENERATE(false, true);
  const int type = GENERATE(CV_8UC1, CV_8UC3, CV_8UC4);
  const auto [occupied, free] = GENERATE(table<double, double>({{0.65, 0.196}, {0.2, 0.05}}));
  const cv::Mat image = randomImage(type);
  cv::imwrite(folder.path("map.png"), image);
  folder.write("map.yaml",
               yamlText("map.png", "mode: " + mode + "\nnegate: " + (negate ? "1" : "0") +
                                       "\noccupied_thresh: " + std::to_string(occupied) +
                                       "\nfree_thresh: " + std::to_string(free) + "\n"));
  const Map map = loadRosMap(folder.path("map.yaml"));
  REQUIRE(map.width() == image.cols);
  REQUIRE(map.height() == image.rows);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const std::uint8_t* pixel = image.ptr(image.rows - 1 - y, x);
      const int alpha = image.channels() == 4 ? pixel[3] : 255;
      const double mean =
          image.channels() == 1 ? pixel[0] : (0.0 + pixel[0] + pixel[1] + pixel[2]) / 3;
      const double percent = nav2Occupancy(mode, negate, occupied, free, mean, alpha);
      const double p_free = percent < 0 ? 0.5 : std::min(0.99, std::max(0.01, 1 - percent / 100));
      // MRPT keeps log-odds in steps of 1/16: at most 0.016 in probability.
      CHECK(map.grid.getCell(x, y) == Approx(p_free).margin(0.017));
    }
  }
}

TEST_CASE("the origin is kept exactly, with its yaw", "[ros_map_file]") {
  const ScratchFolder folder;
  folder.write("a.pgm", four_pixels);
  folder.write("a.yaml",
               "image: a.pgm\nresolution: 0.05\norigin: [-51.224998, 1e-3, 3.14]\nnegate: 0\n");
  const Map map = loadMap(folder.path("a.yaml"));
  CHECK(map.name == folder.path("a.yaml"));
  CHECK(map.corner_in_map.x == -51.224998);
  CHECK(map.corner_in_map.y == 0.001);
  CHECK(map.corner_in_map.phi == 3.14);
  CHECK(map.grid.getResolution() == 0.05F);
  CHECK(drawing(map) == std::vector<std::string>{"#.", " ."});
}

TEST_CASE("a yaw may be a full turn, however rounded", "[ros_map_file]") {
  const ScratchFolder folder;
  folder.write("a.pgm", four_pixels);
  const std::string path =
      folder.write("a.yaml", "image: a.pgm\nresolution: 0.05\norigin: [0, 0, -6.2832]\n");
  CHECK(loadMap(path).corner_in_map.phi == Approx(-6.2832));
}

TEST_CASE("what a .yaml leaves out has ROS's defaults", "[ros_map_file]") {
  const ScratchFolder folder;
  folder.write("a.pgm", four_pixels);
  folder.write("a.yaml", yamlText("a.pgm"));
  CHECK(drawing(loadMap(folder.path("a.yaml"))) == std::vector<std::string>{"#.", " ."});
}

TEST_CASE("unknown stays unknown with nav2's own free threshold", "[ros_map_file]") {
  const ScratchFolder folder;
  folder.write("a.pgm", four_pixels);
  folder.write("a.yaml", yamlText("a.pgm", "free_thresh: 0.25\noccupied_thresh: 0.65\n"));
  CHECK(drawing(loadMap(folder.path("a.yaml"))) == std::vector<std::string>{"#.", " ."});
}

TEST_CASE("negate is an integer or a word", "[ros_map_file]") {
  const ScratchFolder folder;
  folder.write("a.pgm", four_pixels);
  for (const std::string word : {"1", "true", "yes"}) {
    folder.write("a.yaml", yamlText("a.pgm", "negate: " + word + "\n"));
    CHECK(drawing(loadMap(folder.path("a.yaml"))) == std::vector<std::string>{".#", "##"});
  }
  for (const std::string word : {"0", "false", "no"}) {
    folder.write("a.yaml", yamlText("a.pgm", "negate: " + word + "\n"));
    CHECK(drawing(loadMap(folder.path("a.yaml"))) == std::vector<std::string>{"#.", " ."});
  }
}

TEST_CASE("the image is found from the folder of the .yaml or by its full path", "[ros_map_file]") {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path("maps/images"));
  folder.write("maps/images/a.pgm", four_pixels);
  folder.write("maps/a.yaml", yamlText("images/a.pgm"));
  CHECK(loadMap(folder.path("maps/a.yaml")).width() == 2);
  folder.write("b.yaml", yamlText(folder.path("maps/images/a.pgm")));
  CHECK(loadMap(folder.path("b.yaml")).width() == 2);
}

TEST_CASE("an image alone lies at the origin and needs a resolution", "[ros_map_file]") {
  const ScratchFolder folder;
  folder.write("a.pgm", four_pixels);
  const Map map = loadMap(folder.path("a.pgm"), {0.2});
  CHECK(map.resolution() == Approx(0.2));
  CHECK(map.corner_in_map.x == 0);
  CHECK(map.corner_in_map.y == 0);
  CHECK(drawing(map) == std::vector<std::string>{"#.", " ."});
  CHECK_THROWS_AS(loadMap(folder.path("a.pgm")), FileError);
  for (const double bad : {0.0, -0.05, std::nan(""), HUGE_VAL, 1e-30}) {
    CHECK_THROWS_AS(loadMap(folder.path("a.pgm"), {bad}), FileError);
  }
}

TEST_CASE("a .yaml that cannot be used is named with the reason", "[ros_map_file]") {
  const ScratchFolder folder;
  folder.write("a.pgm", four_pixels);
  const std::string path = folder.path("a.yaml");
  const auto [text, reason] = GENERATE(table<std::string, std::string>({
      {"resolution: 0.05\norigin: [0, 0, 0]\n", "\"image\" is missing"},
      {"image: a.pgm\norigin: [0, 0, 0]\n", "\"resolution\" is missing"},
      {"image: a.pgm\nresolution: 0.05\n", "\"origin\" is missing"},
      {"image: a.pgm\nresolution: x\norigin: [0, 0, 0]\n", "\"resolution\" is not a number: x"},
      {"image: a.pgm\nresolution: .nan\norigin: [0, 0, 0]\n",
       "\"resolution\" is not a number: .nan"},
      {"image: a.pgm\nresolution: nan\norigin: [0, 0, 0]\n", "\"resolution\" is not a number: nan"},
      {"image: a.pgm\nresolution: 0\norigin: [0, 0, 0]\n",
       "resolution 0 m is not between 0.001 and 100 m"},
      {"image: a.pgm\nresolution: [1]\norigin: [0, 0, 0]\n",
       "\"resolution\" is not a single value"},
      {"image: a.pgm\nresolution: 0.05\norigin: 3\n",
       "\"origin\" is not a list of three numbers: x and y in metres, yaw in radians"},
      {"image: a.pgm\nresolution: 0.05\norigin: [0, 0]\n",
       "\"origin\" is not a list of three numbers: x and y in metres, yaw in radians"},
      {"image: a.pgm\nresolution: 0.05\norigin: [0, inf, 0]\n", "\"origin\" is not a number: inf"},
      {"image: a.pgm\nresolution: 0.05\norigin: [1e10, 0, 0]\n",
       "lies too far from the zero of its frame: x 1e+10 m, y 0 m"},
      {"image: a.pgm\nresolution: 0.05\norigin: [0, 0, 90]\n",
       "\"origin\" has a yaw beyond a full turn; it is in radians"},
      {yamlText("a.pgm", "mode: wild\n"), "\"mode\" is not trinary, scale or raw but wild"},
      {yamlText("a.pgm", "negate: maybe\n"), "\"negate\" is not a number: maybe"},
      {yamlText("a.pgm", "occupied_thresh: 65\n"),
       "\"occupied_thresh\" is not between 0 and 1: 65"},
      {yamlText("a.pgm", "occupied_thresh: 0.1\n"),
       "\"free_thresh\" is not below \"occupied_thresh\""},
      {"- image: a.pgm\n", "is no YAML of a map: line 1 has no \"key: value\""},
      {std::string("\x00\x01\xFF", 3), "is no YAML of a map: it holds binary data"},
      {"# nothing\n", "\"image\" is missing"},
      {"", "is empty"},
  }));
  folder.write("a.yaml", text);
  CHECK_THROWS_WITH(loadMap(path), path + ": " + reason);
}

TEST_CASE("a .yaml whose image cannot be used names both", "[ros_map_file]") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("folder"));
  folder.write("empty.pgm", "");
  folder.write("text.png", "hello");
  const auto [image, reason] = GENERATE(table<std::string, std::string>({
      {"missing.pgm", "no such file"},
      {"folder", "is a folder, not a file"},
      {"empty.pgm", "is empty"},
      {"text.png", "is not an image (PNG, PGM, BMP, JPEG or TIFF), or is damaged"},
      {"a.yaml", "is not an image (PNG, PGM, BMP, JPEG or TIFF), or is damaged"},
  }));
  const std::string path = folder.write("a.yaml", yamlText(image));
  CHECK_THROWS_WITH(loadMap(path),
                    folder.path(image) + ": " + reason + " (it is the image of " + path + ")");
}

TEST_CASE("a .yaml may point anywhere, but only an image is read there", "[ros_map_file]") {
  const ScratchFolder folder;
  mkfifo(folder.path("pipe").c_str(), 0600);
  for (const char* image : {"/dev/zero", "/dev/null", "/proc/self/mem", "pipe", "/etc/passwd",
                            "../../../../../../etc/passwd", "..", "/"}) {
    INFO(image);
    const std::string path = folder.write("a.yaml", yamlText(image));
    CHECK_THROWS_AS(loadMap(path), FileError);
  }
}
