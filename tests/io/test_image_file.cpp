// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <unistd.h>

#include <opencv2/imgcodecs.hpp>
#include <random>

#include "catch.h"
#include "io/contains.h"
#include "io/scratch_folder.h"
#include "sbox/io/file_error.h"
#include "sbox/io/image_file.h"

using namespace sbox;

namespace {

Image load(const ScratchFolder& folder, const std::string& contents) {
  return loadImage(folder.write("image", contents));
}

cv::Mat randomPixels(int width, int height, int type) {
  cv::Mat pixels(height, width, type);
  cv::RNG random(3);
  random.fill(pixels, cv::RNG::UNIFORM, 0, CV_MAT_DEPTH(type) == CV_16U ? 65536 : 256);
  return pixels;
}

std::string encoded(const std::string& extension, const cv::Mat& pixels) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(extension, pixels, bytes);
  return {bytes.begin(), bytes.end()};
}

std::string bigEndian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16),
          static_cast<char>(value >> 8), static_cast<char>(value)};
}

/// What the error says; empty if there is none.
std::string complaint(const ScratchFolder& folder, const std::string& bytes) {
  try {
    (void)load(folder, bytes);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("lossless images keep every pixel", "[image_file]") {
  const ScratchFolder folder;
  const std::string extension = GENERATE(".png", ".bmp", ".tif", ".pgm");
  const cv::Mat pixels = randomPixels(33, 20, CV_8UC1);
  const Image image = load(folder, encoded(extension, pixels));
  CHECK(image.width == 33);
  CHECK(image.height == 20);
  REQUIRE(image.channels == 1);
  CHECK(image.pixels == Bytes(pixels.begin<std::uint8_t>(), pixels.end<std::uint8_t>()));
}

TEST_CASE("a JPEG is read", "[image_file]") {
  const ScratchFolder folder;
  const Image image = load(folder, encoded(".jpg", cv::Mat(20, 33, CV_8UC1, cv::Scalar(205))));
  CHECK(image.width == 33);
  CHECK(image.height == 20);
  CHECK(image.pixels[0] == 205);
}

TEST_CASE("colours and opacity keep their channels", "[image_file]") {
  const ScratchFolder folder;
  const cv::Mat colour(1, 1, CV_8UC3, cv::Scalar(1, 2, 3));
  for (const char* extension : {".png", ".bmp", ".tif"}) {
    CHECK(load(folder, encoded(extension, colour)).pixels == Bytes{1, 2, 3});
  }
  CHECK(load(folder, encoded(".ppm", colour)).pixels == Bytes{3, 2, 1});
  const Image image = load(folder, encoded(".png", cv::Mat(1, 1, CV_8UC4, cv::Scalar(1, 2, 3, 4))));
  CHECK(image.channels == 4);
  CHECK(image.pixels == Bytes{1, 2, 3, 4});
}

TEST_CASE("16 bits are rounded to 8", "[image_file]") {
  const ScratchFolder folder;
  const std::string extension = GENERATE(".png", ".pgm", ".tif");
  const cv::Mat pixels = randomPixels(33, 20, CV_16UC1);
  const Image image = load(folder, encoded(extension, pixels));
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 33; ++x) {
      CHECK(image.row(y)[x] == Approx(pixels.at<std::uint16_t>(y, x) / 257.0).margin(0.501));
    }
  }
}

TEST_CASE("PNM images are read in each of their forms", "[image_file]") {
  const ScratchFolder folder;
  const Bytes greys{0, 127, 205, 255};
  CHECK(load(folder, std::string("P5\n2 2\n255\n\x00\x7F\xCD\xFF", 15)).pixels == greys);
  CHECK(
      load(folder, std::string("P5 # one\n2 # two\n#three\n2 255\n\x00\x7F\xCD\xFF", 35)).pixels ==
      greys);
  CHECK(load(folder, "P2\n2 2 255\n0 127\n# half\n205 255").pixels == greys);
  CHECK(load(folder, "P2 2 2 100 0 50 80 100\n").pixels == Bytes{0, 128, 204, 255});
  CHECK(load(folder, std::string("P5 2 2 100\n\x00\x32\x50\x64", 15)).pixels ==
        Bytes{0, 128, 204, 255});
  CHECK(load(folder, "P3 1 1 255 1 2 3").pixels == Bytes{1, 2, 3});
  // A pixel may have the value of a line break.
  CHECK(load(folder, "P5 1 1 255\n\n").pixels == Bytes{10});
}

TEST_CASE("a PNG with a faulty colour profile is read in silence", "[image_file]") {
  const ScratchFolder folder;
  std::string png = encoded(".png", cv::Mat(2, 2, CV_8UC1, cv::Scalar(7)));
  // The CRC-32 of "iCCPx" and two zero bytes.
  const std::string profile =
      bigEndian(3) + "iCCPx" + std::string(2, '\0') + bigEndian(0x8432ba59U);
  png.insert(8 + 25, profile);
  CHECK(load(folder, png).pixels == Bytes(4, 7));
}

