// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-dataset/run.h"

#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <memory>
#include <utility>

namespace sbox::dataset {

KeyFrames keyFramesOf(const Run& run) {
  KeyFrames key_frames;
  for (const RunStep& step : run) {
    const mrpt::poses::CPose3D robot_in_map(mrpt::math::TPose3D(step.pose_in_map));
    auto seen = std::make_shared<mrpt::obs::CSensoryFrame>();
    seen->insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(step.scan));
    key_frames.push_back(
        {std::make_shared<mrpt::poses::CPose3DPDFGaussian>(robot_in_map), std::move(seen)});
  }
  return key_frames;
}

Map mapRun(const std::string& name, const Run& run, const MappingOptions& options) {
  return mapKeyFrames(name, keyFramesOf(run), options);
}

}  // namespace sbox::dataset
