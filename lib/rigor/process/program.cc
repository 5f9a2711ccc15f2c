// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/program.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <rigor/process/descriptor.h>
#include <rigor/process/spawn.h>

namespace rigor::process {
namespace {

using ProgramEnd = ProgramResult::End;

/// Above the numbers that a program's own descriptors get, so that none is in the way of another.
int above_standard(int descriptor) {
  if (descriptor < 0 || descriptor > STDERR_FILENO) return descriptor;
  const Descriptor low(descriptor);
  return ::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
}

/// A pipe that nobody else inherits; without one, its numbers are negative.
struct ProgramPipe {
  ProgramPipe() {
    std::array<int, 2> ends = {-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    reading = Descriptor(above_standard(ends[0]));
    writing = Descriptor(above_standard(ends[1]));
  }
  bool open() const { return reading.number() >= 0 && writing.number() >= 0; }

  Descriptor reading{-1};
  Descriptor writing{-1};
};

/// Takes what both pipes give until they are closed, or a limit is passed.
class ProgramOutput {
 public:
  explicit ProgramOutput(const ProgramLimits& limits)
      : limits_(limits),
        end_(std::chrono::steady_clock::now() + std::chrono::seconds(limits.wall_seconds)) {}

  /// How it has to be ended; nothing when it ends by itself.
  std::optional<ProgramEnd> read(int out, int err, ProgramResult& result) const {
    std::array<pollfd, 2> pipes{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
    const std::array<std::string*, 2> texts{&result.out, &result.err};
    while (pipes[0].fd >= 0 || pipes[1].fd >= 0) {
      if (milliseconds_left() == 0) return ProgramEnd::kOutOfTime;
      if (::poll(pipes.data(), pipes.size(), milliseconds_left()) < 0) continue;
      for (std::size_t i = 0; i < pipes.size(); ++i) {
        if (pipes[i].fd < 0 || pipes[i].revents == 0) continue;
        if (!take(pipes[i].fd, *texts[i])) pipes[i].fd = -1;
        if (texts[i]->size() > limits_.output_bytes) return ProgramEnd::kTooMuchOutput;
      }
    }
    return std::nullopt;
  }

  /// The same of one that has closed its pipes. pidfd_open(2): without it, there is no limit here.
  std::optional<ProgramEnd> wait_for(pid_t pid) const {
    const Descriptor program(static_cast<int>(::syscall(SYS_pidfd_open, pid, 0)));
    pollfd gone{program.number(), POLLIN, 0};
    while (gone.fd >= 0 && gone.revents == 0) {
      if (milliseconds_left() == 0) return ProgramEnd::kOutOfTime;
      ::poll(&gone, 1, milliseconds_left());
    }
    return std::nullopt;
  }

 private:
  /// False at the end.
  static bool take(int descriptor, std::string& text) {
    std::array<char, 1U << 16U> chunk;  // a pipe holds as much
    const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) return true;
    if (got <= 0) return false;
    text.append(chunk.data(), static_cast<std::size_t>(got));
    return true;
  }

  int milliseconds_left() const {
    const auto left = end_ - std::chrono::steady_clock::now();
    return std::max(0,
                    static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(left).count()));
  }

  const ProgramLimits& limits_;
  std::chrono::steady_clock::time_point end_;
};

/// Nothing when it is unknown: whoever ignores SIGCHLD is not told how its children end.
std::optional<int> wait_for_program(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0) {
    if (errno != EINTR) return std::nullopt;
  }
  return status;
}

ProgramEnd end_of(std::optional<int> status) {
  if (!status) return ProgramEnd::kUnknown;
  if (WIFEXITED(*status)) return ProgramEnd::kExited;
  return ProgramEnd::kCrashed;
}

ProgramResult program_not_started(int why) {
  return {why == ENOENT ? ProgramEnd::kNotFound : ProgramEnd::kNotStarted,
          0,
          {},
          std::generic_category().message(why)};
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& words, const ProgramLimits& limits) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  ProgramPipe out;
  ProgramPipe err;
  if (!out.open() || !err.open()) return program_not_started(errno);
  SpawnFiles files;
  files.give_nothing(STDIN_FILENO);
  files.give(out.writing.number(), STDOUT_FILENO);
  files.give(err.writing.number(), STDERR_FILENO);
  files.close_from(STDERR_FILENO + 1);
  pid_t pid = -1;
  const int why = ::posix_spawnp(&pid, arguments[0], files.get(), SpawnAttributes().get(),
                                 arguments.data(), environ);
  if (why != 0) return program_not_started(why);
  if (limits.memory_bytes > 0) {
    const rlimit limit = {limits.memory_bytes, limits.memory_bytes};
    ::prlimit(pid, RLIMIT_AS, &limit, nullptr);
  }
  out.writing.close();
  err.writing.close();

  ProgramResult result;
  const ProgramOutput output(limits);
  std::optional<ProgramEnd> ended = output.read(out.reading.number(), err.reading.number(), result);
  if (!ended) ended = output.wait_for(pid);
  if (ended) ::kill(pid, SIGKILL);
  const std::optional<int> status = wait_for_program(pid);
  result.exit_code = status && WIFEXITED(*status) ? WEXITSTATUS(*status) : 0;
  result.end = ended.value_or(end_of(status));
  return result;
}

std::string describe(const ProgramResult& result, const ProgramLimits& limits) {
  switch (result.end) {
    case ProgramEnd::kNotFound: return "is not installed";
    case ProgramEnd::kNotStarted: return "could not be started: " + result.err;
    case ProgramEnd::kOutOfTime:
      return "did not end within " + std::to_string(limits.wall_seconds) + " s";
    case ProgramEnd::kTooMuchOutput:
      return "printed more than " + std::to_string(limits.output_bytes >> 20U) + " MiB";
    case ProgramEnd::kCrashed: return "crashed";
    case ProgramEnd::kUnknown: return "ended, and it is unknown how";
    case ProgramEnd::kExited: break;
  }
  std::string_view said = result.err;
  while (said.ends_with('\n') || said.ends_with('\r')) said.remove_suffix(1);
  if (said.empty()) return "ended with " + std::to_string(result.exit_code);
  return std::string(said);
}

}  // namespace rigor::process
