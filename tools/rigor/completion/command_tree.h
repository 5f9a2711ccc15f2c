// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The commands and their options as data, read from what the commands declare. Completions, man pages
// and the reference are three printings of it, so that none can tell another story than `--help`.
//
//   for (const CommandFacts& command : command_tree(program)) …

#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace rigor::tool {

struct OptionFacts {
  std::vector<std::string> flags;  ///< "-j", "--jobs"; empty for a positional
  std::string value;               ///< "N"; empty where it takes none
  std::string description;
  std::string group;                 ///< "Options" where the command names none
  std::vector<std::string> choices;  ///< the values, where it takes one of some
  bool repeatable = false;
  bool required = false;
};

struct CommandFacts {
  std::string name;  ///< "validate"
  std::string description;
  std::vector<std::string> examples;
  std::vector<OptionFacts> positionals;
  std::vector<OptionFacts> options;  ///< in the order of their groups
};

/// In the order of `--help`; without the commands that it hides.
std::vector<CommandFacts> command_tree(CLI::App& program);

/// "validate [OPTIONS] [PATH...]"
std::string synopsis(const CommandFacts& command);

}  // namespace rigor::tool
