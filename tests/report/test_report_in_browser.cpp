// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The page in a real browser, where there is one: does it show and do what it says?
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "catch.h"
#include "io/scratch_folder.h"
#include "report/html_result.h"
#include "sbox/report/report_html.h"

using namespace sbox;
using namespace sbox::test;
using nlohmann::json;

namespace {

/// Chromium without a window, in a profile of its own.
class Browser {
 public:
  Browser() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      if (std::system((std::string("command -v ") + name + " >/dev/null").c_str()) == 0) {
        name_ = name;
        return;
      }
    }
  }
  [[nodiscard]] bool found() const { return !name_.empty(); }

  /// Opens the page and returns what the browser prints.
  std::string open(const ScratchFolder& folder, const std::string& page,
                   const std::string& options) const {
    const std::string line =
        "timeout 120 " + name_ +
        " --headless --no-sandbox --disable-gpu --disable-background-networking "
        "--hide-scrollbars --window-size=1200,6000 --user-data-dir='" +
        folder.path("profile") + "' " + options + " 'file://" + page + "' >'" +
        folder.path("printed") + "' 2>/dev/null </dev/null";
    CHECK(std::system(line.c_str()) == 0);
    return folder.read("printed");
  }

 private:
  std::string name_;
};

/// What the page must do, tried by a script that writes the outcome into the page.
constexpr const char* trial = R"js(
<script>
const failures = [];
window.addEventListener('error', (event) => failures.push(event.message));
document.addEventListener('securitypolicyviolation', (event) => failures.push(event.blockedURI));
window.addEventListener('load', () => {
  const outcome = {};
  const pair = document.querySelector('#pair-0-1');
  const stage = pair.querySelector('.stage').getBoundingClientRect();
  const share = (selector) => {
    const box = pair.querySelector(selector).getBoundingClientRect();
    return [(box.left - stage.left) / stage.width, (stage.bottom - box.bottom) / stage.height,
            box.width / stage.width, box.height / stage.height];
  };
  outcome.a = share('.layer.wall-a');
  outcome.b = share('.layer.wall-b');
  const style = (selector) => getComputedStyle(pair.querySelector(selector));
  const seen = () => ['.layer.wall-a', '.layer.wall-b', '.layer.free-a', '.layer.free-b',
      '.layer.wall-both', '.layer.wall-conflict'].map(
          (layer) => style(layer).visibility === 'visible' ? 1 : 0).join('');
  outcome.seen = { all: seen() };
  for (const box of pair.querySelectorAll('[data-toggles]')) {
    box.click();
    outcome.seen[box.dataset.toggles] = seen();
    box.click();
  }
  outcome.again = seen();
  const fade = pair.querySelector('[data-fade]');
  outcome.fade = [];
  for (const value of [0, 25, 50, 100]) {
    fade.value = value;
    fade.dispatchEvent(new Event('input'));
    outcome.fade.push([+style('.layer.wall-a').opacity, +style('.layer.wall-b').opacity,
                       +style('.layer.wall-both').opacity]);
  }
  const ground = () => getComputedStyle(document.body).backgroundColor;
  outcome.grounds = [ground()];
  document.getElementById('theme').click();
  outcome.grounds.push(ground());
  pair.querySelector('[data-zoom=in]').click();
  outcome.zoomed = style('.world').transform;
  pair.querySelector('[data-zoom=reset]').click();
  outcome.whole = style('.world').transform;
  outcome.fetched = performance.getEntriesByType('resource').length;
  outcome.failures = failures;
  const result = document.createElement('pre');
  result.id = 'outcome';
  result.textContent = '[[' + JSON.stringify(outcome) + ']]';
  document.body.append(result);
});
</script>
)js";

std::vector<double> numbers(const json& list) { return list.get<std::vector<double>>(); }

void checkClose(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  for (size_t i = 0; i < values.size(); ++i) {
    CHECK(values[i] == Approx(expected[i]).margin(0.004));
  }
}

