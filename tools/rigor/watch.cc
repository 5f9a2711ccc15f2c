// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <rigor/report/changes.h>
#include <rigor/report/pretty.h>
#include <rigor/report/printable.h>
#include <rigor/report/summary.h>
#include "asked_disk.h"
#include "command.h"
#include "output.h"

namespace rigor::tool {
namespace {

/// An editor writes, renames and removes in one go; a checkout takes longer, and gets a second look.
constexpr int kQuietMilliseconds = 50;

/// Rounds of events until the second look: a second at most, where something writes all the time.
constexpr int kMaxRounds = 20;

constexpr std::uint32_t kWatchedEvents = IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM |
                                         IN_MOVED_TO | IN_DELETE_SELF | IN_MOVE_SELF;

/// Wakes up when something happens in one of the folders.
class FolderEvents {
 public:
  explicit FolderEvents(const std::set<std::string>& folders)
      : descriptor_(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
    if (descriptor_ < 0) refuse("the system gives no watch");
    for (const std::string& folder : folders) {
      if (::inotify_add_watch(descriptor_, folder.c_str(), kWatchedEvents | IN_ONLYDIR) >= 0)
        continue;
      // A folder that is gone by now or that may not be read tells nothing.
      if (errno != ENOSPC) continue;
      const std::string limit = "there are more folders than fs.inotify.max_user_watches allows";
      ::close(descriptor_);
      refuse(limit);
    }
  }
  ~FolderEvents() { ::close(descriptor_); }
  FolderEvents(const FolderEvents&) = delete;
  FolderEvents& operator=(const FolderEvents&) = delete;

  void wait() const {
    pollfd events{descriptor_, POLLIN, 0};
    int timeout = -1;
    for (int round = 0; round < kMaxRounds;) {
      const int ready = ::poll(&events, 1, timeout);
      if (ready == 0) return;
      if (ready < 0) continue;  // interrupted
      ++round;
      std::array<char, 1U << 16U> ignored;
      while (::read(descriptor_, ignored.data(), ignored.size()) > 0) {
      }
      timeout = kQuietMilliseconds;
    }
  }

 private:
  [[noreturn]] static void refuse(const std::string& why) { throw UsageError("--watch: " + why); }

  int descriptor_;
};

/// From now on Ctrl-C ends the program with 0, in the middle of a check as well.
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

}  // namespace

int watch(const WatchedCheck& check,
          const std::function<void(const rules::ValidateResult&)>& conclude, report::Color color) {
  end_well_on_interrupt();
  std::vector<report::KnownFinding> before;
  for (bool first = true;; first = false) {
    const AskedDisk disk;
    Sources sources;
    try {
      const rules::ValidateResult result = check(disk, sources);
      write({0, {}}, first ? report::pretty(result.diagnostics, sources, color)
                           : report::changes(before, result.diagnostics, sources, color));
      conclude(result);
      if (first && result.files.empty() && !result.unusable.empty()) return kUsage;
      before = report::remembered(before, report::known_findings(result.diagnostics, sources));
    } catch (const UsageError& error) {
      if (first) throw;
      say("rigor: " + report::printable(error.what()));
    }

    FolderEvents events(disk.folders());
    if (first) {
      write({0, {}}, "watching " + report::counted(disk.files_read(), "file") + "; Ctrl-C ends\n");
    }
    // What changed since it was read and before it was watched is no event.
    while (disk.still_so()) events.wait();
  }
}

}  // namespace rigor::tool
