// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/child.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <rigor/process/confinement.h>
#include <rigor/process/descriptor.h>

namespace rigor::process {
namespace {

using End = ChildResult::End;

/// Comes behind the bytes. A child that dies in the middle of writing leaves none that fits.
struct Trailer {
  std::uint64_t size = 0;
  std::uint64_t end = 0;
};

/// A started child, which leaves no zombie whatever happens here.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() {
    if (pid_ < 0) return;
    ::kill(pid_, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The signal that killed it; 0 when none did, or when nobody can tell (SIGCHLD is ignored).
  int wait() {
    int status = 0;
    pid_t gone = -1;
    do {
      gone = ::waitpid(pid_, &status, 0);
    } while (gone < 0 && errno == EINTR);
    pid_ = -1;
    return gone >= 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }

 private:
  pid_t pid_;
};

// ---- In the child

void send(const void* data, std::size_t size) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = ::write(kKept, bytes, size);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) ::_exit(1);
    bytes += sent;
    size -= static_cast<std::size_t>(sent);
  }
}

[[noreturn]] void leave(End end, std::string_view bytes) {
  const Trailer trailer{bytes.size(), static_cast<std::uint64_t>(end)};
  send(bytes.data(), bytes.size());
  send(&trailer, sizeof trailer);
  ::_exit(0);
}

[[noreturn]] void run(const ChildLimits& limits, const std::function<std::string()>& work,
                      int result) {
  keep_only(result);
  reset_signals();
  confine(limits);
  const ChildResult outcome = outcome_of(work);
  leave(outcome.end, outcome.bytes);
}

// ---- In the parent

ChildResult result_of(std::string bytes, int signal) {
  Trailer trailer;
  if (bytes.size() < sizeof trailer) return ended_by(signal);
  const std::size_t size = bytes.size() - sizeof trailer;
  std::memcpy(&trailer, bytes.data() + size, sizeof trailer);
  if (trailer.size != size) return ended_by(signal);
  bytes.resize(size);
  return {static_cast<End>(trailer.end), 0, std::move(bytes)};
}

/// One child on its way: what it has written so far.
class Running {
 public:
  Running(std::size_t its_index, const ChildLimits& limits,
          const std::function<std::string()>& work)
      : index(its_index) {
    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      error = errno;
      return;
    }
    reading_.emplace(ends[0]);
    const Descriptor writing(ends[1]);
    const pid_t pid = ::fork();
    if (pid == 0) run(limits, work, writing.number());
    if (pid < 0) {
      error = errno;
    } else {
      child_.emplace(pid);
    }
  }

  /// Takes what there is; true at the end.
  bool read_some() {
    if (!ready) return false;
    ready = false;
    std::array<char, 1U << 16U> chunk;  // a pipe holds as much
    const ssize_t got = ::read(reading_->number(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) return false;
    if (got <= 0) return true;
    bytes_.append(chunk.data(), static_cast<std::size_t>(got));
    return false;
  }

  ChildResult result() { return result_of(std::move(bytes_), child_->wait()); }
  int descriptor() const { return reading_->number(); }

  std::size_t index;
  int error = 0;       ///< why it could not be started
  bool ready = false;  ///< there is something to read

 private:
  std::optional<Descriptor> reading_;
  std::optional<Child> child_;
  std::string bytes_;
};

void wait_for_any(const std::vector<std::unique_ptr<Running>>& running) {
  std::vector<pollfd> waiting;
  for (const auto& one : running) waiting.push_back({one->descriptor(), POLLIN, 0});
  if (::poll(waiting.data(), waiting.size(), -1) < 0) return;  // interrupted: asked again
  for (std::size_t i = 0; i < running.size(); ++i) running[i]->ready = waiting[i].revents != 0;
}

/// "segmentation fault": the C library's words, in any locale in English, but for the capital.
std::string signal_name(int signal) {
  const char* known = ::sigdescr_np(signal);
  std::string name = known ? known : "signal " + std::to_string(signal);
  const bool word = name.size() > 1 && name[1] >= 'a' && name[1] <= 'z';
  if (word && name[0] >= 'A' && name[0] <= 'Z') name[0] = static_cast<char>(name[0] - 'A' + 'a');
  return name;
}

std::string in_units(std::uint64_t bytes) {
  constexpr std::uint64_t kMiB = 1U << 20U;
  constexpr std::uint64_t kGiB = 1U << 30U;
  if (bytes >= kGiB && bytes % kGiB == 0) return std::to_string(bytes / kGiB) + " GiB";
  return std::to_string(bytes / kMiB) + " MiB";
}

}  // namespace

ChildResult run_in_child(const ChildLimits& limits, const std::function<std::string()>& work) {
  return run_in_children(limits, {work}, 1).front();
}

std::vector<ChildResult> run_in_children(const ChildLimits& limits,
                                         const std::vector<std::function<std::string()>>& works,
                                         unsigned jobs,
                                         const std::function<void(std::size_t)>& done) {
  std::vector<ChildResult> results(works.size());
  std::size_t given = 0;
  std::size_t count = 0;
  feed_children(
      limits, jobs,
      [&] { return given < works.size() ? works[given++] : std::function<std::string()>(); },
      [&](std::size_t index, ChildResult result) {
        results[index] = std::move(result);
        ++count;
        if (done) done(count);
      });
  return results;
}

void feed_children(const ChildLimits& limits, unsigned jobs,
                   const std::function<std::function<std::string()>()>& next,
                   const std::function<void(std::size_t, ChildResult)>& ended) {
  std::vector<std::unique_ptr<Running>> running;
  std::size_t given = 0;
  while (true) {
    while (running.size() < std::max(jobs, 1U)) {
      const std::function<std::string()> work = next();
      if (!work) break;
      auto started = std::make_unique<Running>(given++, limits, work);
      if (started->error == 0) {
        running.push_back(std::move(started));
      } else {
        ended(started->index, not_started(started->error));
      }
    }
    if (running.empty()) return;
    wait_for_any(running);
    for (std::size_t i = 0; i < running.size();) {
      if (!running[i]->read_some()) {
        ++i;
        continue;
      }
      const std::unique_ptr<Running> gone = std::move(running[i]);
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
      ended(gone->index, gone->result());
    }
  }
}

std::string describe(const ChildResult& result, const ChildLimits& limits) {
  const unsigned seconds = std::max(limits.cpu_seconds, 1U);
  switch (result.end) {
    case End::kDone: return "ended well";
    case End::kFailed: return "failed: " + result.bytes;
    case End::kCrashed:
      return result.signal == 0 ? "ended before its time"
                                : "crashed (" + signal_name(result.signal) + ")";
    case End::kOutOfTime:
      if (result.signal == SIGALRM) {
        return "did not end within " + std::to_string(seconds * kWallPerCpuSecond) + " s";
      }
      return "took more than " + std::to_string(seconds) + " s of CPU time";
    case End::kOutOfMemory:
      return "needed more than " + in_units(limits.memory_bytes) + " of memory";
    case End::kNotStarted: return "could not be started: " + result.bytes;
  }
  return {};
}

}  // namespace rigor::process
