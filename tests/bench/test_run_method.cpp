// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.h"
#include "sbox-bench/run_method.h"
#include "sbox-bench/score_table.h"
#include "sbox-bench/text_file.h"
#include "sbox-bench/whole_command.h"
#include "sbox-bench/write_answers.h"
#include "sbox/io/save_map.h"
#include "test_folder.h"

using namespace sbox;
using namespace sbox::bench;

namespace {

/// Maps 0 to 3 as .yaml, map n with its corner at (n, 2n) turned by 0.1 n. Each pair's truth is
/// that all map frames are one, but pair "2 3" has nothing in common.
class Example {
 public:
  Example() : folder_("run_method") {
    for (int n = 0; n < 4; ++n) {
      Map map = makeMap("map", 6, 5, 0.1, corner(n));
      map.grid.setCell(n, 2, 0.01F);
      saveMap(map, folder_.path(std::to_string(n) + ".yaml"));
    }
    nlohmann::json pairs = nlohmann::json::array();
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) {
        pairs.push_back(pairJson(a, b));
      }
    }
    folder_.write("pairs.json", nlohmann::json{{"resolution", 0.05}, {"pairs", pairs}}.dump());
  }

  [[nodiscard]] LoadedFolder load(const PairChoice& choice = {}) const {
    return loadFolder(readPairFolder(folder_.path()), choice);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.path(name); }

 private:
  static Pose2D corner(int n) { return {1.0 * n, 2.0 * n, 0.1 * n}; }

  static nlohmann::json pairJson(int a, int b) {
    nlohmann::json pair{{"env", a == 0 ? "first" : "rest"},
                        {"a", std::to_string(a)},
                        {"b", std::to_string(b)},
                        {"negative", a == 2}};
    const Pose2D truth = cornerTransform({}, corner(a), corner(b));
    pair["theta_deg"] = truth.phi * 180 / M_PI;
    pair["t_cells"] = {truth.x / 0.05, truth.y / 0.05};
    pair["rms_cells"] = 0;
    for (const Point2D& p : {Point2D(0, 0), Point2D(4, 7)}) {
      const Point2D q = truth.composePoint(p);
      pair["pa"].push_back({p.x / 0.05, p.y / 0.05});
      pair["pb"].push_back({q.x / 0.05, q.y / 0.05});
    }
    return pair;
  }

  TestFolder folder_;
};

/// Remembers the place of the map's one wall and answers with a pose made of two of them.
Method fakeMethod(double wrong_from_x) {
  return makeMethod(
      "fake", [](const Map& map) { return map.corner_in_map; },
      [wrong_from_x](const Pose2D& a, const Pose2D& b) {
        PairResult result;
        result.has_pose = true;
        result.verdict = b.x - a.x > 2 ? Verdict::Ambiguous : Verdict::Accepted;
        result.reason = "told to";
        result.confidence = 0.5;
        result.pose_b_in_a = {b.x >= wrong_from_x ? 10.0 : 0.0, 0, 0};
        result.alternatives.push_back({{}, 0.1});
        result.covariance = PoseCovariance::Identity() * 0.01;
        return result;
      });
}

}  // namespace

TEST_CASE("answers are judged through the maps' own corners", "[bench][run_method]") {
  const Example example;
  const LoadedFolder loaded = example.load();
  REQUIRE(loaded.folder.pairs.size() == 6);
  REQUIRE(loaded.maps.size() == 4);
  // Pairs 01 02 03 12 13 23; wrong poses into map 3.
  const std::vector<Answer> answers = runMethod(fakeMethod(3), loaded);
  const Outcome expected[] = {Outcome::Right, Outcome::Right, Outcome::Refused,
                              Outcome::Right, Outcome::Wrong, Outcome::Wrong};
  for (size_t i = 0; i < answers.size(); ++i) {
    CHECK(answers[i].outcome == expected[i]);
  }
  CHECK(answers[0].error->excess_cells == Approx(0).margin(1e-6));
  CHECK(answers[0].normalised_error->of_answer == Approx(0).margin(1e-9));
  CHECK(answers[4].error->excess_cells == Approx(200));
  CHECK(answers[4].normalised_error->of_answer == Approx(10000));
  CHECK_FALSE(answers[4].poseRight());
  CHECK(answers[4].candidate_right);
  CHECK_FALSE(answers[5].error.has_value());

  const MethodRun run{"fake", {{&loaded, answers}}};
  const std::vector<Group> groups = groupAnswers(run);
  REQUIRE(groups.size() == 3);
  CHECK(groups[0].name == "sbox_test_run_method first");
  CHECK(groups[2].name == "sbox_test_run_method all");
  const Score all = score(groups[2]);
  CHECK(all.pairs == 6);
  CHECK(all.right == 3);
  CHECK(all.wrong == 2);
  CHECK(all.refused == 1);
  CHECK(all.right_if_answered == 3);
  CHECK(all.right_candidate == 5);
  CHECK(all.excess_cells == Approx(0).margin(1e-6));
}

