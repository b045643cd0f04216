// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/map_collection.h"

#include <utility>

#include "sbox/merge.h"

namespace sbox {
namespace {

template <typename Value>
void forgetPairsOf(int map, std::map<PairIndex, Value>& pairs) {
  for (auto it = pairs.begin(); it != pairs.end();) {
    const bool is_of_map = it->first.first == map || it->first.second == map;
    it = is_of_map ? pairs.erase(it) : std::next(it);
  }
}

}  // namespace

MapCollection::MapCollection(MergeOptions options) : options_(std::move(options)) {}

int MapCollection::add(Map map) {
  maps_.push_back(std::move(map));
  return static_cast<int>(maps_.size()) - 1;
}

void MapCollection::replace(int index, Map map) {
  maps_.at(static_cast<size_t>(index)) = std::move(map);
  if (static_cast<size_t>(index) < known_.features.size()) {
    known_.features[static_cast<size_t>(index)].reset();
  }
  forgetPairsOf(index, known_.likeness);
  forgetPairsOf(index, known_.results);
}

MergeResult MapCollection::merge(const ProgressFunction& progress) {
  return mergeMaps(maps_, options_, known_, progress);
}

}  // namespace sbox