int pixelsNear(const cv::Mat& picture, const cv::Scalar& colour) {
  cv::Mat near;
  cv::inRange(picture, colour - cv::Scalar::all(6), colour + cv::Scalar::all(6), near);
  return cv::countNonZero(near);
}

}  // namespace

TEST_CASE("a page shows and does in a browser what it says", "[browser]") {
  const Browser browser;
  if (!browser.found()) {
    WARN("skipped: there is no Chromium here");
    return;
  }
  const ScratchFolder folder;
  const HtmlCase made = htmlCase();
  const std::string text = reportHtml(made.maps, made.result, {"merged.yaml"});
  const std::string page = folder.write("page.html", text + trial);
  const std::string printed = browser.open(folder, page, "--dump-dom");
  const size_t first = printed.find("[[{"), last = printed.find("}]]");
  REQUIRE(first != std::string::npos);
  REQUIRE(last != std::string::npos);
  const json outcome = json::parse(printed.substr(first + 2, last - first - 1));
  CHECK(outcome["failures"] == json::array());
  CHECK(outcome["fetched"] == 0);

  // Both maps cover the 6 m x 4 m of map a; the outermost half cells are beyond what is drawn, and
  // a margin of 2 % of the longer side surrounds map and stage alike.
  const double margin = 0.12, width = 6 + 2 * margin, height = 4 + 2 * margin;
  checkClose(numbers(outcome["a"]), {0, 0, 1, 1});
  checkClose(numbers(outcome["b"]), {0, 0, width / width, height / height});

  CHECK(outcome["seen"] == json({{"all", "111111"},
                                 {"a", "010111"},
                                 {"b", "101011"},
                                 {"free", "110011"},
                                 {"walls", "111101"},
                                 {"conflicts", "111110"}}));
  CHECK(outcome["again"] == "111111");
  CHECK(outcome["fade"] == json({{1, 0, 0}, {1, 0.5, 0.5}, {1, 1, 1}, {0, 1, 0}}));
  CHECK(outcome["grounds"][0] != outcome["grounds"][1]);
  CHECK(outcome["zoomed"].get<std::string>().rfind("matrix(1.5, 0, 0, 1.5", 0) == 0);
  CHECK(outcome["whole"] == "matrix(1, 0, 0, 1, 0, 0)");
}

TEST_CASE("a page paints its layers in light and in dark", "[browser]") {
  const Browser browser;
  if (!browser.found()) {
    WARN("skipped: there is no Chromium here");
    return;
  }
  const ScratchFolder folder;
  const HtmlCase made = htmlCase();
  const std::string page =
      folder.write("page.html", reportHtml(made.maps, made.result, {"merged.yaml"}));
  struct Theme {
    std::string option;
    cv::Scalar ground, wall_a, wall_both, conflict;  // blue, green, red
  };
  const std::vector<Theme> themes{
      {"1", {255, 255, 255}, {178, 114, 0}, {40, 34, 30}, {127, 0, 208}},
      {"0", {29, 25, 22}, {233, 180, 86}, {248, 246, 244}, {180, 95, 255}}};
  for (const Theme& theme : themes) {
    INFO("preferred colour scheme " << theme.option);
    const std::string shot = folder.path("shot.png");
    browser.open(
        folder, page,
        "--blink-settings=preferredColorScheme=" + theme.option + " --screenshot='" + shot + "'");
    const cv::Mat picture = cv::imread(shot, cv::IMREAD_COLOR);
    REQUIRE(!picture.empty());
    CHECK(pixelsNear(picture, theme.ground) > 100000);
    // More than the swatches show.
    const int swatches = 3000;
    CHECK(pixelsNear(picture, theme.wall_a) > swatches);
    CHECK(pixelsNear(picture, theme.wall_both) > swatches);
    CHECK(pixelsNear(picture, theme.conflict) > swatches);
  }
}
