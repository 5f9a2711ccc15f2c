// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "watch/folder_events.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <thread>

#include "command/command.h"

namespace rigor::tool {
namespace {

/// An editor writes, renames and removes in one go; a checkout takes longer, and gets a second look.
constexpr int kQuietMilliseconds = 50;

/// Rounds of events until the second look: a second at most, where something writes all the time.
constexpr int kMaxRounds = 20;

constexpr std::uint32_t kWatchedEvents = IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM |
                                         IN_MOVED_TO | IN_DELETE_SELF | IN_MOVE_SELF;

}  // namespace

FolderEvents::FolderEvents(const std::set<std::string>& folders, const std::string& option)
    : descriptor_(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
  if (descriptor_.number() < 0) throw UsageError(option + ": the system gives no watch");
  for (const std::string& folder : folders) {
    if (::inotify_add_watch(descriptor_.number(), folder.c_str(), kWatchedEvents | IN_ONLYDIR) >= 0)
      continue;
    // A folder that is gone by now or that may not be read tells nothing.
    if (errno != ENOSPC) continue;
    throw UsageError(option + ": there are more folders than fs.inotify.max_user_watches allows");
  }
}

void FolderEvents::wait() const {
  pollfd events{descriptor_.number(), POLLIN, 0};
  int timeout = -1;
  for (int round = 0; round < kMaxRounds;) {
    const int ready = ::poll(&events, 1, timeout);
    if (ready == 0) return;
    if (ready < 0) continue;  // interrupted
    ++round;
    std::array<char, 1U << 16U> ignored;
    while (::read(descriptor_.number(), ignored.data(), ignored.size()) > 0) {
    }
    timeout = kQuietMilliseconds;
  }
}

void end_well_on_interrupt() {
  sigset_t interrupt;
  ::sigemptyset(&interrupt);
  ::sigaddset(&interrupt, SIGINT);
  ::pthread_sigmask(SIG_BLOCK, &interrupt, nullptr);  // of the threads to come, too
  std::thread([interrupt] {
    int signal = 0;
    while (::sigwait(&interrupt, &signal) != 0) {
    }
    std::_Exit(kClean);
  }).detach();
}

}  // namespace rigor::tool
