// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "model/xacro.h"

#include <utility>

#include <rigor/process/program.h>
#include <rigor/read/workspace.h>

namespace rigor::tool {
namespace {

/// The largest robots take a few seconds and some hundred MiB; a macro that calls itself takes all.
constexpr process::ProgramLimits kXacroLimits{.wall_seconds = 60,
                                              .output_bytes = read::kMaxModelBytes,
                                              .memory_bytes = std::uint64_t{4} << 30U};

}  // namespace

read::Expansion expand_xacro(const std::string& path) {
  // A path must be no option, and none of the arguments that xacro takes as NAME:=VALUE.
  const std::string word = path.starts_with('-') ? "./" + path : path;
  if (word.find(":=") != std::string::npos) {
    return {std::nullopt, read::FactKind::kXacroFailed, "it takes a path with := for an argument"};
  }
  process::ProgramResult ran = process::run_program({"xacro", word}, kXacroLimits);
  using End = process::ProgramResult::End;
  if (ran.end == End::kNotFound) return {std::nullopt, read::FactKind::kXacroMissing, {}};
  if (ran.end == End::kExited && ran.exit_code == 0) return {std::move(ran.out), {}, {}};
  return {std::nullopt, read::FactKind::kXacroFailed, process::describe(ran, kXacroLimits)};
}

}  // namespace rigor::tool
