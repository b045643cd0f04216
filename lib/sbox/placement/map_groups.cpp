// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/placement/map_groups.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "sbox/placement/join_evidence.h"

namespace sbox {
namespace {

bool suffices(const JoinEvidence& join, bool single_map, const GroupOptions& options) {
  if (join.probability < options.min_confidence) {
    return false;
  }
  if (join.strongest >= options.overwhelming && join.probability >= options.agreed) {
    return true;
  }
  if (join.witnesses >= options.witnesses && join.probability >= options.agreed) {
    return true;
  }
  // As with two maps: the verdict stands unless other pairs speak against it.
  return single_map && join.accepted &&
         join.probability >= std::min(options.alone, 0.99 * join.strongest);
}

class Grower {
 public:
  Grower(const std::vector<Footprint>& maps, const std::vector<PairEvidence>& pairs,
         const GroupOptions& options)
      : maps_(maps),
        pairs_(pairs),
        options_(options),
        pairs_of_(maps.size()),
        partners_(maps.size()),
        group_of_(maps.size()) {
    for (size_t i = 0; i < maps.size(); ++i) {
      groups_.push_back({{static_cast<int>(i)}, {Pose2D()}, {}, {}});
      group_of_[i] = i;
    }
    for (size_t i = 0; i < pairs.size(); ++i) {
      if (!pairs[i].candidates.empty()) {
        const auto a = static_cast<size_t>(pairs[i].a), b = static_cast<size_t>(pairs[i].b);
        pairs_of_[a].push_back(i);
        partners_[a].push_back(b);
        partners_[b].push_back(a);
      }
    }
    for (size_t first = 0; first < maps.size(); ++first) {
      for (const size_t second : groupsBeside(first)) {
        if (first < second) {
          weigh(first, second);
        }
      }
    }
  }

  std::vector<SettledGroup> grow() {
    do {
      while (joinBest()) {
      }
    } while (moveMisplaced());
    std::vector<SettledGroup> grown;
    for (SettledGroup& group : groups_) {
      if (!group.members.empty()) {
        grown.push_back(std::move(group));
      }
    }
    return grown;
  }

 private:
  /// Groups go by the number of their first member.
  using Groups = std::pair<size_t, size_t>;

  std::vector<CrossPair> crossPairs(const SettledGroup& first, const SettledGroup& second) const {
    std::vector<int> place_in_first(maps_.size(), -1), place_in_second(maps_.size(), -1);
    for (size_t i = 0; i < first.members.size(); ++i) {
      place_in_first[static_cast<size_t>(first.members[i])] = static_cast<int>(i);
    }
    for (size_t i = 0; i < second.members.size(); ++i) {
      place_in_second[static_cast<size_t>(second.members[i])] = static_cast<int>(i);
    }
    std::vector<CrossPair> crossing;
    const auto add = [&](const SettledGroup& of_a, const std::vector<int>& place_of_b,
                         const SettledGroup& of_b, bool turned) {
      for (size_t i = 0; i < of_a.members.size(); ++i) {
        for (const size_t index : pairs_of_[static_cast<size_t>(of_a.members[i])]) {
          const int place = place_of_b[static_cast<size_t>(pairs_[index].b)];
          if (place >= 0) {
            crossing.push_back(
                {&pairs_[index], turned, of_a.poses[i], of_b.poses[static_cast<size_t>(place)]});
          }
        }
      }
    };
    add(first, place_in_second, second, false);
    add(second, place_in_first, first, true);
    return crossing;
  }

  /// Groups that some pair proposes to lay to this one.
  std::set<size_t> groupsBeside(size_t number) const {
    std::set<size_t> beside;
    for (const int member : groups_[number].members) {
      for (const size_t partner : partners_[static_cast<size_t>(member)]) {
        beside.insert(group_of_[partner]);
      }
    }
    beside.erase(number);
    return beside;
  }

  void weighAllWith(size_t number) {
    for (const size_t other : groupsBeside(number)) {
      weigh(std::min(other, number), std::max(other, number));
    }
  }

  void weigh(size_t first, size_t second) {
    const std::optional<JoinEvidence> join =
        weighJoin(crossPairs(groups_[first], groups_[second]), maps_, options_.same_pose);
    const bool single_map =
        groups_[first].members.size() == 1 || groups_[second].members.size() == 1;
    if (join && suffices(*join, single_map, options_)) {
      joins_[{first, second}] = *join;
    } else {
      joins_.erase({first, second});
    }
  }

