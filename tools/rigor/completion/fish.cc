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
  if (!command.positionals.empty()) {
    std::string rest = fish_value(command.positionals.front(), command, facts);
    // -x and -r refer to an option's value.
    rest = rest == "-x" ? "" : rest.substr(3);
    if (!rest.empty()) text += fish_line(command, rest);
  }
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
