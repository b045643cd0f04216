// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When two fits are one answer: in bent maps one answer has several good rigid transforms.
#pragma once

#include <vector>

#include "sbox/features/map_features.h"
#include "sbox/verification/fit.h"

namespace sbox {

/// When fits are one answer.
struct SameAnswerOptions {
  double distance = 0.6;  ///< Nearer fits are one whatever the drift, metres.
  /// So are fits nearer than this times the roughness of the rougher drift field of both.
  double drift_share = 8.0;
};

/// Root mean square distance between the places that two fits, their drift taken out, give the
/// walls of map b which fall on map a, metres; infinite if none do.
[[nodiscard]] double distanceWhenBent(const MapFeatures& a, const MapFeatures& b, const Fit& left,
                                      const Fit& right);

/// Drops each fit that is the same answer as one before it. `fits`: the most probable first. What
/// is left has to be judged again: the verdict's model is one of answers.
void mergeAnswers(const MapFeatures& a, const MapFeatures& b, std::vector<Fit>& fits,
                  const SameAnswerOptions& options = {});

}  // namespace sbox
