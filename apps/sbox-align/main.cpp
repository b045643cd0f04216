// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// sbox-align: where one MRPT grid map lies in another. An example of sbox::BoxAligner: what MRPT's
// grid-matching did, in the same few calls.
#include <mrpt/config/CConfigFile.h>
#include <mrpt/core/exceptions.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/poses/CPosePDF.h>
#include <mrpt/serialization/CArchive.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "sbox/slam/box_aligner.h"

namespace {

mrpt::maps::COccupancyGridMap2D loadGrid(const std::string& path) {
  mrpt::io::CFileGZInputStream file;
  if (!file.open(path)) {
    throw std::runtime_error(path + ": cannot be read");
  }
  mrpt::maps::COccupancyGridMap2D grid;
  mrpt::serialization::archiveFrom(file) >> grid;
  return grid;
}

}  // namespace

int main(int argc, char** argv) {
  std::string first, second, config;
  CLI::App app("Tells where one MRPT grid map lies in another");
  app.add_option("map1", first, "A .gridmap")->type_name("MAP1")->required();
  app.add_option("map2", second, "Another, whose pose in the first is asked for")
      ->type_name("MAP2")
      ->required();
  app.add_option("-c,--config", config, "Options of the matching, in a section [BoxAligner]")
      ->type_name("FILE.ini");
  CLI11_PARSE(app, argc, argv);
  try {
    sbox::BoxAligner aligner;
    if (!config.empty()) {
      aligner.options.loadFromConfigFile(mrpt::config::CConfigFile(config), "BoxAligner");
    }
    const auto m1 = loadGrid(first), m2 = loadGrid(second);
    sbox::BoxAligner::Result result;
    const auto pose = aligner.Align(&m1, &m2, {}, result);
    std::cout << sbox::toString(result.pair.verdict) << " " << pose->getMeanVal() << " confidence "
              << result.pair.confidence << "\n";
    return result.pair.verdict == sbox::Verdict::Accepted ? 0 : 3;
  } catch (const std::exception& error) {
    std::cerr << "sbox-align: " << mrpt::exception_to_str(error) << "\n";
    return 1;
  }
}
