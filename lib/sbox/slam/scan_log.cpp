// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/slam/scan_log.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <new>

#include "sbox/io/file_bytes.h"
#include "sbox/io/file_error.h"
#include "sbox/mapping/sound_scan.h"
#include "sbox/slam/bare_observations.h"
#include "sbox/slam/paired_entries.h"

namespace sbox {
namespace {

using mrpt::obs::CRawlog;
using mrpt::serialization::CSerializable;

/// MRPT reads an observation that a file says is missing, or that is of no such class, as a null
/// pointer. (A missing action it follows at once.)
bool isWhole(const CSerializable& entry) {
  if (const auto* frame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(&entry)) {
    return std::all_of(frame->begin(), frame->end(),
                       [](const auto& observation) { return observation != nullptr; });
  }
  if (const auto* log = dynamic_cast<const CRawlog*>(&entry)) {
    for (size_t i = 0; i < log->size(); ++i) {
      const CSerializable::Ptr inner = log->getAsGeneric(i);
      if (!inner || !isWhole(*inner)) {
        return false;
      }
    }
  }
  return true;
}

struct RawEntries {
  CRawlog log;
  bool cut_off = false;
};

/// CRawlog's own reading prints a backtrace on damaged files and does not tell of them.
RawEntries readRawlog(const std::string& path) {
  checkReadable(path);
  mrpt::io::CFileGZInputStream in;
  if (!in.open(path)) {
    throw FileError(path, "cannot be read");
  }
  RawEntries entries;
  auto archive = mrpt::serialization::archiveFrom(in);
  try {
    while (!entries.cut_off) {
      CSerializable::Ptr entry;
      archive >> entry;
      if (entry && !isWhole(*entry)) {
        entries.cut_off = true;
      } else if (const auto whole = std::dynamic_pointer_cast<CRawlog>(entry)) {
        entries.log = *whole;
      } else if (entry) {
        entries.log.insert(entry);
      }
    }
  } catch (const mrpt::serialization::CExceptionEOF&) {
    // The end, between two entries.
  } catch (const std::bad_alloc&) {
    throw FileError(path, no_memory);
  } catch (const std::exception&) {
    // MRPT's own text is many lines long, with a backtrace.
    entries.cut_off = true;
  }
  if (entries.log.empty()) {
    throw FileError(path, "cannot be read as a rawlog");
  }
  return entries;
}

/// "120 CObservationImage, 60 CObservationOdometry": what a log without scans holds instead.
std::string contentsOf(const CRawlog& log) {
  std::map<std::string, int> counts;
  const auto count = [&](const mrpt::rtti::CObject& object) {
    ++counts[object.GetRuntimeClass()->className];
  };
  for (size_t i = 0; i < log.size(); ++i) {
    if (log.getType(i) == CRawlog::etSensoryFrame) {
      for (const auto& observation : *log.getAsObservations(i)) {
        count(*observation);
      }
    } else if (log.getType(i) == CRawlog::etObservation) {
      count(*log.getAsObservation(i));
    }
  }
  std::string text;
  for (const auto& [name, number] : counts) {
    text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + name;
  }
  return text.empty() ? "no observations" : text;
}

/// ICP-SLAM keeps account of each lidar by its label, so that lidars without one would be taken
/// for one lidar, and all but the first of a frame be left out of the map.
void labelLidars(const ScanLog& log) {
  using mrpt::obs::CObservation2DRangeScan;
  for (const LogStep& step : log.steps) {
    std::vector<mrpt::obs::CObservation::Ptr> scans;
    std::copy_if(step.seen->begin(), step.seen->end(), std::back_inserter(scans),
                 [](const mrpt::obs::CObservation::Ptr& observation) {
                   return std::dynamic_pointer_cast<CObservation2DRangeScan>(observation);
                 });
    for (size_t i = 0; scans.size() > 1 && i < scans.size(); ++i) {
      if (scans[i]->sensorLabel.empty()) {
        scans[i]->sensorLabel = "lidar " + std::to_string(i + 1);
      }
    }
  }
}

/// Neither a robot between two scans nor the light of its lidar comes farther, metres.
constexpr double kFarthest = 1e6;

/// SLAM would write beside its memory.
void checkSound(const ScanLog& log, const std::string& path) {
  for (const LogStep& step : log.steps) {
    if (const auto moved = step.moved->getBestMovementEstimation()) {
      const mrpt::poses::CPose2D pose = moved->poseChange->getMeanVal();
      if (!(pose.norm() <= kFarthest && std::isfinite(pose.phi()))) {
        throw FileError(path, "is damaged: a movement of its odometry makes no sense");
      }
    }
    for (const auto& observation : *step.seen) {
      if (!isSound(*observation)) {
        throw FileError(path, "is damaged: the pose, angles or ranges of a scan make no sense");
      }
    }
  }
}

/// Some drivers give the largest number there is for a beam without an echo, over which ICP-SLAM's
/// map of points stumbles.
void unboundEcholess(const ScanLog& log) {
  for (const LogStep& step : log.steps) {
    for (const auto& observation : *step.seen) {
      const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(observation);
      for (size_t i = 0; scan && i < scan->getScanSize(); ++i) {
        if (scan->getScanRange(i) > kFarthest) {
          scan->setScanRange(i, std::numeric_limits<float>::infinity());
        }
      }
    }
  }
}

}  // namespace

ScanLog loadScanLog(const std::string& path) {
  const RawEntries entries = readRawlog(path);
  const CRawlog& raw = entries.log;
  bool pairs = false;
  for (size_t i = 0; i < raw.size(); ++i) {
    pairs = pairs || raw.getType(i) == CRawlog::etSensoryFrame;
  }
  ScanLog log = pairs ? stepsOfPairs(raw) : stepsOfObservations(raw);
  if (log.steps.empty()) {
    throw FileError(path, "holds no 2D lidar scan to make a map of, but " + contentsOf(raw));
  }
  checkSound(log, path);
  unboundEcholess(log);
  labelLidars(log);
  log.cut_off = entries.cut_off;
  return log;
}

}  // namespace sbox
