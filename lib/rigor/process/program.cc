// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/program.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
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

namespace rigor::process {
namespace {

using ProgramEnd = ProgramResult::End;

/// Where the program's side says why it could not be started; closed once it is.
constexpr int kStartFailure = STDERR_FILENO + 1;

/// A pipe that nobody else inherits; without one, its numbers are negative.
struct ProgramPipe {
  ProgramPipe() {
    std::array<int, 2> ends = {-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    reading = Descriptor(ends[0]);
    writing = Descriptor(ends[1]);
  }

  Descriptor reading{-1};
  Descriptor writing{-1};
};

/// After the fork: nothing here may allocate, since another thread may have held the allocator's lock.
[[noreturn]] void become(char* const* words, const ProgramLimits& limits, int out, int err,
                         int failure) {
  // A pipe's end may have one of the numbers that are given here, so all go above them first.
  const int kept_out = ::fcntl(out, F_DUPFD, kStartFailure + 1);
  const int kept_err = ::fcntl(err, F_DUPFD, kStartFailure + 1);
  const int kept_failure = ::fcntl(failure, F_DUPFD, kStartFailure + 1);
  ::close(STDIN_FILENO);
  ::open("/dev/null", O_RDONLY);  // takes the lowest number
  ::dup2(kept_out, STDOUT_FILENO);
  ::dup2(kept_err, STDERR_FILENO);
  ::dup3(kept_failure, kStartFailure, O_CLOEXEC);
  ::close_range(kStartFailure + 1, ~0U, 0);
  ::signal(SIGPIPE, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::alarm(limits.wall_seconds);  // should this process be gone by then
  if (limits.memory_bytes > 0) {
    const rlimit limit = {limits.memory_bytes, limits.memory_bytes};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ::execvp(words[0], words);
  const int why = errno;
  const ssize_t told = ::write(kStartFailure, &why, sizeof why);
  ::_exit(told > 0 ? 127 : 126);
}

/// Why it could not be started; 0 when it was.
int start_failure(int descriptor) {
  int why = 0;
  ssize_t got = -1;
  do {
    got = ::read(descriptor, &why, sizeof why);
  } while (got < 0 && errno == EINTR);
  return got == static_cast<ssize_t>(sizeof why) ? why : 0;
}

/// Takes what both pipes give until they are closed, or a limit is passed.
class ProgramOutput {
 public:
  explicit ProgramOutput(const ProgramLimits& limits)
      : limits_(limits),
        end_(std::chrono::steady_clock::now() + std::chrono::seconds(limits.wall_seconds)) {}

  /// How it has to be ended; nothing when it ends by itself.
  std::optional<ProgramEnd> read(int out, int err, ProgramResult& result) {
    std::array<pollfd, 2> pipes{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
    const std::array<std::string*, 2> texts{&result.out, &result.err};
    while (pipes[0].fd >= 0 || pipes[1].fd >= 0) {
      const auto left =
          std::chrono::ceil<std::chrono::milliseconds>(end_ - std::chrono::steady_clock::now());
      if (left.count() <= 0) return ProgramEnd::kOutOfTime;
      if (::poll(pipes.data(), pipes.size(), static_cast<int>(left.count())) < 0) continue;
      for (std::size_t i = 0; i < pipes.size(); ++i) {
        if (pipes[i].fd < 0 || pipes[i].revents == 0) continue;
        if (!take(pipes[i].fd, *texts[i])) pipes[i].fd = -1;
        if (texts[i]->size() > limits_.output_bytes) return ProgramEnd::kTooMuchOutput;
      }
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

  const ProgramLimits& limits_;
  std::chrono::steady_clock::time_point end_;
};

/// Nothing when nobody can tell: whoever ignores SIGCHLD is not told how its children end.
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
  return WTERMSIG(*status) == SIGALRM ? ProgramEnd::kOutOfTime : ProgramEnd::kCrashed;
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
  ProgramPipe failure;
  for (const ProgramPipe* pipe : {&out, &err, &failure}) {
    if (pipe->reading.number() < 0) return program_not_started(errno);
  }
  const pid_t pid = ::fork();
  if (pid < 0) return program_not_started(errno);
  if (pid == 0) {
    become(arguments.data(), limits, out.writing.number(), err.writing.number(),
           failure.writing.number());
  }
  for (ProgramPipe* pipe : {&out, &err, &failure}) pipe->writing.close();

  if (const int why = start_failure(failure.reading.number()); why != 0) {
    wait_for_program(pid);
    return program_not_started(why);
  }
  ProgramResult result;
  const std::optional<ProgramEnd> ended =
      ProgramOutput(limits).read(out.reading.number(), err.reading.number(), result);
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
