// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace sbox {

/// What all maps together say about one merged cell: the summed log-odds for free, the summed
/// log-odds for occupied and the number of maps that know it, packed in one word so that adding a
/// map is one addition and the order of maps changes nothing. Room for 32767 maps.
class CellTally {
 public:
  /// Adds a map's log-odds of being free, -128 to 127; 0 adds nothing.
  void add(int log_odds);

  /// Summed log-odds of the maps that say free, in MRPT's units.
  [[nodiscard]] int free() const { return static_cast<int>(word_ & kSumMask); }
  /// Summed log-odds of the maps that say occupied, positive, in MRPT's units.
  [[nodiscard]] int occupied() const { return static_cast<int>((word_ >> kOccupiedAt) & kSumMask); }
  /// Number of the maps that know the cell.
  [[nodiscard]] int maps() const { return static_cast<int>(word_ >> kMapsAt); }
  /// Whether one map says free and another occupied.
  [[nodiscard]] bool contested() const { return free() != 0 && occupied() != 0; }

 private:
  static constexpr int kOccupiedAt = 24, kMapsAt = 48;
  static constexpr std::uint64_t kSumMask = (std::uint64_t{1} << kOccupiedAt) - 1;

  static constexpr std::array<std::uint64_t, 256> makeWords() {
    std::array<std::uint64_t, 256> words{};
    for (int value = -128; value <= 127; ++value) {
      const std::uint64_t sum = value < 0 ? static_cast<std::uint64_t>(-value) << kOccupiedAt
                                          : static_cast<std::uint64_t>(value);
      words[static_cast<std::uint8_t>(value)] =
          value == 0 ? 0 : sum | (std::uint64_t{1} << kMapsAt);
    }
    return words;
  }
  static const std::array<std::uint64_t, 256> kWords;

  std::uint64_t word_ = 0;
};

inline constexpr std::array<std::uint64_t, 256> CellTally::kWords = CellTally::makeWords();

inline void CellTally::add(int log_odds) { word_ += kWords[static_cast<std::uint8_t>(log_odds)]; }

}  // namespace sbox
