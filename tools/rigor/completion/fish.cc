// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "completion/completion.h"

#include <string_view>

#include <fmt/format.h>

namespace rigor::tool {
namespace {

std::string fish_line(const CommandFacts& command, const std::string& rest) {
  return fmt::format("complete -c rigor -n '__fish_seen_subcommand_from {}' {}\n", command.name,
                     rest);
}

/// Of positionals: with or without a verb before them.
std::string fish_verb_line(const CommandFacts& command, std::string_view has,
                           const std::string& rest) {
  const std::string verbs = joined_words(command.positionals.front().choices);
  return fmt::format(
      "complete -c rigor -n '__fish_seen_subcommand_from {}; and {}__fish_seen_subcommand_from "
      "{}' {}\n",
      command.name, has, verbs, rest);
}

std::string fish_value(const OptionFacts& option, const CommandFacts& command,
                       const CompletionFacts& facts) {
  switch (value_kind(option)) {
    case ValueKind::kFiles: return "-r -F";
    case ValueKind::kFolders: return "-x -a '(__fish_complete_directories)'";
    case ValueKind::kRules: return "-x -a \"$categories $rules\"";
    case ValueKind::kRule: return "-x -a \"$rules\"";
    default: {
      const std::vector<std::string> words = words_of(option, command, facts);
      return words.empty() ? "-x" : "-x -a '" + joined_words(words) + "'";
    }
  }
}

/// fish knows one escape more than the others in single quotes: the backslash.
std::string fish_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + '\'';
}

std::string fish_command(const CommandFacts& command, const CompletionFacts& facts) {
  std::string text = fmt::format("\ncomplete -c rigor -n __fish_use_subcommand -a {} -d {}\n",
                                 command.name, fish_quoted(command.description));
  for (const OptionFacts& option : command.options) {
    std::string rest;
    for (const std::string& flag : option.flags) {
      rest += flag.starts_with("--") ? "-l " + flag.substr(2) : "-s " + flag.substr(1);
      rest += ' ';
    }
    if (!option.value.empty()) rest += fish_value(option, command, facts) + ' ';
    text += fish_line(command, rest + "-d " + fish_quoted(option.description));
  }
  const auto positional = [&](const OptionFacts& option) {
    // -x and -r refer to an option's value.
    const std::string value = fish_value(option, command, facts);
    return value == "-x" ? std::string() : value.substr(3);
  };
  if (command.positionals.empty()) return text;
  const std::string first = positional(command.positionals.front());
  if (first.empty()) return text;
  const OptionFacts* rest = behind_verb(command);
  if (rest == nullptr) return text + fish_line(command, first);
  text += fish_verb_line(command, "not ", first);
  if (const std::string files = positional(*rest); !files.empty())
    text += fish_verb_line(command, "", files);
  return text;
}

}  // namespace

std::string fish_completion(const CompletionFacts& facts) {
  std::string text = fmt::format(
      "# fish completion for rigor, as `rigor completion fish` prints it\n\n"
      "set -l categories {}\nset -l rules {}\n\ncomplete -c rigor -f\n",
      shell_quoted(joined_words(facts.categories)), shell_quoted(joined_words(facts.rules)));
  for (const CommandFacts& command : facts.commands) text += fish_command(command, facts);
  return text;
}

}  // namespace rigor::tool
