// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox/core/state_grid.h"
#include "sbox/merge_result.h"
#include "sbox/report/html/map_masks.h"

namespace sbox::html {

/// What all sections of a page are made from; one of each a map.
struct PageData {
  const MergeResult* result = nullptr;  ///< Not owned.
  std::vector<StateGrid> grids;         ///< Of each map.
  std::vector<MapMasks> masks;          ///< Of each map.
  std::vector<std::string> names;       ///< Short and distinct.

  /// Cells of a map.
  [[nodiscard]] const StateGrid& grid(int map) const { return grids[static_cast<size_t>(map)]; }
  /// Masks of a map.
  [[nodiscard]] const MapMasks& mask(int map) const { return masks[static_cast<size_t>(map)]; }
  /// Short name of a map.
  [[nodiscard]] const std::string& name(int map) const { return names[static_cast<size_t>(map)]; }
};

/// A part of the page: its text, and the CSS rules that it needs.
struct Section {
  std::string style;  ///< CSS rules.
  std::string body;   ///< HTML.
};

}  // namespace sbox::html
