// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sbox/core/map.h"

namespace sbox::test {

/// A made-up office floor of 24 x 16 m with rooms of many sizes, in cells of 0.05 m. Different
/// numbers give different floors.
[[nodiscard]] Map office(const std::string& name, unsigned number);

/// A round hall of 5 m radius: nothing in it is straight, so it fits no office.
[[nodiscard]] Map roundHall(const std::string& name);

/// The cells of columns [first, last), as a map whose frame lies anywhere: `corner_in_map` is where
/// the lower-left corner of the cut comes to lie in it.
[[nodiscard]] Map cutColumns(const Map& map, const std::string& name, int first, int last,
                             const Pose2D& corner_in_map);

}  // namespace sbox::test
