// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Completion scripts for shells, from the commands as data.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "completion/command_tree.h"

namespace rigor::tool {

/// What a script knows: commands, and the names that an option which takes a RULE can have.
struct CompletionFacts {
  std::vector<CommandFacts> commands;
  std::vector<std::string> rules;       ///< names
  std::vector<std::string> categories;  ///< which `--select` and `--ignore` take too
};

/// What the value of an option, or a positional, is completed with.
enum class ValueKind { kNone, kChoices, kRules, kRule, kFiles, kFolders };

ValueKind value_kind(const OptionFacts& option);

/// The values to choose from; `--output FORMAT[:FILE]` takes what `--format` lists.
std::vector<std::string> words_of(const OptionFacts& option, const CommandFacts& command,
                                  const CompletionFacts& facts);

/// Of a command whose first positional is a choice of verbs, that of what comes behind one; null for others.
const OptionFacts* behind_verb(const CommandFacts& command);

std::string joined_words(const std::vector<std::string>& words);

/// In single quotes, for a shell.
std::string shell_quoted(std::string_view text);

std::string bash_completion(const CompletionFacts& facts);
std::string zsh_completion(const CompletionFacts& facts);
std::string fish_completion(const CompletionFacts& facts);

}  // namespace rigor::tool
