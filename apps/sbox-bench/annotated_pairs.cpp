// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-bench/annotated_pairs.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sbox-bench/text_file.h"

namespace sbox::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<Point2D> readPoints(const json& list) {
  std::vector<Point2D> points;
  points.reserve(list.size());
  for (const json& point : list) {
    points.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
  }
  return points;
}

json pointsJson(const std::vector<Point2D>& points) {
  json list = json::array();
  for (const Point2D& point : points) {
    list.push_back({point.x, point.y});
  }
  return list;
}

nlohmann::ordered_json pairJson(const AnnotatedPair& pair) {
  nlohmann::ordered_json entry = {{"env", pair.group}, {"a", pair.a}, {"b", pair.b}};
  if (pair.negative) {
    entry["negative"] = true;
    return entry;
  }
  entry["theta_deg"] = pair.theta_deg;
  if (pair.theta_local) {
    entry["theta_local"] = *pair.theta_local;
  }
  entry["t_cells"] = pointsJson({pair.offset}).front();
  entry["rms_cells"] = pair.floor_cells;
  entry["tol_cells"] = pair.tolerance_cells;
  entry["pa"] = pointsJson(pair.points_a);
  entry["pb"] = pointsJson(pair.points_b);
  return entry;
}

AnnotatedPair readPair(const json& entry) {
  AnnotatedPair pair;
  pair.group = entry.at("env").get<std::string>();
  pair.a = entry.at("a").get<std::string>();
  pair.b = entry.at("b").get<std::string>();
  pair.negative = entry.value("negative", false);
  if (pair.negative) {
    return pair;
  }
  pair.theta_deg = entry.at("theta_deg").get<double>();
  if (entry.contains("theta_local")) {
    pair.theta_local = entry.at("theta_local").get<double>();
  }
  pair.offset = readPoints(json::array({entry.at("t_cells")})).front();
  pair.points_a = readPoints(entry.at("pa"));
  pair.points_b = readPoints(entry.at("pb"));
  if (pair.points_a.empty() || pair.points_a.size() != pair.points_b.size()) {
    throw std::runtime_error("pair " + pair.a + " " + pair.b +
                             " needs as many points in pa as in pb, at least one");
  }
  pair.floor_cells = entry.at("rms_cells").get<double>();
  pair.tolerance_cells = entry.value("tol_cells", pair.tolerance_cells);
  return pair;
}

}  // namespace

PairFolder readPairFolder(const std::string& folder) {
  const std::string file = (fs::path(folder) / "pairs.json").string();
  std::ifstream in(file);
  if (!in) {
    throw std::runtime_error(file + ": cannot be read; give a folder that holds a pairs.json");
  }
  PairFolder result;
  result.path = folder;
  result.name = fs::weakly_canonical(fs::path(folder) / "pairs.json").parent_path().filename();
  try {
    const json document = json::parse(in);
    result.resolution = document.at("resolution").get<double>();
    for (const json& entry : document.at("pairs")) {
      result.pairs.push_back(readPair(entry));
    }
  } catch (const std::exception& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
  if (!(result.resolution > 0) || !std::isfinite(result.resolution)) {
    throw std::runtime_error(file + ": resolution must be positive");
  }
  return result;
}

void writePairFolder(const PairFolder& folder) {
  nlohmann::ordered_json document = {{"resolution", folder.resolution},
                                     {"pairs", nlohmann::ordered_json::array()}};
  for (const AnnotatedPair& pair : folder.pairs) {
    document["pairs"].push_back(pairJson(pair));
  }
  writeText((fs::path(folder.path) / "pairs.json").string(), document.dump(1) + "\n");
}

std::string findMapFile(const std::string& folder, const std::string& name) {
  const fs::path own = fs::weakly_canonical(folder);
  for (const fs::path& base : {own / name, own.parent_path() / name}) {
    for (const char* extension : {".gridmap", ".gridmap.gz", ".yaml", ".png"}) {
      std::string file = base.string() + extension;
      if (fs::exists(file)) {
        return file;
      }
    }
  }
  throw std::runtime_error(
      (own / name).string() +
      ": no .gridmap, .gridmap.gz, .yaml or .png here or in the parent folder");
}

Pose2D trueCornerAInCornerB(const AnnotatedPair& pair, double resolution) {
  return {pair.offset.x * resolution, pair.offset.y * resolution, pair.theta_deg * M_PI / 180};
}

}  // namespace sbox::bench
