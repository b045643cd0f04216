// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/report/html/page_data.h"

namespace sbox::html {

/// One pair of maps: the verdict in words, the pose with its covariance, the overlay, and where it
/// is not certain which placement is right an overlay of each.
[[nodiscard]] Section pairSection(const PageData& page, const MapPair& pair);

/// All pairs as a table, or the first of them where there are very many.
[[nodiscard]] std::string pairTable(const PageData& page);

}  // namespace sbox::html
