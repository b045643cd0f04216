// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sbox/report/html/page_data.h"

namespace sbox::html {

/// Where each map lies, as a table.
[[nodiscard]] std::string placementTable(const PageData& page);

/// A merged map, with the maps that went into it to be laid over it in a colour each.
[[nodiscard]] Section mergedSection(const PageData& page, const MergedGroup& merged,
                                    const std::string& file);

/// A map with its lines, vertical points and boxes.
[[nodiscard]] Section featuresSection(const PageData& page, int map);

}  // namespace sbox::html
