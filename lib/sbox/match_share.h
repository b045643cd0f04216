// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pairs of many maps spread over several machines: each matches a share of them, and one joins
// what they found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "sbox/core/map.h"
#include "sbox/core/progress.h"
#include "sbox/match_all.h"
#include "sbox/merge_options.h"

namespace sbox {

/// The results of one share.
struct MatchedShare {
  PairShare share;                         ///< Which.
  std::uint64_t options_digest = 0;        ///< Of what a configuration can set of matching.
  std::vector<std::uint64_t> map_digests;  ///< Of all maps, in their order.
  std::vector<MapPair> pairs;              ///< Ordered by a, then b.
};

/// Matches the pairs of one share of the maps.
[[nodiscard]] MatchedShare matchShare(const std::vector<Map>& maps, const MergeOptions& options,
                                      const PairShare& share, const ProgressFunction& tell = {});

/// Shares that cannot be joined.
class ShareError : public std::invalid_argument {
 public:
  /// The share by its index among those given, and what is wrong with it.
  ShareError(size_t index, const std::string& reason)
      : std::invalid_argument(reason), index_(index) {}
  /// Which of the shares given.
  [[nodiscard]] size_t index() const { return index_; }

 private:
  size_t index_;
};

/// What all shares found, for mergeMaps(), which then gives what it would have given alone. Throws
/// ShareError if one was made of other maps or by other options, or if the shares are not all that
/// there are of one number, each once.
[[nodiscard]] MatchStore joinShares(const std::vector<Map>& maps, const MergeOptions& options,
                                    const std::vector<MatchedShare>& shares,
                                    const ProgressFunction& tell = {});

}  // namespace sbox
