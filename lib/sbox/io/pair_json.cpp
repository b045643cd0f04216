// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/pair_json.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace sbox {
namespace {

using Json = nlohmann::ordered_json;

double finite(const Json& json) {
  if (!json.is_number() || !std::isfinite(json.get<double>())) {
    throw std::invalid_argument("a number is missing");
  }
  return json.get<double>();
}

double probability(const Json& json) {
  const double value = finite(json);
  if (value < 0 || value > 1) {
    throw std::invalid_argument("a confidence is not between 0 and 1");
  }
  return value;
}

const Json& listOf(const Json& json, size_t count) {
  if (!json.is_array() || json.size() != count) {
    throw std::invalid_argument("a list has another length");
  }
  return json;
}

Pose2D poseFrom(const Json& json) {
  constexpr double most_metres = 1e9, most_radians = 10;
  const Pose2D pose(finite(json.at("x")), finite(json.at("y")), finite(json.at("phi")));
  if (std::abs(pose.x) > most_metres || std::abs(pose.y) > most_metres ||
      std::abs(pose.phi) > most_radians) {
    throw std::invalid_argument("a pose is beyond measure");
  }
  return pose;
}

std::optional<Pose2D> optionalPose(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(poseFrom(json));
}

PoseCovariance covarianceFrom(const Json& json) {
  PoseCovariance covariance;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const Json& numbers = listOf(listOf(json, 3)[static_cast<size_t>(row)], 3);
    for (Eigen::Index column = 0; column < 3; ++column) {
      covariance(row, column) = finite(numbers[static_cast<size_t>(column)]);
    }
  }
  return covariance;
}

Verdict verdictFrom(const Json& json) {
  const auto word = json.get<std::string>();
  for (const Verdict verdict : {Verdict::Accepted, Verdict::Ambiguous, Verdict::Rejected}) {
    if (word == toString(verdict)) {
      return verdict;
    }
  }
  throw std::invalid_argument("a verdict is none");
}

}  // namespace

Json poseJson(const std::optional<Pose2D>& pose) {
  if (!pose) {
    return nullptr;
  }
  return {{"x", pose->x}, {"y", pose->y}, {"phi", pose->phi}};
}

Json covarianceJson(const PoseCovariance& covariance) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back({covariance(row, 0), covariance(row, 1), covariance(row, 2)});
  }
  return rows;
}

Json pairJson(const MapPair& pair) {
  const PairResult& result = pair.result;
  Json alternatives = Json::array();
  for (const Candidate& candidate : result.alternatives) {
    alternatives.push_back(
        {{"pose", poseJson(candidate.pose_b_in_a)}, {"confidence", candidate.confidence}});
  }
  return {{"a", pair.a},
          {"b", pair.b},
          {"verdict", toString(result.verdict)},
          {"reason", result.reason},
          {"pose", result.has_pose ? poseJson(result.pose_b_in_a) : Json(nullptr)},
          {"covariance", result.has_pose ? covarianceJson(result.covariance) : Json(nullptr)},
          {"confidence", result.confidence},
          {"matched_boxes", result.matched_boxes.size()},
          {"overlap_m2", result.overlap_m2},
          {"kalman", poseJson(result.kalman)},
          {"ceres", poseJson(result.ceres)},
          {"alternatives", alternatives}};
}

MapPair pairFromJson(const Json& json) {
  MapPair pair;
  pair.a = indexFromJson(json.at("a"));
  pair.b = indexFromJson(json.at("b"));
  PairResult& result = pair.result;
  result.verdict = verdictFrom(json.at("verdict"));
  result.reason = json.at("reason").get<std::string>();
  const std::optional<Pose2D> pose = optionalPose(json.at("pose"));
  result.has_pose = pose.has_value();
  result.pose_b_in_a = pose.value_or(Pose2D());
  if (result.verdict == Verdict::Accepted && !pose) {
    throw std::invalid_argument("an accepted pair has no pose");
  }
  const Json& covariance = json.at("covariance");
  if (covariance.is_null() == result.has_pose) {
    throw std::invalid_argument("a pose and its covariance go together");
  }
  if (result.has_pose) {
    result.covariance = covarianceFrom(covariance);
  }
  result.confidence = probability(json.at("confidence"));
  result.overlap_m2 = finite(json.at("overlap_m2"));
  result.kalman = optionalPose(json.at("kalman"));
  result.ceres = optionalPose(json.at("ceres"));
  for (const Json& candidate : json.at("alternatives")) {
    result.alternatives.push_back(
        {poseFrom(candidate.at("pose")), probability(candidate.at("confidence"))});
  }
  return pair;
}

int indexFromJson(const Json& json) {
  constexpr std::int64_t most = 1 << 30;
  if (!json.is_number_integer() || json.get<std::int64_t>() < 0 ||
      json.get<std::int64_t>() > most) {
    throw std::invalid_argument("an index is not a whole number");
  }
  return json.get<int>();
}

}  // namespace sbox
