// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/best_particle.h"

#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPose3DPDFParticles.h>

#include <algorithm>
#include <memory>

namespace sbox {

KeyFrames keepBestParticle(const KeyFrames& key_frames) {
  using mrpt::poses::CPose3DPDFParticles;
  KeyFrames kept = key_frames;
  for (KeyFrame& key_frame : kept) {
    const auto set = std::dynamic_pointer_cast<CPose3DPDFParticles>(key_frame.robot_in_map);
    if (!set || set->m_particles.empty()) {
      continue;
    }
    const auto best = std::max_element(
        set->m_particles.begin(), set->m_particles.end(),
        [](const auto& first, const auto& second) { return first.log_w < second.log_w; });
    const auto covariance = std::get<0>(set->getCovarianceAndMean());
    key_frame.robot_in_map = std::make_shared<mrpt::poses::CPose3DPDFGaussian>(
        mrpt::poses::CPose3D(best->d), covariance);
  }
  return kept;
}

}  // namespace sbox
