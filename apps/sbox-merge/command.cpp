// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/command.h"

#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "sbox-merge/arguments.h"
#include "sbox-merge/interrupt.h"
#include "sbox-merge/run.h"

namespace sbox::app {
namespace {

constexpr int unusable_file = 1;
constexpr int wrong_usage = 2;

int fail(const std::string& reason, int exit_code) {
  // Some libraries say more than one line.
  std::cerr << "sbox-merge: " << reason.substr(0, reason.find('\n')) << "\n";
  return exit_code;
}

}  // namespace

int command(int argc, const char* const* argv, const RunSlams& run_slams) {
  try {
    const auto arguments = parseArguments(argc, argv);
    if (!arguments) {
      return 0;
    }
    noteInterrupts();
    return run(*arguments, run_slams);
  } catch (const UsageError& error) {
    return fail(std::string(error.what()) + " (see sbox-merge --help)", wrong_usage);
  } catch (const Interrupted& error) {
    return fail(error.what(), error.exitCode());
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for maps this large", unusable_file);
  } catch (const std::exception& error) {
    return fail(error.what(), unusable_file);
  }
}

}  // namespace sbox::app
