// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "sbox/io/file_error.h"

namespace sbox {

std::uint64_t checkReadable(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw FileError(path, "no such file");
  }
  if (error) {
    throw FileError(path, "cannot be read: " + error.message());
  }
  if (std::filesystem::is_directory(status)) {
    throw FileError(path, "is a folder, not a file");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw FileError(path, "is not a regular file");
  }
  const std::uint64_t size = std::filesystem::file_size(path, error);
  errno = 0;
  if (error || !std::ifstream(path, std::ios::binary)) {
    throw FileError(path, std::string("cannot be read: ") + std::strerror(errno));
  }
  if (size == 0) {
    throw FileError(path, "is empty");
  }
  return size;
}

Bytes readFile(const std::string& path, std::uint64_t max_bytes) {
  const std::uint64_t size = checkReadable(path);
  if (size > max_bytes) {
    throw FileError(path, "has " + std::to_string(size) + " bytes, more than the " +
                              std::to_string(max_bytes) + " a file of its kind may have");
  }
  Bytes bytes(size);
  std::ifstream in(path, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
    throw FileError(path, "cannot be read to its end");
  }
  return bytes;
}

void writeFile(const std::string& path, const Bytes& bytes) {
  errno = 0;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    throw FileError(path, std::string("cannot be written: ") +
                              (errno != 0 ? std::strerror(errno) : "unknown error"));
  }
}

}  // namespace sbox
