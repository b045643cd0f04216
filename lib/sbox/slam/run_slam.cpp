// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/run_slam.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/random/RandomGenerators.h>
#include <mrpt/slam/CMetricMapBuilderICP.h>
#include <mrpt/slam/CMetricMapBuilderRBPF.h>

#include <map>
#include <memory>
#include <stdexcept>

#include "sbox/io/simplemap_file.h"
#include "sbox/slam/best_particle.h"
#include "sbox/slam/mrpt_reason.h"
#include "sbox/slam/stamp_steps.h"

namespace sbox {
namespace {

using mrpt::slam::CMetricMapBuilder;
using mrpt::slam::CMetricMapBuilderICP;
using mrpt::slam::CMetricMapBuilderRBPF;

/// The section that MRPT's programs read.
constexpr const char* section = "MappingApplication";

std::unique_ptr<CMetricMapBuilder> makeIcp(const mrpt::config::CConfigFileBase& settings) {
  auto builder = std::make_unique<CMetricMapBuilderICP>();
  builder->ICP_options.loadFromConfigFile(settings, section);
  if (builder->ICP_options.mapInitializers.size() == 0) {
    throw std::runtime_error(std::string("section [") + section + "] names no map to make");
  }
  builder->ICP_params.loadFromConfigFile(settings, "ICP");
  builder->setVerbosityLevel(mrpt::system::LVL_ERROR);
  builder->initialize();
  return builder;
}

std::unique_ptr<CMetricMapBuilder> makeRbpf(const mrpt::config::CConfigFileBase& settings,
                                            unsigned seed) {
  CMetricMapBuilderRBPF::TConstructionOptions options;
  options.loadFromConfigFile(settings, section);
  options.verbosity_level = mrpt::system::LVL_ERROR;
  mrpt::random::getRandomGenerator().randomize(seed);
  auto builder = std::make_unique<CMetricMapBuilderRBPF>(options);
  builder->setVerbosityLevel(mrpt::system::LVL_ERROR);
  builder->mapPDF.setVerbosityLevel(mrpt::system::LVL_ERROR);
  return builder;
}

std::unique_ptr<CMetricMapBuilder> makeBuilder(const SlamOptions& options) {
  const std::string& text =
      options.settings.empty() ? defaultSlamSettings(options.method) : options.settings;
  try {
    const mrpt::config::CConfigFileMemory settings(text);
    return options.method == SlamMethod::Icp ? makeIcp(settings) : makeRbpf(settings, options.seed);
  } catch (const std::exception& error) {
    throw SlamError("cannot be mapped with these SLAM settings: " + mrptReason(error));
  }
}

/// ICP-SLAM makes a key frame of one scan, and of each lidar's at other places: all that was seen
/// in the step that the scan belongs to comes in its place.
KeyFrames wholeSteps(const KeyFrames& key_frames, const ScanLog& log) {
  std::map<const mrpt::obs::CObservation*, const LogStep*> steps;
  for (const LogStep& step : log.steps) {
    for (const auto& observation : *step.seen) {
      steps.emplace(observation.get(), &step);
    }
  }
  KeyFrames whole;
  for (const KeyFrame& key_frame : key_frames) {
    const LogStep& step = *steps.at(key_frame.seen->begin()->get());
    if (whole.empty() || whole.back().seen != step.seen) {
      whole.push_back({key_frame.robot_in_map, step.seen});
    }
  }
  return whole;
}

}  // namespace

KeyFrames runSlam(ScanLog log, const SlamOptions& options, const std::function<void()>& step_done) {
  if (options.method == SlamMethod::Rbpf && !log.has_odometry) {
    throw SlamError("has no odometry, which RBPF-SLAM needs: take --slam icp");
  }
  stampSteps(log);
  const std::unique_ptr<CMetricMapBuilder> builder = makeBuilder(options);
  for (const LogStep& step : log.steps) {
    try {
      builder->processActionObservation(*step.moved, *step.seen);
    } catch (const std::exception& error) {
      throw SlamError("cannot be mapped: " + mrptReason(error));
    }
    if (step_done) {
      step_done();
    }
  }
  mrpt::maps::CSimpleMap map;
  builder->getCurrentlyBuiltMap(map);
  try {
    return options.method == SlamMethod::Rbpf ? keepBestParticle(keyFramesOf(map))
                                              : wholeSteps(keyFramesOf(map), log);
  } catch (const std::invalid_argument& error) {
    throw SlamError(std::string("cannot be mapped: SLAM made ") + error.what());
  }
}

}  // namespace sbox
