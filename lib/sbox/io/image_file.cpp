// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/image_file.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "sbox/io/file_error.h"
#include "sbox/io/image_header.h"
#include "sbox/io/map_checks.h"
#include "sbox/io/path_extension.h"
#include "sbox/io/png_chunks.h"
#include "sbox/io/pnm_image.h"
#include "sbox/io/silent_stderr.h"

namespace sbox {
namespace {

/// Four channels of a largest map, uncompressed.
constexpr std::uint64_t max_image_bytes = 4 * max_map_cells;

Image decode(const std::string& path, const Bytes& bytes) {
  cv::Mat decoded;
  std::optional<SilentStderr> silent(std::in_place);
  try {
    decoded = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    decoded.release();
  }
  silent.reset();
  if (decoded.empty()) {
    throw FileError(path, "is damaged: the image cannot be decoded");
  }
  if (decoded.depth() == CV_16U) {
    decoded.convertTo(decoded, CV_8U, 1.0 / 257);
  }
  if (decoded.depth() != CV_8U || decoded.channels() == 2 || decoded.channels() > 4) {
    throw FileError(path, "has pixels of a kind that cannot be read; save it as 8-bit grey");
  }
  Image image{decoded.cols, decoded.rows, decoded.channels(), {}};
  image.pixels.reserve(decoded.total() * decoded.elemSize());
  for (int y = 0; y < decoded.rows; ++y) {
    const std::uint8_t* row = decoded.ptr(y);
    image.pixels.insert(image.pixels.end(), row,
                        row + static_cast<std::size_t>(decoded.cols) * decoded.elemSize());
  }
  return image;
}

}  // namespace

bool isImagePath(const std::string& path) {
  constexpr const char* extensions[] = {".png", ".pgm",  ".ppm", ".pnm", ".bmp",
                                        ".jpg", ".jpeg", ".tif", ".tiff"};
  return std::find(std::begin(extensions), std::end(extensions), pathExtension(path)) !=
         std::end(extensions);
}

Image loadImage(const std::string& path) {
  const Bytes bytes = readFile(path, max_image_bytes);
  const std::optional<ImageHeader> header = readImageHeader(bytes);
  if (!header) {
    throw FileError(path, "is not an image (PNG, PGM, BMP, JPEG or TIFF), or is damaged");
  }
  checkMapSize(path, header->width, header->height);
  if (!header->whole) {
    throwTruncated(path, "image");
  }
  switch (header->kind) {
    case ImageKind::Pnm:
      return decodePnm(path, bytes);
    case ImageKind::Png:
      return decode(path, essentialPngChunks(path, bytes));
    case ImageKind::Other:
      break;
  }
  return decode(path, bytes);
}

void saveGreyImage(const Image& image, const std::string& path) {
  if (pathExtension(path) == ".pgm") {
    writeFile(path, encodePgm(image));
    return;
  }
  const cv::Mat pixels(image.height, image.width, CV_8UC1,
                       const_cast<std::uint8_t*>(image.pixels.data()));
  Bytes bytes;
  if (!cv::imencode(".png", pixels, bytes)) {
    throw FileError(path, "cannot be encoded as PNG");
  }
  writeFile(path, bytes);
}

}  // namespace sbox
