// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/score_table.h"

#include <map>

#include "sbox-bench/statistics.h"

namespace sbox::bench {
namespace {

struct Stage {
  const char* name;
  double AnswerSeconds::*seconds;
};
constexpr Stage kStages[] = {{"features (both maps)", &AnswerSeconds::features},
                             {"matching", &AnswerSeconds::matching},
                             {"verification", &AnswerSeconds::verification},
                             {"refinement", &AnswerSeconds::refinement},
                             {"pair, whole", &AnswerSeconds::pair}};

std::vector<double> milliseconds(const Group& group, AnswerSeconds Answer::*summary,
                                 double AnswerSeconds::*stage) {
  std::vector<double> values;
  for (const Answer* answer : group.answers) {
    values.push_back(answer->*summary.*stage * 1e3);
  }
  return values;
}

void add(Group& group, const AnnotatedPair& pair, const Answer& answer) {
  group.pairs.push_back(&pair);
  group.answers.push_back(&answer);
}

std::string outcomeText(const Score& s) {
  return std::to_string(s.right) + " / " + std::to_string(s.wrong) + " / " +
         std::to_string(s.refused);
}

bool isSummary(const Group& group) {
  return group.name == "total" ||
         (group.name.size() > 4 && group.name.compare(group.name.size() - 4, 4, " all") == 0);
}

}  // namespace

std::vector<Group> groupAnswers(const MethodRun& run) {
  std::vector<Group> groups;
  Group total{"total", {}, {}};
  for (const FolderAnswers& folder : run.folders) {
    std::map<std::string, Group> by_name;
    Group all{folder.loaded->folder.name + " all", {}, {}};
    for (size_t i = 0; i < folder.answers.size(); ++i) {
      const AnnotatedPair& pair = folder.loaded->folder.pairs[i];
      Group& group = by_name[pair.group];
      group.name = folder.loaded->folder.name + " " + pair.group;
      add(group, pair, folder.answers[i]);
      add(all, pair, folder.answers[i]);
      add(total, pair, folder.answers[i]);
    }
    if (by_name.size() > 1) {
      for (auto& [name, group] : by_name) {
        groups.push_back(std::move(group));
      }
    }
    groups.push_back(std::move(all));
  }
  if (run.folders.size() > 1) {
    groups.push_back(std::move(total));
  }
  return groups;
}

Score score(const Group& group) {
  Score result;
  std::vector<double> excess;
  for (const Answer* answer : group.answers) {
    ++result.pairs;
    result.right += answer->outcome == Outcome::Right ? 1 : 0;
    result.wrong += answer->outcome == Outcome::Wrong ? 1 : 0;
    result.refused += answer->outcome == Outcome::Refused ? 1 : 0;
    result.right_if_answered += answer->poseRight() ? 1 : 0;
    result.right_candidate += answer->candidate_right ? 1 : 0;
    if (answer->outcome == Outcome::Right && answer->error) {
      excess.push_back(answer->error->excess_cells);
    }
  }
  result.excess_cells = median(excess);
  return result;
}

Table scoreTable(const MethodRun& run) {
  Table table{{run.method, "pairs", "right", "wrong", "refused", "right if answered",
               "right among candidates", "excess, cells", "pair ms, median", "max"},
              {}};
  for (const Group& group : groupAnswers(run)) {
    const Score s = score(group);
    const std::vector<double> times = milliseconds(group, &Answer::least, &AnswerSeconds::pair);
    table.rows.push_back({group.name, std::to_string(s.pairs), std::to_string(s.right),
                          std::to_string(s.wrong), std::to_string(s.refused),
                          std::to_string(s.right_if_answered), std::to_string(s.right_candidate),
                          formatNumber(s.excess_cells, 2), formatNumber(median(times), 1),
                          formatNumber(maximum(times), 1)});
  }
  return table;
}

Table timeTable(const MethodRun& run) {
  Table table{{run.method + ", ms", "least: median", "max", "median: median", "max"}, {}};
  for (const Group& group : groupAnswers(run)) {
    if (!isSummary(group)) {
      continue;
    }
    for (const Stage& stage : kStages) {
      const std::vector<double> least = milliseconds(group, &Answer::least, stage.seconds);
      if (!(maximum(least) > 0)) {
        continue;
      }
      const std::vector<double> middle = milliseconds(group, &Answer::middle, stage.seconds);
      table.rows.push_back({group.name + ": " + stage.name, formatNumber(median(least), 2),
                            formatNumber(maximum(least), 2), formatNumber(median(middle), 2),
                            formatNumber(maximum(middle), 2)});
    }
  }
  return table;
}

Table comparisonTable(const std::vector<MethodRun>& runs) {
  Table table{{"right / wrong / refused; excess cells; pair ms", "pairs"}, {}};
  for (const MethodRun& run : runs) {
    table.header.push_back(run.method);
  }
  std::vector<std::vector<Group>> groups;
  for (const MethodRun& run : runs) {
    groups.push_back(groupAnswers(run));
  }
  for (size_t row = 0; !groups.empty() && row < groups[0].size(); ++row) {
    std::vector<std::string> cells{groups[0][row].name,
                                   std::to_string(groups[0][row].pairs.size())};
    for (const std::vector<Group>& column : groups) {
      const Score s = score(column[row]);
      const std::vector<double> times =
          milliseconds(column[row], &Answer::least, &AnswerSeconds::pair);
      cells.push_back(outcomeText(s) + "; " + formatNumber(s.excess_cells, 1) + "; " +
                      formatNumber(median(times), 1));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace sbox::bench
