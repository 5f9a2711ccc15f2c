// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Man pages and the reference page of all commands, from the commands as data.

#pragma once

#include <string>
#include <vector>

#include "completion/command_tree.h"

namespace rigor::tool {

/// rigor(1).
std::string program_man_page(const std::vector<CommandFacts>& commands);

/// rigor-NAME(1).
std::string command_man_page(const CommandFacts& command);

/// docs/reference/commands.md.
std::string commands_markdown(const std::vector<CommandFacts>& commands);

}  // namespace rigor::tool
