// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/write_answers.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "sbox/io/pair_json.h"

namespace sbox::bench {
namespace {

using Json = nlohmann::ordered_json;

Json secondsJson(const AnswerSeconds& seconds) {
  return {{"features", seconds.features},
          {"matching", seconds.matching},
          {"verification", seconds.verification},
          {"refinement", seconds.refinement},
          {"pair", seconds.pair}};
}

Json answerJson(const AnnotatedPair& pair, const Answer& answer, bool with_seconds) {
  const PairResult& result = answer.result;
  Json entry{{"group", pair.group},
             {"a", pair.a},
             {"b", pair.b},
             {"negative", pair.negative},
             {"outcome", toString(answer.outcome)},
             {"verdict", toString(result.verdict)},
             {"reason", result.reason},
             {"confidence", result.confidence}};
  if (result.has_pose) {
    entry["pose"] = poseJson(result.pose_b_in_a);
    entry["covariance"] = covarianceJson(result.covariance);
    entry["corner_a_in_corner_b"] = poseJson(answer.corner_a_in_corner_b);
    entry["overlap_m2"] = result.overlap_m2;
    entry["matched_boxes"] = result.matched_boxes.size();
    if (result.kalman) {
      entry["kalman"] = poseJson(result.kalman);
    }
    if (result.ceres) {
      entry["ceres"] = poseJson(result.ceres);
    }
    Json alternatives = Json::array();
    for (const Candidate& candidate : result.alternatives) {
      alternatives.push_back(
          {{"pose", poseJson(candidate.pose_b_in_a)}, {"confidence", candidate.confidence}});
    }
    entry["alternatives"] = std::move(alternatives);
  }
  if (answer.error) {
    entry["pose_right"] = answer.error->right;
    entry["candidate_right"] = answer.candidate_right;
    entry["excess_cells"] = answer.error->excess_cells;
    entry["rotation_error_deg"] = answer.error->rotation_deg;
  }
  if (answer.normalised_error) {
    entry["normalised_error"] = answer.normalised_error->of_answer;
    entry["normalised_difference"] = answer.normalised_error->of_difference;
  }
  if (with_seconds) {
    entry["seconds"] = {{"least", secondsJson(answer.least)},
                        {"median", secondsJson(answer.middle)}};
  }
  return entry;
}

}  // namespace

std::string answerLines(const MethodRun& run, bool with_seconds) {
  std::string text;
  for (const FolderAnswers& folder : run.folders) {
    for (size_t i = 0; i < folder.answers.size(); ++i) {
      const AnnotatedPair& pair = folder.loaded->folder.pairs[i];
      const Answer& answer = folder.answers[i];
      Json line{
          {"a", pair.a}, {"b", pair.b}, {"accepted", answer.result.verdict == Verdict::Accepted}};
      if (answer.result.has_pose) {
        line["x"] = answer.corner_a_in_corner_b.x;
        line["y"] = answer.corner_a_in_corner_b.y;
        line["theta_deg"] = answer.corner_a_in_corner_b.phi * 180 / M_PI;
      }
      if (with_seconds) {
        line["seconds"] = answer.least.features + answer.least.pair;
      }
      text += line.dump() + "\n";
    }
  }
  return text;
}

std::string answersJson(const std::vector<MethodRun>& runs, bool with_seconds) {
  Json document{{"version", 1}, {"runs", Json::array()}};
  for (const MethodRun& run : runs) {
    for (const FolderAnswers& folder : run.folders) {
      Json pairs = Json::array();
      for (size_t i = 0; i < folder.answers.size(); ++i) {
        pairs.push_back(
            answerJson(folder.loaded->folder.pairs[i], folder.answers[i], with_seconds));
      }
      document["runs"].push_back({{"method", run.method},
                                  {"folder", folder.loaded->folder.name},
                                  {"pairs", std::move(pairs)}});
    }
  }
  return document.dump(1) + "\n";
}

}  // namespace sbox::bench
