// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox-merge/trial_reading.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <new>

#include "sbox/io/file_error.h"
#include "sbox/io/unpacked_size.h"

namespace sbox::app {
namespace {

/// The program's own address space, bytes; 0 if the system does not tell.
std::uint64_t usedMemory() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// Lets this process take so much more memory than it has; what asks for more gets a
/// std::bad_alloc.
void limitMemory(std::uint64_t more) {
  rlimit limit{};
  const std::uint64_t used = usedMemory();
  if (used > 0 && getrlimit(RLIMIT_AS, &limit) == 0 && used + more < limit.rlim_cur) {
    limit.rlim_cur = used + more;
    setrlimit(RLIMIT_AS, &limit);
  }
}

/// Reads and ends the process: 0, whatever was thrown. Only a FileError's reason is told, to `out`.
[[noreturn]] void readElsewhere(const std::function<void()>& read, std::uint64_t memory, int out) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  limitMemory(memory);
  const auto tell = [out](const std::string& text) {
    const ssize_t written = write(out, text.data(), text.size());
    _exit(written == static_cast<ssize_t>(text.size()) ? 0 : 1);
  };
  try {
    read();
  } catch (const FileError& error) {
    tell(error.reason());
  } catch (const std::bad_alloc&) {
    tell(no_memory);
  } catch (...) {
    // Told when the work is done in earnest.
  }
  _exit(0);
}

/// All that comes through a pipe until its other end is closed.
std::string readToEnd(int in) {
  std::string text;
  std::array<char, 512> piece{};
  for (;;) {
    const ssize_t count = read(in, piece.data(), piece.size());
    if (count > 0) {
      text.append(piece.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || errno != EINTR) {
      return text;
    }
  }
}

/// Whether a process ends by itself with 0.
bool endsWell(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) {
      return true;
    }
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

void tryReading(const std::string& path, std::uint64_t memory, const std::function<void()>& read) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return;
  }
  const auto [in, out] = ends;
  const pid_t process = fork();
  if (process == 0) {
    readElsewhere(read, memory, out);
  }
  close(out);
  const std::string reason = process < 0 ? "" : readToEnd(in);
  close(in);
  if (process > 0 && !endsWell(process)) {
    throw FileError(path, "is damaged: MRPT cannot read it");
  }
  if (!reason.empty()) {
    throw FileError(path, reason);
  }
}

void tryReading(const std::string& path, const std::function<void()>& read) {
  // MRPT's objects take several times the room that they take in a file.
  constexpr std::uint64_t least = 256U << 20U, per_byte = 16;
  tryReading(path, least + per_byte * unpackedSize(path), read);
}

}  // namespace sbox::app
