// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pthread.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.h"
#include "sbox/core/parallel.h"

using namespace sbox;

namespace {

/// While it lives, the system refuses to start threads: their stacks would not fit anywhere.
class NoNewThreads {
 public:
  NoNewThreads() {
    pthread_attr_t attributes;
    pthread_getattr_default_np(&attributes);
    pthread_attr_getstacksize(&attributes, &usual_stack_);
    pthread_attr_destroy(&attributes);
    setStack(size_t{1} << 60);
  }
  NoNewThreads(const NoNewThreads&) = delete;
  NoNewThreads& operator=(const NoNewThreads&) = delete;
  ~NoNewThreads() { setStack(usual_stack_); }

 private:
  static void setStack(size_t bytes) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, bytes);
    pthread_setattr_default_np(&attributes);
    pthread_attr_destroy(&attributes);
  }
  size_t usual_stack_ = 0;
};

/// How often each of ten tasks was called.
std::vector<int> callsOf(int threads) {
  std::vector<int> calls(10, 0);
  parallelFor(10, threads, [&](int i) { ++calls[static_cast<size_t>(i)]; });
  return calls;
}

}  // namespace

TEST_CASE("each task is called once on any number of threads", "[core]") {
  for (const int threads : {0, 1, 3, 50}) {
    CHECK(callsOf(threads) == std::vector<int>(10, 1));
  }
  parallelFor(0, 4, [](int) { FAIL("there is no task"); });
}

TEST_CASE("of several exceptions that of the lowest task is thrown, after all tasks", "[core]") {
  std::vector<int> calls(10, 0);
  std::string thrown;
  try {
    parallelFor(10, 3, [&](int i) {
      ++calls[static_cast<size_t>(i)];
      if (i == 4 || i == 7) {
        throw std::runtime_error(std::to_string(i));
      }
    });
  } catch (const std::runtime_error& error) {
    thrown = error.what();
  }
  CHECK(thrown == "4");
  CHECK(calls == std::vector<int>(10, 1));
}

TEST_CASE("where no more threads can be started the work is done on those there are", "[core]") {
  const NoNewThreads none;
  CHECK(callsOf(4) == std::vector<int>(10, 1));
}