TEST_CASE("neither threads nor repeats change what is written", "[bench][run_method]") {
  const Example example;
  const LoadedFolder loaded = example.load();
  const auto written = [&](int threads, int repeat) {
    RunOptions options;
    options.threads = threads;
    options.repeat = repeat;
    const MethodRun run{"fake", {{&loaded, runMethod(fakeMethod(3), loaded, options)}}};
    return answerLines(run, false) + answersJson({run}, false);
  };
  CHECK(written(1, 1) == written(4, 1));
  CHECK(written(1, 1) == written(1, 3));
}

TEST_CASE("pairs are chosen by text, then by number", "[bench][run_method]") {
  const Example example;
  const LoadedFolder loaded = example.load({" rest ", 2});
  REQUIRE(loaded.folder.pairs.size() == 2);
  CHECK(loaded.folder.pairs[0].a + loaded.folder.pairs[0].b == "12");
  CHECK(loaded.folder.pairs[1].a + loaded.folder.pairs[1].b == "23");
  CHECK(loaded.maps.size() == 3);
}

TEST_CASE("times are told as ratios to loading, saving and drawing", "[bench][whole_command]") {
  const Example example;
  const auto ratios = [&](const std::string& only) {
    const LoadedFolder loaded = example.load({only, 1});
    const MethodRun run{"fake", {{&loaded, runMethod(fakeMethod(9), loaded)}}};
    return ratioTable(run, 1).rows;
  };
  const auto merged = ratios("0 1");
  REQUIRE(merged.size() == 8);
  const auto ratio = [&](size_t row) { return std::stod(merged[row][3]); };
  // Numbers are rounded to a hundredth.
  CHECK(ratio(0) + ratio(1) + ratio(2) == Approx(1).margin(0.016));
  CHECK(merged[6][0] == "all of these");
  CHECK(ratio(6) == Approx(1 + ratio(3) + ratio(4) + ratio(5)).margin(0.021));
  // Of what is refused no map is written.
  for (const auto& row : ratios("0 3")) {
    CHECK(row[3] == "-");
  }
}

TEST_CASE("answer lines carry the transform between corners", "[bench][run_method]") {
  const Example example;
  const LoadedFolder loaded = example.load();
  const MethodRun run{"fake", {{&loaded, runMethod(fakeMethod(9), loaded)}}};
  std::istringstream lines(answerLines(run, true));
  std::string line;
  for (const AnnotatedPair& pair : loaded.folder.pairs) {
    REQUIRE(std::getline(lines, line));
    const nlohmann::json answer = nlohmann::json::parse(line);
    CHECK(answer.at("a").get<std::string>() == pair.a);
    CHECK(answer.at("b").get<std::string>() == pair.b);
    CHECK(answer.at("accepted").get<bool>() == !(pair.a == "0" && pair.b == "3"));
    if (!pair.negative) {
      CHECK(answer.at("theta_deg").get<double>() == Approx(pair.theta_deg));
      CHECK(answer.at("x").get<double>() == Approx(pair.offset.x * 0.05));
      CHECK(answer.at("y").get<double>() == Approx(pair.offset.y * 0.05));
    }
    CHECK(answer.at("seconds").get<double>() >= 0);
  }
}

TEST_CASE("a file that cannot be written is named", "[bench][run_method]") {
  const Example example;
  std::string message;
  try {
    writeText(example.file("no/such/folder"), "text");
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  CHECK(message == example.file("no/such/folder") + ": cannot be written");
}
