// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// sbox-bench: how right, how honest and how fast each method is on maps with known truth.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line.h"
#include "sbox-bench/calibration.h"
#include "sbox-bench/cross_validation.h"
#include "sbox-bench/fit_verdict.h"
#include "sbox-bench/load_folder.h"
#include "sbox-bench/method_list.h"
#include "sbox-bench/overlay_picture.h"
#include "sbox-bench/refinement_table.h"
#include "sbox-bench/run_method.h"
#include "sbox-bench/score_table.h"
#include "sbox-bench/set_score.h"
#include "sbox-bench/text_file.h"
#include "sbox-bench/whole_command.h"
#include "sbox-bench/write_answers.h"
#include "sbox/verification/verdict.h"

namespace {

using namespace sbox::bench;

struct Arguments {
  std::vector<std::string> folders;
  std::vector<std::string> methods;
  std::vector<std::string> variants;
  PairChoice choice;
  RunOptions run;
  bool markdown = false;
  bool no_seconds = false;
  bool ratios = false;
  bool fit_verdict = false;
  std::vector<double> weights;
  bool sets = false;
  bool refinement = false;
  std::string answers_file;
  std::string json_file;
  std::string wrong_folder;
  std::string refused_folder;
};

void addOptions(CLI::App& app, Arguments& arguments) {
  app.add_option("FOLDER", arguments.folders, "Folders that hold a pairs.json")->required();
  app.add_option("--method", arguments.methods, "Methods to run, side by side")
      ->check(CLI::IsMember(methodNames()));
  app.add_option("--with", arguments.variants,
                 "Also run the default method with other options, section.key=value[,...] as\n"
                 "sbox-merge --dump-config names them: what a part is worth")
      ->type_name("SETTINGS");
  app.add_option("--only", arguments.choice.only,
                 "Only pairs whose \"folder group a b\" holds this text");
  app.add_option("--every", arguments.choice.every, "Only each N-th of them")
      ->check(CLI::Range(1, sbox::app::kMost));
  app.add_option("--threads", arguments.run.threads,
                 "Maps and pairs in parallel, 0: one a core (default 1)")
      ->check(CLI::Range(0, sbox::app::kMost));
  app.add_option("--repeat", arguments.run.repeat, "Runs of each stage, for its time")
      ->check(CLI::Range(1, sbox::app::kMost));
  app.add_option("--answers", arguments.answers_file,
                 "Write the answers of the last method, one JSON object a line");
  app.add_option("--json", arguments.json_file, "Write every answer with its judgement");
  app.add_option("--wrong", arguments.wrong_folder,
                 "Write a picture of each wrong answer into this folder");
  app.add_option("--refused", arguments.refused_folder,
                 "Write a picture of each refused pair that has a truth into this folder");
  app.add_flag("--no-seconds", arguments.no_seconds,
               "Leave times out of these files, so that two runs compare byte by byte");
  app.add_flag(
      "--ratios", arguments.ratios,
      "Also time loading, fusing, saving and drawing, and print times as ratios to load, save\n"
      "and draw");
  app.add_flag("--fit-verdict", arguments.fit_verdict,
               "Fit the weights of the default method's verdict to the pairs and cross-validate");
  app.add_option("--weights", arguments.weights,
                 "Of the folders in that fit, in their order (default 1 each): folders that are\n"
                 "cuts of the same maps share one")
      ->check(CLI::Range(0.0, 1e6));
  app.add_flag("--refinement", arguments.refinement,
               "Compare the ways of refining the transform by their error over the floor");
  app.add_flag(
      "--sets", arguments.sets,
      "Merge all maps of each folder, and each set of its sets.json, in one call, and score "
      "the poses");
  app.add_flag("--markdown", arguments.markdown, "Print tables as Markdown");
}

void print(const Table& table, bool markdown) {
  std::printf("%s\n", toText(table, markdown).c_str());
  std::fflush(stdout);
}

/// Pictures of the answers with this outcome; nothing for an empty folder name.
void drawAnswers(const MethodRun& method_run, Outcome outcome, const std::string& folder_name) {
  if (folder_name.empty()) {
    return;
  }
  std::filesystem::create_directories(folder_name);
  for (const FolderAnswers& folder : method_run.folders) {
    for (size_t i = 0; i < folder.answers.size(); ++i) {
      if (folder.answers[i].outcome == outcome) {
        const AnnotatedPair& pair = folder.loaded->folder.pairs[i];
        std::string name = method_run.method + "-" + folder.loaded->folder.name + "-" + pair.a +
                           "-" + pair.b + ".png";
        std::replace(name.begin(), name.end(), '/', '_');
        writeOverlay((std::filesystem::path(folder_name) / name).string(), *folder.loaded, i,
                     folder.answers[i]);
      }
    }
  }
}

/// Every table of one method.
void printTables(const MethodRun& method_run, bool markdown) {
  print(scoreTable(method_run), markdown);
  print(timeTable(method_run), markdown);
  print(reliabilityTable(method_run), markdown);
  const Table errors = normalisedErrorTable(method_run);
  if (!errors.rows.empty()) {
    print(errors, markdown);
  }
}

void printFit(const std::vector<LoadedFolder>& folders, const Arguments& arguments) {
  std::vector<VerdictSample> samples;
  std::vector<std::string> names;
  for (const LoadedFolder& folder : folders) {
    const double weight = arguments.weights.empty() ? 1 : arguments.weights.at(names.size());
    const std::vector<VerdictSample> found =
        collectSamples(folder, names.size(), weight, arguments.run.threads);
    samples.insert(samples.end(), found.begin(), found.end());
    names.push_back(folder.folder.name);
  }
  const sbox::VerdictModel model = fitModel(samples);
  std::printf("weights:");
  for (const double weight : model.weights) {
    std::printf(" %.5g", weight);
  }
  std::printf("; none: %.5g\n\n", model.none);
  print(crossValidation(samples, names, sbox::VerdictOptions{}.accept_from), arguments.markdown);
}

std::vector<Method> chosenMethods(const Arguments& arguments) {
  std::vector<Method> methods;
  for (const std::string& name : arguments.methods) {
    methods.push_back(methodByName(name));
  }
  for (const std::string& settings : arguments.variants) {
    try {
      methods.push_back(methodWith(settings));
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error("--with " + settings + ": " + error.what());
    }
  }
  return methods;
}

void run(const Arguments& arguments) {
  if (!arguments.weights.empty() && arguments.weights.size() != arguments.folders.size()) {
    throw std::runtime_error("--weights needs one number for each folder");
  }
  if (arguments.sets) {
    std::vector<PairFolder> pair_folders;
    for (const std::string& folder : arguments.folders) {
      pair_folders.push_back(readPairFolder(folder));
    }
    print(setTable(pair_folders, arguments.run.threads), arguments.markdown);
    return;
  }
  const std::vector<Method> methods = chosenMethods(arguments);
  std::vector<LoadedFolder> folders;
  for (const std::string& folder : arguments.folders) {
    folders.push_back(loadFolder(readPairFolder(folder), arguments.choice, arguments.run.threads));
  }
  if (arguments.fit_verdict) {
    printFit(folders, arguments);
    return;
  }
  if (arguments.refinement) {
    print(refinementTable(folders, arguments.run.threads), arguments.markdown);
    return;
  }
  std::vector<MethodRun> runs;
  for (const Method& method : methods) {
    MethodRun method_run{method.name, {}};
    for (const LoadedFolder& folder : folders) {
      method_run.folders.push_back({&folder, runMethod(method, folder, arguments.run)});
    }
    printTables(method_run, arguments.markdown);
    if (arguments.ratios) {
      print(ratioTable(method_run, arguments.run.repeat), arguments.markdown);
    }
    drawAnswers(method_run, Outcome::Wrong, arguments.wrong_folder);
    drawAnswers(method_run, Outcome::Refused, arguments.refused_folder);
    runs.push_back(std::move(method_run));
  }
  if (runs.size() > 1) {
    print(comparisonTable(runs), arguments.markdown);
  }
  if (!arguments.answers_file.empty()) {
    writeText(arguments.answers_file, answerLines(runs.back(), !arguments.no_seconds));
  }
  if (!arguments.json_file.empty()) {
    writeText(arguments.json_file, answersJson(runs, !arguments.no_seconds));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Runs map-joining methods over folders of map pairs with known truth"};
  Arguments arguments;
  addOptions(app, arguments);
  app.final_callback([&arguments] {
    if (arguments.methods.empty() && arguments.variants.empty() && !arguments.sets &&
        !arguments.fit_verdict && !arguments.refinement) {
      throw CLI::RequiredError("--method, --with, --sets, --fit-verdict or --refinement");
    }
  });
  if (const auto exit_code = sbox::app::parseCommandLine(app, argc, argv)) {
    return *exit_code;
  }
  // Times are of one core, and sums do not depend on how work was split.
  cv::setNumThreads(1);
  // MRPT's aligner complains there, between the tables, which are printed by stdio.
  std::cout.setstate(std::ios::failbit);
  try {
    run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sbox-bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
