// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What every subcommand is: options that it declares, and a run that gives the exit code.

#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace rigor::tool {

/// Exit codes of every command.
inline constexpr int kClean = 0;
inline constexpr int kFindings = 1;
inline constexpr int kUsage = 2;
inline constexpr int kInternal = 3;

/// The invocation is wrong: said on stderr, exit 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Command {
 public:
  virtual ~Command() = default;

  /// Adds the subcommand to the program; options are bound to members of this object.
  virtual CLI::App* declare(CLI::App& program) = 0;

  /// After the command line is understood.
  virtual int run() = 0;
};

std::unique_ptr<Command> validate_command();
std::unique_ptr<Command> inspect_command();
std::unique_ptr<Command> inertia_command();
std::unique_ptr<Command> mesh_check_command();
std::unique_ptr<Command> sdf2urdf_command();
std::unique_ptr<Command> urdf2sdf_command();
std::unique_ptr<Command> diff_command();
std::unique_ptr<Command> simulate_command();
std::unique_ptr<Command> render_command();
std::unique_ptr<Command> view_command();
std::unique_ptr<Command> report_command();
std::unique_ptr<Command> new_command();
std::unique_ptr<Command> merge_command();
std::unique_ptr<Command> upgrade_command();
std::unique_ptr<Command> init_command();
std::unique_ptr<Command> rules_command();
std::unique_ptr<Command> explain_command();
std::unique_ptr<Command> schema_command();
std::unique_ptr<Command> resolve_command();
std::unique_ptr<Command> expand_command();
std::unique_ptr<Command> completion_command();
std::unique_ptr<Command> manual_command();
std::unique_ptr<Command> version_command();

/// Makes the help of a program or subcommand open with examples, one a line.
void examples_first(CLI::App& app, const std::vector<std::string>& examples);

/// A subcommand whose help opens with examples, one a line.
CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& description,
                      const std::vector<std::string>& examples);

/// `; did you mean "axis-zero"?`, or nothing when no candidate is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates);

/// The index of `name` among `known`; a UsageError that names `what` when it is none of them.
std::size_t choice(std::string_view what, std::string_view name,
                   const std::vector<std::string_view>& known);

/// "a, b, c"
std::string listed(const std::vector<std::string_view>& names);

}  // namespace rigor::tool
