// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Starts a worker's program, and ends it. For the files of this folder.
//
//   std::variant<WorkerProcess, int> started = WorkerProcess::start("/usr/libexec/rigor-worker");
//   if (const int* error = std::get_if<int>(&started)) say(strerror(*error));

#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <string>
#include <variant>

#include <rigor/process/descriptor.h>

namespace rigor::process {

/// The worker's end of its socket, in the worker: the only descriptor besides the standard ones, which lead
/// nowhere.
inline constexpr int kWorkerSocket = STDERR_FILENO + 1;

/// A program that runs. Killed, and its zombie taken, when this goes.
class WorkerProcess {
 public:
  /// Executed by posix_spawn, which copies nothing of this process: not its memory, its descriptors, its
  /// signal handlers or mask. The error number when that fails.
  static std::variant<WorkerProcess, int> start(const std::string& program);

  WorkerProcess(WorkerProcess&& other) noexcept;
  WorkerProcess& operator=(WorkerProcess&&) = delete;
  ~WorkerProcess();

  /// This process's end, a stream that does not block.
  int socket() const { return socket_.number(); }

  /// Whether its end of the socket is closed.
  bool hung_up() const;

  /// Makes sure that it ends, and waits for that: the signal that killed it; 0 when none did, or when it
  /// cannot be known (this process ignores SIGCHLD).
  int end();

 private:
  WorkerProcess(pid_t pid, Descriptor socket);

  pid_t pid_;
  Descriptor socket_;
};

}  // namespace rigor::process
