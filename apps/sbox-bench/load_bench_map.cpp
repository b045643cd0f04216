// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/load_bench_map.h"

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

namespace sbox::bench {

Map loadBenchMap(const std::string& path) {
  const std::string image_file = std::filesystem::path(path).replace_extension(".png").string();
  const cv::Mat image = cv::imread(image_file, cv::IMREAD_GRAYSCALE);
  if (image.empty()) {
    throw std::runtime_error(image_file + ": cannot be read as an image");
  }
  double resolution = 0.05;
  std::ifstream yaml(std::filesystem::path(path).replace_extension(".yaml"));
  for (std::string key; yaml >> key;) {
    if (key == "resolution:") {
      yaml >> resolution;
    }
  }
  Map map = makeMap(path, image.cols, image.rows, resolution);
  for (int y = 0; y < image.rows; ++y) {
    const unsigned char* row = image.ptr(image.rows - 1 - y);
    for (int x = 0; x < image.cols; ++x) {
      map.grid.setCell(x, y, row[x] > 230 ? 0.99F : row[x] < 90 ? 0.01F : 0.5F);
    }
  }
  return map;
}

}  // namespace sbox::bench
