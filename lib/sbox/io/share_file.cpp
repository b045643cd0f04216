// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/share_file.h"

#include <cmath>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "sbox/core/digest.h"
#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"

namespace sbox {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kKind = "sbox-merge pairs";
constexpr int kVersion = 1;
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;

Json poseJson(const Pose2D& pose) { return {pose.x, pose.y, pose.phi}; }

Json poseJson(const std::optional<Pose2D>& pose) { return pose ? poseJson(*pose) : Json(nullptr); }

Json pairJson(const MapPair& pair) {
  const PairResult& result = pair.result;
  Json covariance = Json::array(), boxes = Json::array(), alternatives = Json::array();
  for (Eigen::Index i = 0; i < result.covariance.size(); ++i) {
    covariance.push_back(result.covariance(i / 3, i % 3));
  }
  for (const auto& [box_a, box_b] : result.matched_boxes) {
    boxes.push_back({box_a, box_b});
  }
  for (const Candidate& candidate : result.alternatives) {
    alternatives.push_back(
        {{"pose", poseJson(candidate.pose_b_in_a)}, {"confidence", candidate.confidence}});
  }
  return {{"a", pair.a},
          {"b", pair.b},
          {"verdict", toString(result.verdict)},
          {"reason", result.reason},
          {"pose", result.has_pose ? poseJson(result.pose_b_in_a) : Json(nullptr)},
          {"covariance", covariance},
          {"confidence", result.confidence},
          {"overlap_m2", result.overlap_m2},
          {"kalman", poseJson(result.kalman)},
          {"ceres", poseJson(result.ceres)},
          {"boxes", boxes},
          {"alternatives", alternatives}};
}

// What follows throws std::exception of one kind or another if the JSON is not as above.

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

int whole(const Json& json) {
  constexpr std::int64_t most = 1 << 30;
  if (!json.is_number_integer() || json.get<std::int64_t>() < 0 ||
      json.get<std::int64_t>() > most) {
    throw std::invalid_argument("an index is not a whole number");
  }
  return json.get<int>();
}

const Json& listOf(const Json& json, size_t count) {
  if (!json.is_array() || json.size() != count) {
    throw std::invalid_argument("a list has another length");
  }
  return json;
}

Pose2D poseFrom(const Json& json) {
  constexpr double most_metres = 1e9, most_radians = 10;
  listOf(json, 3);
  const Pose2D pose(finite(json[0]), finite(json[1]), finite(json[2]));
  if (std::abs(pose.x) > most_metres || std::abs(pose.y) > most_metres ||
      std::abs(pose.phi) > most_radians) {
    throw std::invalid_argument("a pose is beyond measure");
  }
  return pose;
}

std::optional<Pose2D> optionalPose(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(poseFrom(json));
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

MapPair pairFrom(const Json& json) {
  MapPair pair;
  pair.a = whole(json.at("a"));
  pair.b = whole(json.at("b"));
  PairResult& result = pair.result;
  result.verdict = verdictFrom(json.at("verdict"));
  result.reason = json.at("reason").get<std::string>();
  const std::optional<Pose2D> pose = optionalPose(json.at("pose"));
  result.has_pose = pose.has_value();
  result.pose_b_in_a = pose.value_or(Pose2D());
  if (result.verdict == Verdict::Accepted && !pose) {
    throw std::invalid_argument("an accepted pair has no pose");
  }
  const Json& covariance = listOf(json.at("covariance"), 9);
  for (Eigen::Index i = 0; i < result.covariance.size(); ++i) {
    result.covariance(i / 3, i % 3) = finite(covariance[static_cast<size_t>(i)]);
  }
  result.confidence = probability(json.at("confidence"));
  result.overlap_m2 = finite(json.at("overlap_m2"));
  result.kalman = optionalPose(json.at("kalman"));
  result.ceres = optionalPose(json.at("ceres"));
  for (const Json& match : json.at("boxes")) {
    listOf(match, 2);
    result.matched_boxes.emplace_back(whole(match[0]), whole(match[1]));
  }
  for (const Json& candidate : json.at("alternatives")) {
    result.alternatives.push_back(
        {poseFrom(candidate.at("pose")), probability(candidate.at("confidence"))});
  }
  return pair;
}

std::uint64_t digestFrom(const Json& json) {
  const auto text = json.get<std::string>();
  const std::uint64_t digest = std::stoull(text, nullptr, 16);
  if (digestText(digest) != text) {
    throw std::invalid_argument("a digest is not one");
  }
  return digest;
}

MatchedShare shareFrom(const Json& json) {
  MatchedShare share;
  share.share.number = whole(json.at("share"));
  share.share.count = whole(json.at("of"));
  if (share.share.number < 1 || share.share.number > share.share.count) {
    throw std::invalid_argument("there is no such share");
  }
  share.options_digest = digestFrom(json.at("options"));
  for (const Json& map : json.at("maps")) {
    share.map_digests.push_back(digestFrom(map.at("digest")));
  }
  for (const Json& pair : json.at("pairs")) {
    share.pairs.push_back(pairFrom(pair));
  }
  return share;
}

}  // namespace

std::string shareJson(const MatchedShare& share, const std::vector<std::string>& map_names) {
  Json maps = Json::array(), pairs = Json::array();
  for (size_t i = 0; i < share.map_digests.size(); ++i) {
    maps.push_back({{"file", map_names.at(i)}, {"digest", digestText(share.map_digests[i])}});
  }
  for (const MapPair& pair : share.pairs) {
    pairs.push_back(pairJson(pair));
  }
  const Json document{{"kind", kKind},
                      {"version", kVersion},
                      {"share", share.share.number},
                      {"of", share.share.count},
                      {"options", digestText(share.options_digest)},
                      {"maps", maps},
                      {"pairs", pairs}};
  return document.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

MatchedShare loadShare(const std::string& path) {
  const Bytes bytes = readFile(path, kMostBytes);
  try {
    const Json document = Json::parse(bytes.begin(), bytes.end());
    if (document.at("kind") != kKind || document.at("version") != kVersion) {
      throw std::invalid_argument("it is of another kind");
    }
    return shareFrom(document);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    throw FileError(path, "is not what --pairs writes, or is damaged: make it anew");
  }
}

}  // namespace sbox
