// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>

#include <stdexcept>
#include <string>

namespace sbox::test {

/// The bytes that MRPT writes of the object, or of a missing one.
inline std::string serialized(const mrpt::serialization::CSerializable* object) {
  mrpt::io::CMemoryStream memory;
  mrpt::serialization::archiveFrom(memory).WriteObject(object);
  return {static_cast<const char*>(memory.getRawBufferData()), memory.getTotalBytesCount()};
}

/// The bytes of what holds the object, with a missing one in its place.
inline std::string withoutObject(std::string bytes,
                                 const mrpt::serialization::CSerializable& object) {
  const std::string part = serialized(&object);
  const size_t place = bytes.find(part);
  if (place == std::string::npos) {
    throw std::logic_error("the object is not in there");
  }
  return bytes.replace(place, part.size(), serialized(nullptr));
}

}  // namespace sbox::test
