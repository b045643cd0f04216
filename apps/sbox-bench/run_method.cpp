// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/run_method.h"

#include <algorithm>
#include <utility>

#include "sbox-bench/progress_bar.h"
#include "sbox-bench/statistics.h"
#include "sbox/core/parallel.h"
#include "sbox/core/stopwatch.h"

namespace sbox::bench {
namespace {

struct MapWork {
  Features features;
  std::vector<double> seconds;  ///< One a repeat.
};

MapWork extract(const Method& method, const Map& map, int repeat) {
  MapWork work;
  for (int i = 0; i < repeat; ++i) {
    const Stopwatch stopwatch;
    work.features = method.features(map);
    work.seconds.push_back(stopwatch.seconds());
  }
  return work;
}

/// The summary of each stage over its repeats.
template <class Summary>
AnswerSeconds summarise(const std::vector<AnswerSeconds>& runs, const MapWork& a, const MapWork& b,
                        Summary summary) {
  const auto over = [&](double AnswerSeconds::*stage) {
    std::vector<double> values;
    values.reserve(runs.size());
    for (const AnswerSeconds& run : runs) {
      values.push_back(run.*stage);
    }
    return summary(values);
  };
  return {summary(a.seconds) + summary(b.seconds), over(&AnswerSeconds::matching),
          over(&AnswerSeconds::verification), over(&AnswerSeconds::refinement),
          over(&AnswerSeconds::pair)};
}

Answer answerPair(const Method& method, const AnnotatedPair& pair, double resolution,
                  const Map& map_a, const Map& map_b, const MapWork& a, const MapWork& b,
                  int repeat) {
  Answer answer;
  std::vector<AnswerSeconds> runs;
  for (int i = 0; i < repeat; ++i) {
    const Stopwatch stopwatch;
    answer.result = method.match(a.features, b.features);
    const double whole = stopwatch.seconds();
    const PairSeconds& stages = answer.result.seconds;
    runs.push_back({0, stages.matching, stages.verification, stages.refinement, whole});
  }
  answer.least = summarise(runs, a, b, minimum);
  answer.middle = summarise(runs, a, b, median);
  if (answer.result.has_pose) {
    const auto judged = [&](const Pose2D& pose_b_in_a) {
      return poseError(pair, resolution,
                       cornerTransform(pose_b_in_a, map_a.corner_in_map, map_b.corner_in_map));
    };
    answer.corner_a_in_corner_b =
        cornerTransform(answer.result.pose_b_in_a, map_a.corner_in_map, map_b.corner_in_map);
    answer.error = judged(answer.result.pose_b_in_a);
    if (!pair.negative) {
      answer.normalised_error = normalisedError(
          answer.result,
          annotatedTruth(pair, resolution, map_a.corner_in_map, map_b.corner_in_map));
    }
    answer.candidate_right = answer.poseRight();
    for (const Candidate& alternative : answer.result.alternatives) {
      const std::optional<PoseError> error = judged(alternative.pose_b_in_a);
      answer.candidate_right = answer.candidate_right || (error && error->right);
    }
  }
  answer.outcome = judge(pair, answer.result.verdict == Verdict::Accepted, answer.error);
  return answer;
}

}  // namespace

std::vector<Answer> runMethod(const Method& method, const LoadedFolder& loaded,
                              const RunOptions& options) {
  const int repeat = std::max(1, options.repeat);
  const std::vector<AnnotatedPair>& pairs = loaded.folder.pairs;
  std::vector<MapWork> work(loaded.maps.size());
  std::vector<Answer> answers(pairs.size());
  ProgressBar progress(method.name + " on " + loaded.folder.name,
                       static_cast<int>(work.size() + answers.size()));
  parallelFor(static_cast<int>(work.size()), options.threads, [&](int i) {
    const auto k = static_cast<size_t>(i);
    work[k] = extract(method, loaded.maps[k], repeat);
    progress.step();
  });
  parallelFor(static_cast<int>(answers.size()), options.threads, [&](int i) {
    const auto k = static_cast<size_t>(i);
    const auto a = static_cast<size_t>(loaded.map_of_pair[k].first);
    const auto b = static_cast<size_t>(loaded.map_of_pair[k].second);
    answers[k] = answerPair(method, pairs[k], loaded.folder.resolution, loaded.maps[a],
                            loaded.maps[b], work[a], work[b], repeat);
    progress.step();
  });
  return answers;
}

}  // namespace sbox::bench
