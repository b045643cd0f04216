// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-paper/experiments/offices.h"

#include <algorithm>
#include <array>

#include "sbox-bench/method_list.h"
#include "sbox-paper/answers.h"
#include "sbox-paper/coincidence.h"
#include "sbox/core/parallel.h"

namespace sbox::paper {

using bench::Features;
using bench::Method;

int OfficesResult::accepted(size_t method, bool right) const {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), [&](const OfficeRun& run) {
    const OfficeAnswer& answer = run.answers[method];
    return answer.accepted() && answer.error.right == right;
  }));
}

int OfficesResult::differentAccepted(size_t method) const {
  return static_cast<int>(
      std::count_if(different.begin(), different.end(), [&](const DifferentPair& pair) {
        return pair.answers[method].verdict == Verdict::Accepted;
      }));
}

OfficesResult runOffices(const OfficesOptions& options) {
  std::vector<Method> methods{defaultMethod()};
  if (methods.front().name != "paper") {
    methods.push_back(bench::methodByName("paper"));
  }
  OfficesResult result;
  for (const Method& method : methods) {
    result.methods.push_back(method.name);
  }
  result.runs.resize(static_cast<size_t>(options.offices * options.runs));
  std::vector<std::vector<std::array<Features, 2>>> features(result.runs.size());
  parallelFor(static_cast<int>(result.runs.size()), options.threads, [&](int i) {
    OfficeRun& run = result.runs[static_cast<size_t>(i)];
    run.office = options.seed + static_cast<std::uint32_t>(i / options.runs);
    run.run = static_cast<std::uint32_t>(i % options.runs);
    run.robots = simulateOffice(run.office, run.run, options.seed);
    for (const Method& method : methods) {
      const std::array<Features, 2> both{method.features(run.robots.maps[0]),
                                         method.features(run.robots.maps[1])};
      OfficeAnswer& answer = run.answers.emplace_back();
      answer.result = method.match(both[0], both[1]);
      if (answer.result.has_pose && run.robots.truth) {
        answer.error = errorOf(answer.result.pose_b_in_a, *run.robots.truth);
      }
      features[static_cast<size_t>(i)].push_back(both);
    }
    if (run.answers.front().result.has_pose) {
      run.not_coinciding =
          wallCoincidence(run.robots, run.answers.front().result.pose_b_in_a).share();
    }
  });

  // Map a of a run with map b of a run in another office, each time a different distance away.
  const auto count = static_cast<int>(result.runs.size());
  const int wanted = options.offices > 1 ? options.different : 0;
  result.different.resize(static_cast<size_t>(wanted));
  parallelFor(wanted, options.threads, [&](int i) {
    const int offices_on = 1 + (i / count) % (options.offices - 1);
    const auto first = static_cast<size_t>(i % count);
    const auto second = static_cast<size_t>((i + offices_on * options.runs) % count);
    DifferentPair& pair = result.different[static_cast<size_t>(i)];
    pair.a = result.runs[first].robots.maps[0].name;
    pair.b = result.runs[second].robots.maps[1].name;
    for (size_t m = 0; m < methods.size(); ++m) {
      pair.answers.push_back(methods[m].match(features[first][m][0], features[second][m][1]));
    }
  });
  return result;
}

}  // namespace sbox::paper
