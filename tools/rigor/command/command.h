// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What every subcommand is: options that it declares, and a run that gives the exit code.

#pragma once

#include <memory>
#include <span>
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

/// A file that was named has errors that keep the command from its work: said on stderr, exit 1.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Of a command that needs a library which was left out of this build.
[[noreturn]] inline void refuse_without(const std::string& library, const std::string& command) {
  throw UsageError("rigor was built without " + library + ": " + command + " is not available");
}

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
std::unique_ptr<Command> sdf2mjcf_command();
std::unique_ptr<Command> urdf2mjcf_command();
std::unique_ptr<Command> mjcf2sdf_command();
std::unique_ptr<Command> mjcf2urdf_command();
std::unique_ptr<Command> diff_command();
std::unique_ptr<Command> simulate_command();
std::unique_ptr<Command> render_command();
std::unique_ptr<Command> view_command();
std::unique_ptr<Command> report_command();
std::unique_ptr<Command> new_command();
std::unique_ptr<Command> merge_command();
std::unique_ptr<Command> upgrade_command();
std::unique_ptr<Command> fmt_command();
std::unique_ptr<Command> edit_command();
std::unique_ptr<Command> srdf_command();
std::unique_ptr<Command> init_command();
std::unique_ptr<Command> lsp_command();
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

/// Those of `examples_first`.
std::vector<std::string> examples_of(const CLI::App& app);

/// A subcommand whose help opens with examples, one a line.
CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& description,
                      const std::vector<std::string>& examples);

/// `; did you mean "axis-zero"?`, or nothing when no candidate is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates);

using Names = std::span<const std::string_view>;

/// The index of `name` among `known`; a UsageError that names `what` when it is none of them.
std::size_t choice(std::string_view what, std::string_view name, Names known);

/// Lets completions offer the names as values of the option, whose value the command checks by `choice`.
CLI::Option* offer(CLI::Option* option, Names known);

/// Those of `offer`; none where any value may stand.
std::vector<std::string> offered_by(CLI::Option& option);

/// The name of an option's value, "N", without what CLI11 adds of its checks.
std::string value_name(CLI::Option& option);

/// "a, b, c"
std::string listed(const std::vector<std::string_view>& names);

}  // namespace rigor::tool
