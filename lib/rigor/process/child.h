// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs a function in a child process, so that a library that crashes, hangs or eats memory takes only
// its child along.
//
//   ChildResult result = run_in_child({.cpu_seconds = 60, .memory_bytes = kImportBytes}, [&] {
//     return import(bytes);   // in the child; its bytes come back
//   });
//   if (result.end != ChildResult::End::kDone) say(describe(result, limits));
//
// The child is a fork without exec. When the caller has other threads, glibc makes its own locks
// (malloc, stdio, the dynamic loader) usable again in the child, but no others: `work` must not wait
// for a lock that another thread may hold. If it does, the wall clock ends it.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rigor::process {

struct ChildLimits {
  unsigned cpu_seconds = 60;
  /// Of address space on top of what the parent has. Not applied under the address sanitizer, which
  /// reserves terabytes.
  std::uint64_t memory_bytes = std::uint64_t{4} << 30U;
};

/// A child is also ended after this many wall seconds for each CPU second it may take: one that
/// sleeps or waits uses none. Ten leaves room for a machine that runs ten times what it has cores for.
inline constexpr unsigned kWallPerCpuSecond = 10;

struct ChildResult {
  enum class End : std::uint8_t {
    kDone,       ///< `bytes` is what the function gave
    kFailed,     ///< it threw; `bytes` is the exception's text
    kCrashed,    ///< killed by `signal`, or left by itself (0)
    kOutOfTime,  ///< over the CPU seconds, or the wall seconds that go with them
    kOutOfMemory,
    kNotStarted,  ///< no process could be made; `bytes` says why
  };
  End end = End::kNotStarted;
  int signal = 0;
  std::string bytes;
};

/// The function sees the parent's memory as it is now and can change nothing in it; files that the
/// parent holds open are closed to it. What it prints goes nowhere. No handler of `atexit` runs.
/// Blocks until the child is gone.
ChildResult run_in_child(const ChildLimits& limits, const std::function<std::string()>& work);

/// Several, at most `jobs` of them at a time, each as by itself. Results are in the order of the works,
/// whatever the order they end in. One that cannot be started (kNotStarted) has ended, too. `done`, which
/// may be empty, is called here with how many have ended.
std::vector<ChildResult> run_in_children(const ChildLimits& limits,
                                         const std::vector<std::function<std::string()>>& works,
                                         unsigned jobs,
                                         const std::function<void(std::size_t)>& done = {});

/// The same for works of which some are known only when others have ended. `next` gives one, or an empty
/// function when there is none for now; `ended` is told the result of each as soon as it is there, with
/// its number in the order that `next` gave them. Returns when nothing runs and there is none.
void feed_children(const ChildLimits& limits, unsigned jobs,
                   const std::function<std::function<std::string()>()>& next,
                   const std::function<void(std::size_t, ChildResult)>& ended);

/// "crashed (segmentation fault)", "took more than 60 s of CPU time": for messages.
std::string describe(const ChildResult& result, const ChildLimits& limits);

}  // namespace rigor::process
