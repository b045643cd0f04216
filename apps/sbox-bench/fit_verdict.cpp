// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/fit_verdict.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "sbox-bench/judge.h"
#include "sbox/core/logit.h"
#include "sbox/core/parallel.h"
#include "sbox/match_pair.h"

namespace sbox::bench {
namespace {

constexpr Eigen::Index kSize = kVerdictTerms + 1;  // The last is "none of the fits".
using Weights = Eigen::Matrix<double, kSize, 1>;
using Curvature = Eigen::Matrix<double, kSize, kSize>;

/// The choices of a pair, a column each, the last "none"; terms scaled to mean 0 and variance 1.
struct Choices {
  Eigen::Matrix<double, kSize, Eigen::Dynamic> terms;
  Eigen::ArrayXd right;  ///< 1 for choices that are right.
  double weight = 0;
};

struct Scale {
  Weights mean = Weights::Zero();
  Weights deviation = Weights::Ones();
};

Scale scaleOf(const std::vector<VerdictSample>& samples) {
  Weights sum = Weights::Zero(), squares = Weights::Zero();
  double count = 0;
  for (const VerdictSample& sample : samples) {
    for (const auto& terms : sample.terms) {
      for (size_t i = 0; i < kVerdictTerms; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        sum(k) += terms[i];
        squares(k) += terms[i] * terms[i];
      }
      ++count;
    }
  }
  Scale scale;
  for (Eigen::Index k = 0; k + 1 < kSize && count > 0; ++k) {
    scale.mean(k) = sum(k) / count;
    scale.deviation(k) =
        std::sqrt(std::max(1e-12, squares(k) / count - scale.mean(k) * scale.mean(k)));
  }
  return scale;
}

std::vector<Choices> makeChoices(const std::vector<VerdictSample>& samples, const Scale& scale) {
  std::vector<double> pairs_of_folder;
  for (const VerdictSample& sample : samples) {
    pairs_of_folder.resize(std::max(pairs_of_folder.size(), sample.folder + 1), 0.0);
    ++pairs_of_folder[sample.folder];
  }
  double all_weights = 0;
  for (const VerdictSample& sample : samples) {
    all_weights += sample.folder_weight / pairs_of_folder[sample.folder];
  }
  std::vector<Choices> all;
  for (const VerdictSample& sample : samples) {
    Choices choices;
    const auto count = static_cast<Eigen::Index>(sample.terms.size());
    choices.terms.setZero(kSize, count + 1);
    choices.right.setZero(count + 1);
    for (Eigen::Index j = 0; j < count; ++j) {
      for (Eigen::Index k = 0; k + 1 < kSize; ++k) {
        choices.terms(k, j) =
            (sample.terms[static_cast<size_t>(j)][static_cast<size_t>(k)] - scale.mean(k)) /
            scale.deviation(k);
      }
      choices.right(j) = sample.right[static_cast<size_t>(j)] ? 1 : 0;
    }
    choices.terms(kSize - 1, count) = 1;
    choices.right(count) = choices.right.sum() > 0 ? 0 : 1;
    choices.weight = sample.folder_weight / (pairs_of_folder[sample.folder] * all_weights);
    all.push_back(std::move(choices));
  }
  return all;
}

/// Negative log likelihood with the ridge, its gradient and a curvature that is never too small.
double evaluate(const std::vector<Choices>& all, const Weights& weights, double ridge,
                Weights* gradient, Curvature* curvature) {
  Weights penalty = Weights::Constant(2 * ridge);
  penalty(kSize - 1) = 0;
  double loss = 0.5 * weights.dot(penalty.cwiseProduct(weights));
  if (gradient != nullptr) {
    *gradient = penalty.cwiseProduct(weights);
    *curvature = Curvature((penalty.array() + 1e-9).matrix().asDiagonal());
  }
  for (const Choices& choices : all) {
    const Eigen::ArrayXd scores = (choices.terms.transpose() * weights).array();
    const Eigen::ArrayXd shares = (scores - scores.maxCoeff()).exp();
    const double total = shares.sum(), right = (shares * choices.right).sum();
    loss += choices.weight * (std::log(total) - std::log(right));
    if (gradient != nullptr) {
      const Eigen::VectorXd p = (shares / total).matrix();
      const Eigen::VectorXd q = (shares * choices.right / right).matrix();
      const Weights mean = choices.terms * p;
      *gradient += choices.weight * (mean - choices.terms * q);
      *curvature += choices.weight * (choices.terms * p.asDiagonal() * choices.terms.transpose() -
                                      mean * mean.transpose());
    }
  }
  return loss;
}

}  // namespace

std::vector<VerdictSample> collectSamples(const LoadedFolder& loaded, size_t folder,
                                          double folder_weight, int threads) {
  const PairOptions options;
  std::vector<MapFeatures> features(loaded.maps.size());
  parallelFor(static_cast<int>(features.size()), threads, [&](int i) {
    const auto k = static_cast<size_t>(i);
    features[k] = extractFeatures(loaded.maps[k], options.features);
  });
  std::vector<VerdictSample> samples(loaded.folder.pairs.size());
  parallelFor(static_cast<int>(samples.size()), threads, [&](int i) {
    const auto k = static_cast<size_t>(i);
    samples[k].folder = folder;
    samples[k].folder_weight = folder_weight;
    // As in matchPair().
    auto a = static_cast<size_t>(loaded.map_of_pair[k].first);
    auto b = static_cast<size_t>(loaded.map_of_pair[k].second);
    const bool is_exchanged = comesFirst(features[b], features[a]);
    if (is_exchanged) {
      std::swap(a, b);
    }
    PairSeconds seconds;
    for (const Fit& fit : findAnswers(features[a], features[b], options, seconds)) {
      const std::vector<BoxMatch> boxes =
          matchBoxes(features[a], features[b], fit.b_in_a, fit.drift, options.boxes);
      const RefinedPose refined =
          refinePose(features[a], features[b], fit.b_in_a, fit.drift, boxes, options.refine);
      const Pose2D pose = framePose(features[a], features[b], refined.b_in_a);
      const Pose2D corners =
          cornerTransform(pose, loaded.maps[a].corner_in_map, loaded.maps[b].corner_in_map);
      const std::optional<PoseError> error =
          poseError(loaded.folder.pairs[k], loaded.folder.resolution,
                    is_exchanged ? inverse(corners) : corners);
      samples[k].terms.push_back(verdictTerms(fit));
      samples[k].right.push_back(error && error->right);
    }
  });
  return samples;
}

VerdictModel fitModel(const std::vector<VerdictSample>& samples, double ridge) {
  const Scale scale = scaleOf(samples);
  const std::vector<Choices> all = makeChoices(samples, scale);
  Weights weights = Weights::Zero();
  constexpr int most_steps = 200;
  for (int i = 0; i < most_steps; ++i) {
    Weights gradient;
    Curvature curvature;
    const double loss = evaluate(all, weights, ridge, &gradient, &curvature);
    const Weights step = curvature.ldlt().solve(gradient);
    double length = 1;
    while (length > 1e-6 &&
           evaluate(all, weights - length * step, ridge, nullptr, nullptr) > loss) {
      length /= 2;
    }
    weights -= length * step;
    if (gradient.norm() < 1e-8 || length <= 1e-6) {
      break;
    }
  }
  VerdictModel model;
  model.none = weights(kSize - 1);
  for (size_t i = 0; i < kVerdictTerms; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    model.weights[i] = weights(k) / scale.deviation(k);
    model.none += model.weights[i] * scale.mean(k);
  }
  return model;
}

std::vector<double> probabilities(const VerdictSample& sample, const VerdictModel& model) {
  std::vector<double> log_odds;
  for (const auto& terms : sample.terms) {
    log_odds.push_back(logOdds(terms, model));
  }
  return probabilitiesByLogit(log_odds, model.none);
}

}  // namespace sbox::bench
