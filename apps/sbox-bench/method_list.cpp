// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/method_list.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "sbox-bench/methods/correlation.h"
#include "sbox-bench/methods/hough_matching.h"
#include "sbox-bench/methods/keypoints.h"
#include "sbox-bench/methods/map_merge.h"
#include "sbox-bench/methods/mrpt_aligner.h"
#include "sbox/match_pair.h"
#include "sbox/paper/paper_method.h"

namespace sbox::bench {
namespace {

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

std::vector<Method> allMethods() {
  std::vector<Method> methods{makeBoxes(),
                              makePaper(),
                              makeKeypoints(KeypointKind::Orb),
                              makeKeypoints(KeypointKind::Sift),
                              houghMethod(),
                              correlationMethod(),
                              mapMergeMethod()};
  if (std::optional<Method> mrpt = mrptMethod()) {
    methods.push_back(*std::move(mrpt));
  }
  return methods;
}

}  // namespace

std::vector<std::string> methodNames() {
  std::vector<std::string> names;
  for (const Method& method : allMethods()) {
    names.push_back(method.name);
  }
  return names;
}

Method methodByName(const std::string& name) {
  for (Method& method : allMethods()) {
    if (name == method.name) {
      return std::move(method);
    }
  }
  throw std::invalid_argument("no method is called " + name);
}

}  // namespace sbox::bench
