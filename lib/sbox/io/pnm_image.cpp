// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/pnm_image.h"

#include <algorithm>

#include "sbox/io/file_error.h"

namespace sbox {
namespace {

bool isSpace(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool isDigit(std::uint8_t c) { return c >= '0' && c <= '9'; }

/// Reads decimal numbers between spaces and comments.
class NumberReader {
 public:
  NumberReader(const Bytes& bytes, std::size_t position) : bytes_(bytes), position_(position) {}

  /// The next number of at most 9 digits; nothing if there is something else or the end.
  std::optional<std::uint32_t> next() {
    while (position_ < bytes_.size() && (isSpace(bytes_[position_]) || bytes_[position_] == '#')) {
      if (bytes_[position_] == '#') {
        while (position_ < bytes_.size() && bytes_[position_] != '\n') {
          ++position_;
        }
      } else {
        ++position_;
      }
    }
    std::uint32_t value = 0;
    int digits = 0;
    for (; position_ < bytes_.size() && isDigit(bytes_[position_]) && digits < 9; ++digits) {
      value = value * 10 + (bytes_[position_++] - '0');
    }
    if (digits == 0 || (position_ < bytes_.size() && isDigit(bytes_[position_]))) {
      return std::nullopt;
    }
    return value;
  }
  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  const Bytes& bytes_;
  std::size_t position_;
};

struct Header {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t largest = 0;     ///< The value that is white.
  std::size_t values_start = 0;  ///< Position of the first value.
  int channels = 1;
  bool binary = true;
};

std::optional<Header> readHeader(const Bytes& bytes) {
  Header header;
  header.channels = bytes[1] == '3' || bytes[1] == '6' ? 3 : 1;
  header.binary = bytes[1] >= '5';
  NumberReader numbers(bytes, 2);
  for (std::uint32_t* value : {&header.width, &header.height, &header.largest}) {
    const std::optional<std::uint32_t> number = numbers.next();
    if (!number) {
      return std::nullopt;
    }
    *value = *number;
  }
  // One single space ends the header: a second one would be a pixel.
  header.values_start = numbers.position() + 1;
  if (header.largest < 1 || header.largest > 65535 || numbers.position() >= bytes.size()) {
    return std::nullopt;
  }
  return header;
}

/// Table from values up to `largest` to 0..255, rounded; larger ones are white.
Bytes scaleTable(std::uint32_t largest, std::size_t size) {
  Bytes table(size, 255);
  for (std::uint32_t value = 0; value <= largest && value < size; ++value) {
    table[value] = static_cast<std::uint8_t>((value * 255 + largest / 2) / largest);
  }
  return table;
}

void decodeBinary(const std::string& path, const Bytes& bytes, const Header& header,
                  Bytes& pixels) {
  const std::size_t value_size = header.largest > 255 ? 2 : 1;
  if ((bytes.size() - header.values_start) / value_size < pixels.size()) {
    throwTruncated(path, "image");
  }
  const std::uint8_t* from = bytes.data() + header.values_start;
  const Bytes table = scaleTable(header.largest, value_size == 1 ? 256 : 65536);
  if (value_size == 1) {
    std::transform(from, from + pixels.size(), pixels.begin(),
                   [&](std::uint8_t value) { return table[value]; });
    return;
  }
  for (std::uint8_t& pixel : pixels) {
    pixel = table[static_cast<std::size_t>(from[0] << 8 | from[1])];
    from += 2;
  }
}

void decodeText(const std::string& path, const Bytes& bytes, const Header& header, Bytes& pixels) {
  const Bytes table = scaleTable(header.largest, header.largest + 1);
  NumberReader numbers(bytes, header.values_start);
  for (std::uint8_t& pixel : pixels) {
    const std::optional<std::uint32_t> value = numbers.next();
    if (!value && numbers.position() >= bytes.size()) {
      throwTruncated(path, "image");
    }
    if (!value || *value > header.largest) {
      throw FileError(path, "is damaged: a pixel has no valid value");
    }
    pixel = table[*value];
  }
}

}  // namespace

bool isPnm(const Bytes& bytes) {
  return bytes.size() > 3 && bytes[0] == 'P' &&
         (bytes[1] == '2' || bytes[1] == '3' || bytes[1] == '5' || bytes[1] == '6') &&
         (isSpace(bytes[2]) || bytes[2] == '#');
}

std::optional<ImageHeader> readPnmHeader(const Bytes& bytes) {
  const std::optional<Header> header = readHeader(bytes);
  if (!header) {
    return std::nullopt;
  }
  return ImageHeader{ImageKind::Pnm, header->width, header->height};
}

Image decodePnm(const std::string& path, const Bytes& bytes) {
  const std::optional<Header> header = readHeader(bytes);
  if (!header) {
    throw FileError(path, "is damaged: its header cannot be read");
  }
  Image image{
      static_cast<int>(header->width), static_cast<int>(header->height), header->channels, {}};
  const std::size_t values = static_cast<std::size_t>(header->width) * header->height *
                             static_cast<std::size_t>(header->channels);
  // A value takes a byte at least, so that a short file takes little memory.
  if (bytes.size() - header->values_start < values) {
    throwTruncated(path, "image");
  }
  image.pixels.resize(values);
  if (header->binary) {
    decodeBinary(path, bytes, *header, image.pixels);
  } else {
    decodeText(path, bytes, *header, image.pixels);
  }
  return image;
}

Bytes encodePgm(const Image& image) {
  const std::string header =
      "P5\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
  Bytes bytes(header.begin(), header.end());
  bytes.insert(bytes.end(), image.pixels.begin(), image.pixels.end());
  return bytes;
}

}  // namespace sbox
