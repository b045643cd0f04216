// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The figures of a run: how many answers are right, how far off, how long they took.
#pragma once

#include <string>
#include <vector>

#include "sbox-bench/run_method.h"
#include "sbox-bench/table.h"

namespace sbox::bench {

/// The answers of one method on one folder.
struct FolderAnswers {
  const LoadedFolder* loaded = nullptr;
  std::vector<Answer> answers;  ///< One a pair of the folder.
};

/// The answers of one method on every folder.
struct MethodRun {
  std::string method;
  std::vector<FolderAnswers> folders;
};

/// A subset of the answers of a run, with their pairs.
struct Group {
  std::string name;
  std::vector<const AnnotatedPair*> pairs;
  std::vector<const Answer*> answers;
};

/// Per folder its groups by name and "all"; "total" at the end if there are several folders.
[[nodiscard]] std::vector<Group> groupAnswers(const MethodRun& run);

struct Score {
  int pairs = 0;
  int right = 0;
  int wrong = 0;
  int refused = 0;
  int right_if_answered = 0;  ///< Pairs with truth whose pose is right, accepted or not.
  int right_candidate = 0;    ///< Pairs with truth whose pose or an alternative is right.
  double excess_cells = 0;    ///< Median RMS over the floor of the right answers; NaN for none.
};

[[nodiscard]] Score score(const Group& group);

/// One row a group: the score and the time of a pair.
[[nodiscard]] Table scoreTable(const MethodRun& run);

/// One row a folder and stage that takes time: least and median over the repeats; each as median
/// and largest over the pairs, in milliseconds.
[[nodiscard]] Table timeTable(const MethodRun& run);

/// One row a group, one column a method: right / wrong / refused, median error, median time.
[[nodiscard]] Table comparisonTable(const std::vector<MethodRun>& runs);

}  // namespace sbox::bench
