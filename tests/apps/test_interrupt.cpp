// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Signals at any moment: no output is ever half written, and only a signal that cannot be caught
// leaves temporary files.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "apps/command.h"
#include "apps/office.h"
#include "catch.h"
#include "sbox/io/image_file.h"
#include "sbox/io/load_map.h"
#include "sbox/io/save_map.h"

using namespace sbox;
using namespace sbox::test;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

namespace {

const std::string precious = "precious";
const Words outputs{"merged.gridmap", "merged.png", "r.html", "r.json"};
const Words inputs{"a.gridmap", "b.gridmap"};

/// A folder with two parts of one floor, and something in the place of each output.
struct Scene {
  ScratchFolder folder;

  Scene() {
    const Map floor = office("floor", 1);
    saveMap(cutColumns(floor, "a", 0, 400, {}), folder / inputs[0]);
    saveMap(cutColumns(floor, "b", 60, 480, {}), folder / inputs[1]);
    for (const std::string& output : outputs) {
      std::ofstream(folder / output) << precious;
    }
  }

  [[nodiscard]] pid_t start() const {
    const pid_t child = fork();
    if (child == 0) {
      const int nowhere = open("/dev/null", O_RDWR);
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        dup2(nowhere, stream);
      }
      if (chdir(folder.path().c_str()) == 0) {
        execl(SBOX_MERGE_COMMAND, "sbox-merge", "--in", "a.gridmap", "b.gridmap", "--report",
              "r.json", "--html", "r.html", "--pictures", "pictures", nullptr);
      }
      _exit(127);
    }
    return child;
  }
};

bool isNew(const ScratchFolder& folder, const std::string& output) {
  return contents(folder / output) != precious;
}

/// Throws, or finds a fault, where an output is neither the old one nor a whole new one.
void checkWhole(const ScratchFolder& folder) {
  if (isNew(folder, "merged.gridmap")) {
    CHECK(loadMap(folder / "merged.gridmap").width() > 400);
  }
  if (isNew(folder, "merged.png")) {
    CHECK(loadImage(folder / "merged.png").width > 400);
  }
  if (isNew(folder, "r.json")) {
    CHECK(nlohmann::json::parse(contents(folder / "r.json"))["version"] == 1);
  }
  if (isNew(folder, "r.html")) {
    const std::string page = contents(folder / "r.html");
    CHECK(page.substr(page.size() - 8) == "</html>\n");
  }
  if (fs::exists(folder / "pictures")) {
    for (const std::string& picture : listing(folder / "pictures")) {
      if (picture[0] != '.') {
        CHECK(loadImage(folder / "pictures" / picture).width > 400);
      }
    }
  }
}

double secondsOf(const Scene& scene) {
  const auto begin = std::chrono::steady_clock::now();
  int status = 0;
  waitpid(scene.start(), &status, 0);
  REQUIRE(status == 0);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Starts the command and sends the signal at a moment anywhere in its running time. Returns what
/// waitpid says.
int interrupted(const Scene& scene, int signal, double after) {
  const pid_t child = scene.start();
  std::this_thread::sleep_for(std::chrono::duration<double>(after));
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

constexpr int tries = 8;

/// From 0 to 1.
double anyShare(std::mt19937& random) { return static_cast<double>(random() % 1000) / 1000; }

}  // namespace

TEST_CASE("an interrupt at any moment leaves all outputs as they were, or all new") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const double seconds = secondsOf(Scene());
  std::mt19937 random(static_cast<unsigned>(signal));
  for (int i = 0; i < tries; ++i) {
    const Scene scene;
    const double after = seconds * (i + anyShare(random)) / tries;
    INFO("signal " << signal << " after " << after << " of " << seconds << " s");
    const int status = interrupted(scene, signal, after);
    // Before the command has begun to listen, the signal itself ends it.
    const bool stopped = (WIFEXITED(status) && WEXITSTATUS(status) == 128 + signal) ||
                         (WIFSIGNALED(status) && WTERMSIG(status) == signal);
    CHECK((stopped || status == 0));
    const auto written = std::count_if(outputs.begin(), outputs.end(), [&](const auto& output) {
      return isNew(scene.folder, output);
    });
    CHECK(written == (stopped ? 0 : static_cast<int>(outputs.size())));
    CHECK(fs::exists(scene.folder / "pictures") == !stopped);
    Words expected = outputs;
    expected.insert(expected.end(), inputs.begin(), inputs.end());
    if (!stopped) {
      expected.emplace_back("pictures");
    }
    std::sort(expected.begin(), expected.end());
    CHECK(listing(scene.folder.path()) == expected);
    checkWhole(scene.folder);
  }
}

TEST_CASE("a kill at any moment leaves no half of a file under an output's name") {
  const double seconds = secondsOf(Scene());
  std::mt19937 random(9);
  for (int i = 0; i < tries * 3 / 2; ++i) {
    const Scene scene;
    // Mostly while it writes, which is the last part.
    const double share = i % 2 == 0 ? anyShare(random) : 0.7 + 0.4 * anyShare(random);
    INFO("killed after " << share << " of " << seconds << " s");
    (void)interrupted(scene, SIGKILL, seconds * share);
    for (const std::string& name : listing(scene.folder.path())) {
      const bool known = name == "pictures" || name.rfind(".sbox-", 0) == 0 ||
                         std::find(outputs.begin(), outputs.end(), name) != outputs.end() ||
                         std::find(inputs.begin(), inputs.end(), name) != inputs.end();
      INFO(name);
      CHECK(known);
    }
    checkWhole(scene.folder);
  }
}

TEST_CASE("signals that the caller ignores stay ignored") {
  const Scene scene;
  struct sigaction ignore {
  }, before{};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGHUP, &ignore, &before);
  const pid_t child = scene.start();
  sigaction(SIGHUP, &before, nullptr);
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    kill(child, SIGHUP);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK(status == 0);
  CHECK(isNew(scene.folder, "merged.gridmap"));
}
