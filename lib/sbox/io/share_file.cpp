// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/io/share_file.h"

#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "sbox/core/digest.h"
#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"
#include "sbox/io/pair_json.h"

namespace sbox {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kKind = "sbox-merge pairs";
constexpr int kVersion = 2;
constexpr std::uint64_t kMostShareBytes = std::uint64_t{1} << 30;

/// A pair as in the report, and which boxes match.
Json pairWithBoxes(const MapPair& pair) {
  Json boxes = Json::array();
  for (const auto& [box_a, box_b] : pair.result.matched_boxes) {
    boxes.push_back({box_a, box_b});
  }
  Json json = pairJson(pair);
  json["boxes"] = boxes;
  return json;
}

// What follows throws std::exception of one kind or another if the JSON is not as above.

MapPair pairWithBoxesFrom(const Json& json) {
  MapPair pair = pairFromJson(json);
  for (const Json& match : json.at("boxes")) {
    if (!match.is_array() || match.size() != 2) {
      throw std::invalid_argument("a match is not of two boxes");
    }
    pair.result.matched_boxes.emplace_back(indexFromJson(match[0]), indexFromJson(match[1]));
  }
  if (json.at("matched_boxes").get<size_t>() != pair.result.matched_boxes.size()) {
    throw std::invalid_argument("some of the matched boxes are missing");
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
  share.share.number = indexFromJson(json.at("share"));
  share.share.count = indexFromJson(json.at("of"));
  if (share.share.number < 1 || share.share.number > share.share.count) {
    throw std::invalid_argument("there is no such share");
  }
  share.options_digest = digestFrom(json.at("options"));
  for (const Json& map : json.at("maps")) {
    share.map_digests.push_back(digestFrom(map.at("digest")));
  }
  for (const Json& pair : json.at("pairs")) {
    share.pairs.push_back(pairWithBoxesFrom(pair));
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
    pairs.push_back(pairWithBoxes(pair));
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
  const Bytes bytes = readFile(path, kMostShareBytes);
  try {
    const Json document = Json::parse(std::string(bytes.begin(), bytes.end()));
    if (document.at("kind").get<std::string>() != kKind ||
        document.at("version").get<int>() != kVersion) {
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
