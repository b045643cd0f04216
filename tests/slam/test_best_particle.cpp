// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/poses/CPose3DPDFParticles.h>

#include <cmath>
#include <memory>

#include "catch.h"
#include "mapping/scanned_room.h"
#include "sbox/slam/best_particle.h"

using namespace sbox;
using namespace sbox::test;

TEST_CASE("the likeliest particle gives the pose, all of them the covariance", "[best_particle]") {
  auto set = std::make_shared<mrpt::poses::CPose3DPDFParticles>(2);
  set->m_particles[0].d = mrpt::math::TPose3D(0, 0, 0, 0, 0, 0);
  set->m_particles[0].log_w = std::log(0.25);
  set->m_particles[1].d = mrpt::math::TPose3D(4, 2, 0, 0.5, 0, 0);
  set->m_particles[1].log_w = std::log(0.75);
  KeyFrames frames{keyFrame({}, {}, {1, 1, 1})};
  frames.push_back({set, frames[0].seen});
  const KeyFrames kept = keepBestParticle(frames);
  CHECK(poseOf(kept[0]).x == 1);
  CHECK(poseOf(kept[1]).x == Approx(4));
  CHECK(poseOf(kept[1]).y == Approx(2));
  CHECK(poseOf(kept[1]).phi == Approx(0.5));
  const auto covariance = std::get<0>(kept[1].robot_in_map->getCovarianceAndMean());
  CHECK(covariance(0, 0) == Approx(16 * 0.25 * 0.75));
  CHECK(frames[1].robot_in_map == set);
}
