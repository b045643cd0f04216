// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/method_list.h"

#include <stdexcept>

#include "sbox-bench/methods/correlation.h"
#include "sbox-bench/methods/hough_matching.h"
#include "sbox-bench/methods/keypoints.h"
#include "sbox/match_pair.h"
#include "sbox/paper/paper_method.h"

namespace sbox::bench {
namespace {

struct Entry {
  const char* name;
  Method (*make)();
};

Method makeKeypoints(KeypointKind kind) {
  KeypointOptions options;
  options.kind = kind;
  return keypointMethod(options);
}

Method makeBoxes() {
  return makeMethod(
      "boxes", [](const Map& map) { return extractFeatures(map); },
      [](const MapFeatures& a, const MapFeatures& b) { return matchPair(a, b); });
}

Method makePaper() {
  return makeMethod(
      "paper", [](const Map& map) { return extractPaperFeatures(map); },
      [](const PaperFeatures& a, const PaperFeatures& b) { return matchPaper(a, b); });
}

constexpr Entry kMethods[] = {
    {"boxes", [] { return makeBoxes(); }},
    {"paper", [] { return makePaper(); }},
    {"orb", [] { return makeKeypoints(KeypointKind::Orb); }},
    {"sift", [] { return makeKeypoints(KeypointKind::Sift); }},
    {"hough", [] { return houghMethod(); }},
    {"correlation", [] { return correlationMethod(); }},
};

}  // namespace

std::vector<std::string> methodNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kMethods) {
    names.emplace_back(entry.name);
  }
  return names;
}

Method methodByName(const std::string& name) {
  for (const Entry& entry : kMethods) {
    if (name == entry.name) {
      return entry.make();
    }
  }
  throw std::invalid_argument("no method is called " + name);
}

}  // namespace sbox::bench
