// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs an installed program, as `git` or `xacro`, without a shell: no word of a user is ever read as code.
//
//   const ProgramResult git = run_program({"git", "status", "-z"}, {.wall_seconds = 60});
//   if (git.end == ProgramResult::End::kExited && git.exit_code == 0) read(git.out);
//
// It gets no input, and this process's environment, working folder and group, so that Ctrl-C ends both.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rigor::process {

struct ProgramLimits {
  unsigned wall_seconds = 60;
  /// Of what it prints on stdout and on stderr, each; past that it is ended.
  std::uint64_t output_bytes = std::uint64_t{64} << 20U;
  std::uint64_t memory_bytes = 0;  ///< of address space; 0 is no limit
};

struct ProgramResult {
  enum class End : std::uint8_t {
    kExited,  ///< by itself, with `exit_code`
    kNotFound,
    kNotStarted,  ///< `err` says why
    kCrashed,     ///< a signal ended it
    kOutOfTime,
    kTooMuchOutput,
    kUnknown,  ///< it is gone, and nobody can tell how: this process ignores SIGCHLD
  };
  End end = End::kNotStarted;
  int exit_code = 0;
  std::string out;
  std::string err;
};

/// `words` are the program's name, looked up in PATH, and its arguments. Blocks until it is gone.
ProgramResult run_program(const std::vector<std::string>& words, const ProgramLimits& limits);

/// What a message says of a program that did not do its work: its own first words on stderr if there are
/// any, else how it ended: "is not installed", "did not end within 60 s".
std::string describe(const ProgramResult& result, const ProgramLimits& limits);

}  // namespace rigor::process
