// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/method_list.h"

#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "sbox-bench/methods/correlation.h"
#include "sbox-bench/methods/hough_matching.h"
#include "sbox-bench/methods/keypoints.h"
#include "sbox-bench/methods/map_merge.h"
#include "sbox-bench/methods/mrpt_aligner.h"
#include "sbox/config/describe_options.h"
#include "sbox/match_pair.h"
#include "sbox/paper/paper_method.h"

namespace sbox::bench {
namespace {

Method makeKeypoints(KeypointKind kind) {
  KeypointOptions options;
  options.kind = kind;
  return keypointMethod(options);
}

Method makeBoxes(const std::string& name, const PairOptions& options) {
  return makeMethod(
      name, [options](const Map& map) { return extractFeatures(map, options.features); },
      [options](const MapFeatures& a, const MapFeatures& b) { return matchPair(a, b, options); });
}

Method makePaper(const std::string& name, const PaperOptions& options) {
  return makeMethod(
      name, [options](const Map& map) { return extractPaperFeatures(map, options); },
      [options](const PaperFeatures& a, const PaperFeatures& b) {
        return matchPaper(a, b, options);
      });
}

std::vector<Method> allMethods() {
  std::vector<Method> methods{makeBoxes("boxes", {}),
                              makePaper("paper", {}),
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

Method methodWith(const std::string& settings) {
  MergeOptions options;
  const OptionTable table = describePairOptions(options);
  std::istringstream list(settings);
  for (std::string setting; std::getline(list, setting, ',');) {
    const size_t equals = setting.find('=');
    const size_t dot = setting.rfind('.', equals);
    if (equals == std::string::npos || dot == std::string::npos) {
      throw std::invalid_argument("\"" + setting + "\" is not section.key=value");
    }
    table.set(setting.substr(0, dot), setting.substr(dot + 1, equals - dot - 1),
              setting.substr(equals + 1));
  }
  return options.method == sbox::Method::Paper ? makePaper(settings, options.paper)
                                               : makeBoxes(settings, options.pair);
}

}  // namespace sbox::bench
