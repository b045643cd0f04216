// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The matching of two grids behind MRPT's interface for aligning maps, so that code written for
// mrpt::slam::CGridMapAligner or CICP can call it.
#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <mrpt/slam/CMetricMapsAlignmentAlgorithm.h>

#include <iosfwd>
#include <string>

#include "sbox/core/feature_set.h"
#include "sbox/core/pair_result.h"
#include "sbox/merge_options.h"

namespace sbox {

/// Finds the pose of one grid map in another, from nothing but their cells.
///
///     sbox::BoxAligner aligner;
///     sbox::BoxAligner::Result result;
///     const auto pose = aligner.Align(&grid_1, &grid_2, {}, result);
///     if (result.pair.verdict == sbox::Verdict::Accepted) { use(pose->getMeanVal()); }
class BoxAligner : public mrpt::slam::CMetricMapsAlignmentAlgorithm {
 public:
  /// With the default options.
  BoxAligner();

  /// Every option of the matching, in one section of an ini file, all keys optional: `method`, and
  /// keys such as `paper.lines.max_lines`; dumpToTextStream lists them with units.
  struct Options : public mrpt::config::CLoadableOptions {
    /// Only what concerns the matching of a pair has a meaning here.
    MergeOptions merge;

    /// Throws std::runtime_error, naming section and key, on a value out of its range.
    void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                            const std::string& section) override;
    /// Writes every key with its meaning; loadFromConfigFile reads it back.
    void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                          const std::string& section) const override;
    /// Prints every key with its value and meaning.
    void dumpToTextStream(std::ostream& out) const override;
  };
  Options options;  ///< How grids are matched.

  /// What to give as outInfo; any other TMetricMapAlignmentResult gets the running time only.
  struct Result : public mrpt::slam::TMetricMapAlignmentResult {
    PairResult pair;       ///< Verdict, reason, confidence, alternatives: m2 is map b, m1 is map a.
    FeatureSet features1;  ///< Of m1, in its frame.
    FeatureSet features2;  ///< Of m2, in its frame.
  };

  /// Variance (m^2 and rad^2) of every coordinate when there is no answer.
  static constexpr double no_answer_variance = 1e6;

  /// Pose of m2 in m1. Both are mrpt::maps::COccupancyGridMap2D, or mrpt::maps::CMultiMetricMap
  /// whose first grid is taken. What comes back follows the verdict:
  /// accepted: CPosePDFGaussian;
  /// ambiguous: CPosePDFSOG, a mode for every answer, weighted by confidence;
  /// rejected: CPosePDFGaussian at the best candidate, or zero, with no_answer_variance.
  /// The initial estimate is not used. Throws std::invalid_argument if a map is or has no grid.
  mrpt::poses::CPosePDF::Ptr AlignPDF(
      const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
      const mrpt::poses::CPosePDFGaussian& initial_estimate,
      mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> out_info = std::nullopt) override;

  /// The same in three dimensions: z, pitch and roll are zero, as maps of one floor have them.
  mrpt::poses::CPose3DPDF::Ptr Align3DPDF(
      const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
      const mrpt::poses::CPose3DPDFGaussian& initial_estimate,
      mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> out_info = std::nullopt) override;
};

}  // namespace sbox
