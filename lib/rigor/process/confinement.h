// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a process that was just forked does to itself before it works: it lets go of what its parent
// holds, and lowers its own limits. And what its parent makes of its end. For the files of this folder.
//
//   const pid_t pid = ::fork();
//   if (pid == 0) {
//     keep_only(pipe);          // is kKept now
//     reset_signals();
//     confine(limits);
//     const ChildResult outcome = outcome_of(work);
//     ...
//   }

#pragma once

#include <unistd.h>

#include <functional>
#include <string>

#include <rigor/process/child.h>

namespace rigor::process {

/// The one descriptor that is kept; everything above it is closed, the standard ones lead nowhere.
inline constexpr int kKept = STDERR_FILENO + 1;
void keep_only(int descriptor);

/// The parent's handlers and mask are not the child's: a crash must be a crash.
void reset_signals();

/// Sets the limits, from now on and on top of the memory in use now.
void confine(const ChildLimits& limits);

/// What the work gave, or how it failed; nothing is thrown.
ChildResult outcome_of(const std::function<std::string()>& work);

/// How a process ended that a signal killed, or none (0), before it could say.
ChildResult ended_by(int signal);

/// Of an `errno`.
ChildResult not_started(int error);

}  // namespace rigor::process
