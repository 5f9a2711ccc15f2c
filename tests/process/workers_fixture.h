// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What tests of workers share: a pool of the tests' own worker, none of which is left when a test ends.

#pragma once

#include <dirent.h>
#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <string>

#include <gtest/gtest.h>

#include <rigor/process/descriptor.h>
#include <rigor/process/request.h>
#include <rigor/process/workers.h>

namespace rigor::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kUnderAddressSanitizer = true;
#elif defined(__has_feature)
inline constexpr bool kUnderAddressSanitizer = __has_feature(address_sanitizer);
#else
inline constexpr bool kUnderAddressSanitizer = false;
#endif

inline int open_descriptors() {
  DIR* folder = ::opendir("/proc/self/fd");
  if (!folder) return 0;
  int count = 0;
  while (::readdir(folder)) ++count;
  ::closedir(folder);
  return count;
}

/// Whether a process ends, at once or soon: a minute is far longer than any takes.
inline bool ends(pid_t process) {
  const process::Descriptor handle(static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
  if (handle.number() < 0) return true;
  pollfd end{handle.number(), POLLIN, 0};
  return ::poll(&end, 1, 60'000) == 1;
}

class WorkersTest : public testing::Test {
 protected:
  using End = process::RequestResult::End;

  static constexpr process::RequestLimits kLimits{.cpu_seconds = 60};

  process::RequestResult call(std::string_view kind, const std::string& bytes = {},
                              const process::RequestLimits& limits = kLimits) const {
    return workers_.call({.kind = kind, .bytes = bytes, .limits = limits});
  }

  const process::Workers workers_{RIGOR_TEST_WORKER};
};

}  // namespace rigor::test
