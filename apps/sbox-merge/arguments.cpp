// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <map>

#include "sbox-merge/load_inputs.h"
#include "sbox/config/config_file.h"
#include "sbox/core/map_limits.h"
#include "sbox/core/number_text.h"
#include "sbox/io/file_bytes.h"
#include "sbox/io/initial_file.h"
#include "sbox/io/path_extension.h"

namespace sbox::app {
namespace {

constexpr const char* description =
    "Joins the 2D occupancy grid maps of several robots into one.\n"
    "Maps: .gridmap[.gz], .simplemap[.gz] (MRPT), .yaml (ROS, with its image); .png, .pgm,\n"
    ".bmp, .jpg or .tif with --resolution. Robots' logs: .rawlog[.gz] (MRPT), mapped by SLAM "
    "first.";

constexpr const char* footer =
    "Exit codes: 0 every map is part of the merged map, or --pairs wrote its share; 1 an input or\n"
    "output cannot be used;\n"
    "2 wrong usage; 3 not every map could be placed with confidence (the report says why; of two\n"
    "maps nothing is merged then); 129, 130, 143 stopped by a signal.\n"
    "Example: sbox-merge --in a.yaml b.yaml --out merged.yaml --report report.json --pictures why";

/// What is read as text first: errors then say what is allowed in plain words.
struct Texts {
  std::string config;
  std::string initial;
  std::string pairs;
  std::string method;
  std::string fusion;
  std::string slam;
  std::string slam_config;
};

constexpr std::uint64_t max_settings_size = 1 << 20;

const std::map<std::string, Method> methods{{"boxes", Method::Boxes}, {"paper", Method::Paper}};
/// Of cells, or nothing: of observations.
const std::map<std::string, std::optional<FusionRule>> fusion_rules{
    {"logodds", FusionRule::LogOdds}, {"observations", {}}, {"table", FusionRule::Table}};

const std::map<std::string, SlamMethod> slam_methods{{"icp", SlamMethod::Icp},
                                                     {"rbpf", SlamMethod::Rbpf}};

/// The value that the word names, or `fallback` without a word.
template <typename Value>
Value chosen(const std::string& option, const std::string& word,
             const std::map<std::string, Value>& values, Value fallback) {
  if (word.empty()) {
    return fallback;
  }
  const auto found = values.find(word);
  if (found != values.end()) {
    return found->second;
  }
  std::string allowed;
  for (const auto& value : values) {
    allowed += (allowed.empty() ? "" : " or ") + value.first;
  }
  throw UsageError(option + " must be " + allowed + ", not " + word);
}

void addFiles(CLI::App& app, Arguments& arguments) {
  app.add_option("--in", arguments.inputs, "The maps to merge, or logs to map first; two or more")
      ->type_name("MAP");
  app.add_option("--out", arguments.output,
                 "The merged map: .gridmap, .gridmap.gz or .yaml; a .png is written beside it\n"
                 "(default " +
                     arguments.output + ")")
      ->type_name("FILE");
  app.add_option("--simplemap", arguments.simplemap,
                 "Write the key frames of all merged maps, in the merged map's frame, as one\n"
                 ".simplemap; every map must hold scans")
      ->type_name("FILE");
  app.add_option("--report", arguments.report, "Write what was found, and why, as JSON")
      ->type_name("FILE");
  app.add_option("--pictures", arguments.pictures,
                 "Write pictures into this folder: features of each map, matched boxes, overlays,\n"
                 "merged map; it is made if missing")
      ->type_name("DIR");
  app.add_option("--html", arguments.html,
                 "Write a page to look into the result: overlays to fade and toggle, verdicts,\n"
                 "poses, features; one file that needs nothing else")
      ->type_name("FILE");
  app.add_option("--tf", arguments.tf,
                 "Write where each map lies in the merged map as ROS transforms: .yaml as a\n"
                 "tf2_msgs/TFMessage, else static_transform_publisher commands")
      ->type_name("FILE");
  app.add_option("--graph", arguments.graph,
                 "Write how the maps hold together as a graph of poses (VERTEX2, EDGE2) for\n"
                 "MRPT's graph-slam, usually a .graph")
      ->type_name("FILE");
  app.add_option("--resolution", arguments.resolution,
                 "Edge length of a cell of plain images, in metres (no default)")
      ->type_name("M");
}

void addChoices(CLI::App& app, Arguments& arguments, Texts& texts) {
  app.add_option("--reference", arguments.merge.reference,
                 "Number of the map, from 0, whose frame the merged map takes\n"
                 "(default: the first that is part of it)")
      ->type_name("N");
  app.add_flag("--all-groups", arguments.merge.all_groups,
               "Write a merged map of each group of two or more, not only the largest");
  app.add_option(
         "--initial", texts.initial,
         "Where maps are thought to lie, in one frame: lines MAP x y phi sigma_xy sigma_phi\n"
         "in metres and degrees. Breaks ties; maps that are sure overrule it")
      ->type_name("FILE");
  app.add_option("--method", texts.method,
                 "How pairs are matched: corners and boxes propose and the cells decide, or the\n"
                 "published method as it is printed (default boxes)")
      ->type_name("boxes|paper");
  app.add_option(
         "--fusion", texts.fusion,
         "How maps are joined: the paper's table, the sum of log-odds, or a new map of all\n"
         "scans, which every map must hold and which are adjusted to each other first\n"
         "(default logodds)")
      ->type_name("table|logodds|observations");
  app.add_flag("--bend", arguments.merge.bend,
               "Bend maps that have drifted so that walls seen twice fall on each other in the\n"
               "merged map; poses stay those of the maps as they are");
  app.add_option("--slam", texts.slam,
                 "How rawlogs are mapped, by MRPT: ICP-SLAM, or particles, which take longer\n"
                 "(default icp); maps are kept beside the output")
      ->type_name("icp|rbpf");
  app.add_option("--slam-config", texts.slam_config,
                 "Settings as MRPT's icp-slam or rbpf-slam read them (default: built in)")
      ->type_name("FILE.ini");
  app.add_option("--pairs", texts.pairs,
                 "Match only share K of N of the pairs and write them to --report; nothing is\n"
                 "merged. For other machines to match the other shares of the same maps; no more\n"
                 "shares than maps")
      ->type_name("K/N");
  app.add_option("--join", arguments.joined,
                 "Merge by what all N shares of --pairs found, instead of matching")
      ->type_name("FILE");
  app.add_option("--config", texts.config,
                 "Options of every stage, all optional; see --dump-config")
      ->type_name("FILE.ini");
  app.add_flag("--dump-config", arguments.dump_config,
               "Print all options of every stage with units and values, and end");
  app.add_option("--threads", arguments.merge.threads,
                 "Threads to work on, 0: one a core (default 0)")
      ->type_name("N");
}

PairShare shareFrom(const std::string& text) {
  PairShare share;
  int length = 0;
  constexpr int most = 1000000;
  if (std::sscanf(text.c_str(), "%7d/%7d%n", &share.number, &share.count, &length) != 2 ||
      static_cast<size_t>(length) != text.size() || share.number < 1 ||
      share.number > share.count || share.count > most) {
    throw UsageError("--pairs must be K/N with K from 1 to N, not " + text);
  }
  return share;
}

[[noreturn]] void throwNothingToWrite(const std::string& file) {
  throw UsageError("--pairs merges nothing, so that there is no " + file + " to write");
}

void checkShare(const Arguments& arguments) {
  if (static_cast<size_t>(arguments.share->count) > arguments.inputs.size()) {
    throw UsageError("--pairs takes no more shares than maps, " +
                     std::to_string(arguments.inputs.size()) + ", not " +
                     std::to_string(arguments.share->count));
  }
  if (arguments.report.empty()) {
    throw UsageError("--pairs needs a --report to write to");
  }
  if (!arguments.joined.empty()) {
    throw UsageError("--pairs and --join exclude each other");
  }
  for (const std::string& input : arguments.inputs) {
    if (isRawlog(input)) {
      throw UsageError("--pairs takes maps, not logs: map " + input +
                       " first, then give its .simplemap");
    }
  }
  for (const std::string& file :
       {arguments.html, arguments.pictures, arguments.tf, arguments.graph, arguments.simplemap}) {
    if (!file.empty()) {
      throwNothingToWrite(file);
    }
  }
}

void check(const Arguments& arguments) {
  if (arguments.share) {
    checkShare(arguments);
  }
  const auto count = static_cast<int>(arguments.inputs.size());
  if (count < 2) {
    throw UsageError("--in needs two maps or more");
  }
  const std::optional<int>& reference = arguments.merge.reference;
  if (reference && (*reference < 0 || *reference >= count)) {
    throw UsageError("--reference must be from 0 to " + std::to_string(count - 1) + ", not " +
                     std::to_string(*reference));
  }
  constexpr int most_threads = 1024;
  if (arguments.merge.threads < 0 || arguments.merge.threads > most_threads) {
    throw UsageError("--threads must be from 0 to " + std::to_string(most_threads) + ", not " +
                     std::to_string(arguments.merge.threads));
  }
  const std::string extension = pathExtension(arguments.output);
  if (extension != ".gridmap" && extension != ".gridmap.gz" && extension != ".yaml" &&
      extension != ".yml") {
    throw UsageError("--out must end in .gridmap, .gridmap.gz or .yaml, not " + arguments.output);
  }
  const std::string key_frames = pathExtension(arguments.simplemap);
  if (!arguments.simplemap.empty() && key_frames != ".simplemap" && key_frames != ".simplemap.gz") {
    throw UsageError("--simplemap must end in .simplemap or .simplemap.gz, not " +
                     arguments.simplemap);
  }
  if (arguments.resolution &&
      !(*arguments.resolution >= min_resolution && *arguments.resolution <= max_resolution)) {
    throw UsageError("--resolution must be from " + numberText(min_resolution) + " to " +
                     numberText(max_resolution) + " metres, not " +
                     numberText(*arguments.resolution));
  }
}

/// What a shell makes of an unset variable would else pass for an option that was not given.
void checkValues(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (std::find(values.begin(), values.end(), "") != values.end()) {
      throw UsageError(option->get_name() + " has an empty value");
    }
  }
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

std::optional<Arguments> parseArguments(int argc, const char* const* argv) {
  Arguments arguments;
  arguments.command_line.assign(argv, argv + argc);
  Texts texts;
  CLI::App app(description, "sbox-merge");
  app.footer(footer);
  app.get_formatter()->column_width(22);
  addFiles(app, arguments);
  addChoices(app, arguments, texts);
  app.add_flag("-v,--verbose", arguments.verbose, "Tell what each stage found, on stderr");
  app.add_flag("-q,--quiet", arguments.quiet, "Tell nothing but errors");
  app.set_version_flag("--version", "sbox-merge " SBOX_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    app.exit(done, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError(firstLine(error.what()));
  }
  checkValues(app);
  for (const std::string& file : {texts.config, texts.initial, texts.slam_config}) {
    if (!file.empty()) {
      arguments.settings.push_back(file);
    }
  }
  if (!texts.config.empty()) {
    loadConfig(texts.config, arguments.merge);
  }
  arguments.merge.method = chosen("--method", texts.method, methods, arguments.merge.method);
  const std::optional<FusionRule> rule = chosen<std::optional<FusionRule>>(
      "--fusion", texts.fusion, fusion_rules, arguments.merge.fusion.rule);
  arguments.fuse_observations = !rule;
  if (arguments.fuse_observations && arguments.merge.bend) {
    throw UsageError("--bend bends cells; --fusion observations adjusts the scans instead");
  }
  arguments.merge.fusion.rule = rule.value_or(arguments.merge.fusion.rule);
  arguments.slam.method = chosen("--slam", texts.slam, slam_methods, arguments.slam.method);
  if (!texts.slam_config.empty()) {
    const Bytes bytes = readFile(texts.slam_config, max_settings_size);
    arguments.slam.settings.assign(bytes.begin(), bytes.end());
  }
  if (!arguments.dump_config) {
    if (!texts.pairs.empty()) {
      arguments.share = shareFrom(texts.pairs);
      if (app.count("--out") > 0) {
        throwNothingToWrite(arguments.output);
      }
    }
    check(arguments);
    if (!texts.initial.empty()) {
      arguments.merge.initial = loadInitialGuesses(texts.initial, arguments.inputs);
    }
  }
  return arguments;
}

}  // namespace sbox::app