TEST_CASE("an image cut off anywhere is refused", "[image_file]") {
  const ScratchFolder folder;
  const auto [extension, text] =
      GENERATE(table<std::string, std::string>({{".png", ""},
                                                {".bmp", ""},
                                                {".jpg", ""},
                                                {".pgm", ""},
                                                {"", "P2\n2 2\n255\n0 127 205 255"}}));
  const std::string whole =
      extension.empty() ? text : encoded(extension, randomPixels(9, 7, CV_8UC1));
  // The last number of a text may lose a digit unseen.
  const std::size_t longest = extension.empty() ? whole.size() - 3 : whole.size() - 1;
  for (std::size_t size = 0; size <= longest; ++size) {
    INFO(size << " of " << whole.size() << " bytes of " << extension);
    CHECK_THROWS_AS(load(folder, whole.substr(0, size)), FileError);
  }
}

TEST_CASE("a damaged PNG is refused", "[image_file]") {
  const ScratchFolder folder;
  const std::string whole = encoded(".png", randomPixels(9, 7, CV_8UC1));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
    INFO("byte " << at);
    CHECK_THROWS_AS(load(folder, damaged), FileError);
  }
}

TEST_CASE("an image with more pixels than a map may have is refused by its header",
          "[image_file]") {
  const ScratchFolder folder;
  std::string png = encoded(".png", randomPixels(9, 7, CV_8UC1));
  png.replace(16, 8, bigEndian(100000) + bigEndian(100000));
  std::string bmp = encoded(".bmp", randomPixels(9, 7, CV_8UC1));
  bmp.replace(18, 8, std::string("\x00\x00\x01\x00\x00\x00\x01\x00", 8));
  std::string jpg = encoded(".jpg", randomPixels(9, 7, CV_8UC1));
  jpg.replace(jpg.find("\xFF\xC0") + 5, 4, "\xFF\xFF\xFF\xFF");
  const std::string pgm = "P5 100000 100000 255\n";
  const std::string empty = "P5 0 1 255\n\n";
  for (const std::string& contents : {png, bmp, jpg, pgm, empty}) {
    try {
      load(folder, contents);
      FAIL("was read");
    } catch (const FileError& error) {
      CHECK(contains(error.reason(), "cells"));
    }
  }
}

TEST_CASE("random bytes after an image's signature are refused", "[image_file]") {
  const ScratchFolder folder;
  const std::string signature =
      GENERATE("\x89PNG\r\n\x1a\n", "P5\n", "P2\n", "BM", "\xFF\xD8\xFF", "II*", "");
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    std::string contents = signature;
    for (int i = 0; i < 200; ++i) {
      contents.push_back(static_cast<char>(random() % 256));
    }
    CHECK_THROWS_AS(load(folder, contents), FileError);
  }
}

TEST_CASE("a folder, a device and a missing file are no images", "[image_file]") {
  const ScratchFolder folder;
  CHECK_THROWS_AS(loadImage(folder.path(".")), FileError);
  CHECK_THROWS_AS(loadImage("/dev/zero"), FileError);
  CHECK_THROWS_AS(loadImage(folder.path("missing")), FileError);
}

TEST_CASE("an image's name is known by its extension in any case", "[image_file]") {
  CHECK(isImagePath("a/b.PNG"));
  CHECK(isImagePath("b.pgm"));
  CHECK_FALSE(isImagePath("a.png/b"));
  CHECK_FALSE(isImagePath("b.png.gz"));
  CHECK_FALSE(isImagePath(".png"));
}

TEST_CASE("an image that claims more pixels than its bytes can hold is refused unread",
          "[image_file]") {
  const ScratchFolder folder;
  const std::string size = bigEndian(20000);
  std::string png = encoded(".png", randomPixels(9, 7, CV_8UC1));
  png.replace(16, 8, size + size);
  std::string jpeg = encoded(".jpg", randomPixels(9, 7, CV_8UC1));
  // Height and width stand behind the marker of the frame, its length and the sample size.
  jpeg.replace(jpeg.find("\xFF\xC0") + 5, 4, std::string("\x4E\x20\x4E\x20", 4));
  std::string bmp = encoded(".bmp", randomPixels(9, 7, CV_8UC1));
  bmp.replace(18, 8, std::string("\x20\x4E\0\0\x20\x4E\0\0", 8));
  for (const std::string& bytes : {png, jpeg, bmp}) {
    CHECK(contains(complaint(folder, bytes), "ends too early: the image is truncated"));
  }
  // The largest numbers there are must not overflow.
  bmp.replace(18, 12, std::string("\xFF\xFF\xFF\x7F\0\0\0\x80\x01\0\xFF\xFF", 12));
  CHECK(contains(complaint(folder, bmp), "more than the 400000000"));
}

TEST_CASE("a damaged image of any kind is refused in silence", "[image_file]") {
  const ScratchFolder folder;
  const int kept = dup(STDERR_FILENO);
  const std::string log = folder.write("log", "");
  const int file = open(log.c_str(), O_WRONLY);
  dup2(file, STDERR_FILENO);
  const cv::Mat pixels = randomPixels(19, 17, CV_8UC1);
  std::mt19937 random(7);
  for (const char* extension : {".png", ".jpg", ".tif", ".bmp", ".pgm"}) {
    const std::string whole = encoded(extension, pixels);
    for (int i = 0; i < 200; ++i) {
      std::string damaged = whole;
      for (int hits = 0; hits < 3; ++hits) {
        damaged[random() % whole.size()] = static_cast<char>(random());
      }
      (void)complaint(folder, damaged);
    }
  }
  dup2(kept, STDERR_FILENO);
  close(kept);
  close(file);
  CHECK(folder.read("log").empty());
}