  /// False when nothing is left to join.
  bool joinBest() {
    const auto best =
        std::max_element(joins_.begin(), joins_.end(), [](const auto& left, const auto& right) {
          return left.second.log_odds < right.second.log_odds;
        });
    if (best == joins_.end()) {
      return false;
    }
    const auto [groups, join] = *best;
    std::optional<SettledGroup> joined = settle(groups, join);
    if (!joined) {
      joins_.erase(groups);
      return true;
    }
    groups_[groups.first] = std::move(*joined);
    groups_[groups.second] = {};
    for (auto it = joins_.begin(); it != joins_.end();) {
      const bool gone = it->first.first == groups.second || it->first.second == groups.second;
      it = gone ? joins_.erase(it) : std::next(it);
    }
    for (const int member : groups_[groups.first].members) {
      group_of_[static_cast<size_t>(member)] = groups.first;
    }
    weighAllWith(groups.first);
    return true;
  }

  /// Puts maps that came in by a pair which the rest of the group now speaks against to where the
  /// rest wants them. True if there were any.
  bool moveMisplaced() {
    if (rounds_++ >= kMostRounds) {
      return false;
    }
    bool moved = false;
    for (size_t number = 0; number < groups_.size(); ++number) {
      for (size_t i = 0; groups_[number].members.size() > 2 && i < groups_[number].members.size();
           ++i) {
        moved = moveMember(number, i) || moved;
      }
    }
    return moved;
  }

  bool moveMember(size_t number, size_t member) {
    SettledGroup& group = groups_[number];
    SettledGroup rest = group, single;
    const auto at = static_cast<std::ptrdiff_t>(member);
    rest.members.erase(rest.members.begin() + at);
    rest.poses.erase(rest.poses.begin() + at);
    const int map = group.members[member];
    single.members = {map};
    single.poses = {Pose2D()};
    const std::optional<JoinEvidence> join =
        weighJoin(crossPairs(rest, single), maps_, options_.same_pose);
    if (!join || join->witnesses < options_.witnesses || !suffices(*join, true, options_)) {
      return false;
    }
    const Footprint& shape = maps_[static_cast<size_t>(map)];
    const PoseGap gap = gapBetween(shape, shape, join->second_in_first, group.poses[member]);
    if (isSamePose(gap, shape, shape, options_.same_pose)) {
      return false;
    }
    std::vector<Pose2D> poses = group.poses;
    poses[member] = join->second_in_first;
    SettledGroup better =
        settleGroup(group.members, poses, pairs_, maps_, options_.same_pose, options_.graph);
    if (!better.isConnected()) {
      return false;
    }
    group = std::move(better);
    weighAllWith(number);
    return true;
  }

  /// Both groups as one; nothing if its edges, solved together, fall apart again.
  std::optional<SettledGroup> settle(const Groups& groups, const JoinEvidence& join) const {
    std::vector<std::pair<int, Pose2D>> members;
    const SettledGroup& first = groups_[groups.first];
    const SettledGroup& second = groups_[groups.second];
    for (size_t i = 0; i < first.members.size(); ++i) {
      members.emplace_back(first.members[i], first.poses[i]);
    }
    for (size_t i = 0; i < second.members.size(); ++i) {
      members.emplace_back(second.members[i], join.second_in_first + second.poses[i]);
    }
    std::sort(members.begin(), members.end(),
              [](const auto& left, const auto& right) { return left.first < right.first; });
    std::vector<int> numbers;
    std::vector<Pose2D> poses;
    for (const auto& [number, pose] : members) {
      numbers.push_back(number);
      poses.push_back(pose);
    }
    SettledGroup joined =
        settleGroup(numbers, poses, pairs_, maps_, options_.same_pose, options_.graph);
    if (!joined.isConnected()) {
      return std::nullopt;
    }
    return joined;
  }

  static constexpr int kMostRounds = 5;

  int rounds_ = 0;  ///< Of moveMisplaced.
  const std::vector<Footprint>& maps_;
  const std::vector<PairEvidence>& pairs_;
  const GroupOptions& options_;
  std::vector<std::vector<size_t>> pairs_of_;  ///< Of each map a, with a candidate.
  std::vector<std::vector<size_t>>
      partners_;                          ///< Of each map: those of its pairs with a candidate.
  std::vector<size_t> group_of_;          ///< The group of each map.
  std::vector<SettledGroup> groups_;      ///< Empty where joined to an earlier one.
  std::map<Groups, JoinEvidence> joins_;  ///< Those whose evidence suffices.
};

}  // namespace

std::vector<SettledGroup> groupMaps(const std::vector<Footprint>& maps,
                                    const std::vector<PairEvidence>& pairs,
                                    const GroupOptions& options) {
  return Grower(maps, pairs, options).grow();
}

}  // namespace sbox
