// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <pty.h>
#include <unistd.h>

#include <string>

#include "catch.h"
#include "sbox-merge/progress_line.h"

using sbox::app::ProgressLine;

namespace {

/// Takes the place of stderr while it lives.
class OtherStderr {
 public:
  explicit OtherStderr(int file) : kept_(dup(STDERR_FILENO)) { dup2(file, STDERR_FILENO); }
  ~OtherStderr() {
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  OtherStderr(const OtherStderr&) = delete;
  OtherStderr& operator=(const OtherStderr&) = delete;

 private:
  int kept_;
};

/// What lies ready to be read.
std::string readAll(int file) {
  fcntl(file, F_SETFL, O_NONBLOCK);
  std::string text(4096, '\0');
  const ssize_t count = read(file, text.data(), text.size());
  text.resize(count > 0 ? static_cast<size_t>(count) : 0);
  return text;
}

/// What a terminal shows of a line that is told of two parts and then goes.
std::string onTerminal(bool wanted, double patience) {
  int master = -1, slave = -1;
  REQUIRE(openpty(&master, &slave, nullptr, nullptr, nullptr) == 0);
  {
    const OtherStderr terminal(slave);
    ProgressLine line(wanted, patience);
    line.show("pairs", 1, 3);
    line.show("pairs", 2, 3);
  }
  const std::string text = readAll(master);
  close(master);
  close(slave);
  return text;
}

}  // namespace

TEST_CASE("a terminal shows how far the work is, not too often, and is left clean") {
  // The second part follows at once: the line is not drawn again for it.
  CHECK(onTerminal(true, 0) == "\r\033[Kpairs 1 of 3\r\033[K");
}

TEST_CASE("nothing shows of short work, nor where it is not wanted") {
  CHECK(onTerminal(true, 60).empty());
  CHECK(onTerminal(false, 0).empty());
}

TEST_CASE("nothing shows where stderr is no terminal") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  {
    const OtherStderr other(ends[1]);
    ProgressLine line(true, 0);
    line.show("pairs", 1, 3);
  }
  CHECK(readAll(ends[0]).empty());
  close(ends[0]);
  close(ends[1]);
}
