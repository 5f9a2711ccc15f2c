// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/launch.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

namespace rigor::process {
namespace {

class SpawnActions {
 public:
  /// `socket` becomes kWorkerSocket; it may have one of the standard numbers, so it goes first.
  explicit SpawnActions(int socket) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, socket, kWorkerSocket);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDWR, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, STDIN_FILENO, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, STDIN_FILENO, STDERR_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&actions_, kWorkerSocket + 1);
  }
  ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

class SpawnAttributes {
 public:
  /// Signals that this process ignores or blocks would stay so.
  SpawnAttributes() {
    sigset_t all;
    sigset_t none;
    ::sigfillset(&all);
    ::sigemptyset(&none);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnAttributes() { ::posix_spawnattr_destroy(&attributes_); }
  SpawnAttributes(const SpawnAttributes&) = delete;
  SpawnAttributes& operator=(const SpawnAttributes&) = delete;

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

}  // namespace

std::variant<WorkerProcess, int> WorkerProcess::start(const std::string& program) {
  std::array<int, 2> ends = {};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return errno;
  Descriptor own(ends[0]);
  const Descriptor others(ends[1]);
  ::fcntl(own.number(), F_SETFL, O_NONBLOCK);

  std::string name = "rigor-worker";
  const std::array<char*, 2> words{name.data(), nullptr};
  const SpawnActions actions(others.number());
  const SpawnAttributes attributes;
  pid_t pid = -1;
  const int error =
      ::posix_spawn(&pid, program.c_str(), actions.get(), attributes.get(), words.data(), environ);
  if (error != 0) return error;
  return WorkerProcess(pid, std::move(own));
}

WorkerProcess::WorkerProcess(pid_t pid, Descriptor socket)
    : pid_(pid), socket_(std::move(socket)) {}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), socket_(std::move(other.socket_)) {}

WorkerProcess::~WorkerProcess() { end(); }

bool WorkerProcess::hung_up() const {
  pollfd end{socket(), POLLRDHUP, 0};
  return ::poll(&end, 1, 0) > 0;
}

int WorkerProcess::end() {
  if (pid_ < 0) return 0;
  // Of one that is dying already this changes nothing.
  ::kill(pid_, SIGKILL);
  int status = 0;
  pid_t gone = -1;
  do {
    gone = ::waitpid(pid_, &status, 0);
  } while (gone < 0 && errno == EINTR);
  pid_ = -1;
  return gone >= 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace rigor::process
