// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/write_outputs.h"

#include <filesystem>

#include "sbox-merge/interrupt.h"
#include "sbox-merge/output_names.h"
#include "sbox/core/parallel.h"
#include "sbox/core/stopwatch.h"
#include "sbox/io/file_error.h"
#include "sbox/io/load_map.h"
#include "sbox/io/output_files.h"
#include "sbox/io/path_extension.h"
#include "sbox/io/save_map.h"
#include "sbox/io/share_file.h"
#include "sbox/io/simplemap_file.h"
#include "sbox/report/graph_text.h"
#include "sbox/report/pictures.h"
#include "sbox/report/report_html.h"
#include "sbox/report/report_json.h"
#include "sbox/report/tf_text.h"

namespace sbox::app {
namespace fs = std::filesystem;
namespace {

/// An output in the place of a file that is read would destroy what cannot be had again.
void protectInputs(const Arguments& arguments, OutputFiles& files) {
  const std::string advice = "; name another output";
  for (const std::string& input : arguments.inputs) {
    for (const std::string& file : filesRead(input)) {
      std::string reason = file == input ? "is an input" : "is the image of the input " + input;
      files.protect(file, reason.append(advice));
    }
  }
  for (const std::string& file : arguments.joined) {
    files.protect(file, "is an input of --join" + advice);
  }
  for (const std::string& file : arguments.settings) {
    files.protect(file, "is a file of settings that is read" + advice);
  }
}

std::string tfText(const MergeResult& result, const std::string& file) {
  return isYamlPath(file) ? tfYaml(result) : tfScript(result);
}

void stageKeyFrames(OutputFiles& files, const std::string& target, const KeyFrames& key_frames) {
  files.write(target, [&](const std::string& temporary) { saveKeyFrames(key_frames, temporary); });
  checkInterrupt();
}

void stageMergedKeyFrames(OutputFiles& files, const std::vector<KeyFrames>& group_key_frames,
                          const MergeResult& result, const std::string& output) {
  const std::vector<std::string> names = mergedFileNames(result, output);
  for (size_t i = 0; i < names.size(); ++i) {
    stageKeyFrames(files, names[i], group_key_frames[i]);
  }
}

/// What SLAM took long to make is kept, whether or not the maps could be merged.
void stageSlamMaps(OutputFiles& files, const Inputs& inputs, const Arguments& arguments) {
  const std::vector<std::string> stems = slamMapStems(arguments.inputs, arguments.output);
  for (size_t i = 0; i < stems.size(); ++i) {
    if (!stems[i].empty()) {
      saveMap(inputs.maps[i], stems[i] + ".gridmap", files);
      saveMap(inputs.maps[i], stems[i] + ".png", files);
      stageKeyFrames(files, stems[i] + ".simplemap", inputs.key_frames[i]);
    }
  }
}

/// Each merged map and the picture beside it.
void stageMergedMaps(OutputFiles& files, const std::vector<std::string>& map_files,
                     const Arguments& arguments, const MergeResult& result,
                     const ProgressFunction& tell) {
  const int count = 2 * static_cast<int>(map_files.size());
  StageProgress progress(tell, "maps written", count);
  parallelFor(count, arguments.merge.threads, [&](int i) {
    progress.partBegins();
    const auto group = static_cast<size_t>(i / 2);
    const std::string& file = map_files[group];
    saveMap(result.merged[group].map, i % 2 == 0 ? file : pictureBeside(file), files);
    progress.partDone();
  });
}

void stagePictures(OutputFiles& files, const std::vector<std::string>& map_files,
                   const std::vector<Map>& maps, const Arguments& arguments,
                   const MergeResult& result, const ProgressFunction& tell) {
  for (const Picture& picture : drawPictures(maps, result, arguments.merge.threads, tell)) {
    files.writeBytes(pictureInFolder(arguments.pictures, picture.file_name, map_files),
                     picture.png);
    checkInterrupt();
  }
}

/// As transforms of ROS and as a graph, where asked for.
void stagePoses(OutputFiles& files, const Arguments& arguments, const MergeResult& result) {
  if (!arguments.tf.empty() && !result.merged.empty()) {
    files.writeBytes(arguments.tf, tfText(result, arguments.tf));
  }
  if (!arguments.graph.empty()) {
    const std::vector<std::string> names = mergedFileNames(result, arguments.graph);
    for (size_t i = 0; i < names.size(); ++i) {
      files.writeBytes(names[i], graphText(result, result.merged[i]));
    }
  }
}

/// Folders that go again, if they are empty, unless keep() is called.
class NewFolder {
 public:
  explicit NewFolder(const std::string& path) {
    std::error_code error;
    for (fs::path missing = path; !missing.empty() && !fs::exists(missing, error);
         missing = missing.parent_path()) {
      made_.push_back(missing);
    }
    fs::create_directories(path, error);
    if (error || !fs::is_directory(path)) {
      throw FileError(path, "cannot be made a folder for the pictures: " +
                                (error ? error.message() : "it is a file"));
    }
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  ~NewFolder() {
    std::error_code ignored;
    for (const fs::path& folder : made_) {
      fs::remove(folder, ignored);
    }
  }
  void keep() { made_.clear(); }

 private:
  std::vector<fs::path> made_;  ///< The innermost first.
};

}  // namespace

std::vector<std::string> outputsOfMerge(const Arguments& arguments) {
  std::vector<std::string> files = filesOfMap(arguments.output);
  files.push_back(pictureBeside(arguments.output));
  for (const std::string& file : {arguments.tf, arguments.simplemap, arguments.graph}) {
    if (!file.empty()) {
      files.push_back(file);
    }
  }
  return files;
}

void checkOutputs(const Arguments& arguments) {
  OutputFiles trial;
  protectInputs(arguments, trial);
  if (arguments.share) {
    (void)trial.stage(arguments.report);
    return;
  }
  for (const std::string& file : outputsOfMerge(arguments)) {
    (void)trial.stage(file);
  }
  for (const std::string& file : {arguments.report, arguments.html}) {
    if (!file.empty()) {
      (void)trial.stage(file);
    }
  }
  for (const std::string& stem : slamMapStems(arguments.inputs, arguments.output)) {
    for (const char* extension : {".gridmap", ".png", ".simplemap"}) {
      if (!stem.empty()) {
        (void)trial.stage(stem + extension);
      }
    }
  }
  std::error_code ignored;
  if (!arguments.pictures.empty() && fs::exists(arguments.pictures, ignored)) {
    if (!fs::is_directory(arguments.pictures, ignored)) {
      throw FileError(arguments.pictures, "cannot hold pictures: it is not a folder");
    }
    (void)trial.stage((fs::path(arguments.pictures) / "features.png").string());
  }
}

std::vector<std::string> writeOutputs(const Inputs& inputs,
                                      const std::vector<KeyFrames>& group_key_frames,
                                      const Arguments& arguments, MergeResult& result,
                                      double seconds_before, const ProgressFunction& tell) {
  const Stopwatch stopwatch;
  std::vector<std::string> map_files = mergedFileNames(result, arguments.output);
  std::optional<NewFolder> folder;
  if (!arguments.pictures.empty()) {
    folder.emplace(arguments.pictures);
  }
  OutputFiles files;
  protectInputs(arguments, files);
  stageMergedMaps(files, map_files, arguments, result, tell);
  stageSlamMaps(files, inputs, arguments);
  if (!arguments.simplemap.empty()) {
    stageMergedKeyFrames(files, group_key_frames, result, arguments.simplemap);
  }
  if (folder) {
    stagePictures(files, map_files, inputs.maps, arguments, result, tell);
  }
  stagePoses(files, arguments, result);
  if (!arguments.html.empty()) {
    files.writeBytes(arguments.html,
                     reportHtml(inputs.maps, result, map_files, arguments.merge.threads, tell));
  }
  result.seconds.save = stopwatch.seconds();
  result.seconds.total = seconds_before + result.seconds.save;
  if (!arguments.report.empty()) {
    files.writeBytes(arguments.report, reportJson(result, map_files));
  }
  checkInterrupt();
  files.commit();
  if (folder) {
    folder->keep();
  }
  return map_files;
}

void writeShare(const MatchedShare& share, const Arguments& arguments) {
  OutputFiles files;
  files.writeBytes(arguments.report, shareJson(share, arguments.inputs));
  checkInterrupt();
  files.commit();
}

}  // namespace sbox::app
