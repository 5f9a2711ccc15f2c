// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "completion/completion.h"

#include <string_view>

#include <fmt/format.h>

namespace rigor::tool {
namespace {

/// For the description of an _arguments or _describe specification, in single quotes.
std::string zsh_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    if (c == '\'')
      out += "'\\''";
    else
      out += c;
  }
  return out;
}

std::string zsh_action(const OptionFacts& option, const CommandFacts& command,
                       const CompletionFacts& facts) {
  switch (value_kind(option)) {
    case ValueKind::kFiles: return "_files";
    case ValueKind::kFolders: return "_files -/";
    case ValueKind::kRules: return "($categories $rules)";
    case ValueKind::kRule: return "($rules)";
    default: {
      const std::vector<std::string> words = words_of(option, command, facts);
      return words.empty() ? " " : "(" + joined_words(words) + ")";
    }
  }
}

/// One or two words for _arguments.
std::string zsh_option(const OptionFacts& option, const CommandFacts& command,
                       const CompletionFacts& facts) {
  // In double quotes where the action is a variable; nothing else there is a dollar sign.
  std::string rest = fmt::format("'[{}]", zsh_text(option.description));
  if (!option.value.empty()) {
    rest += fmt::format(":{}:'\"{}\"", zsh_text(option.value), zsh_action(option, command, facts));
  } else {
    rest += '\'';
  }
  if (option.repeatable) {
    return option.flags.size() == 1
               ? fmt::format("'*{}'{}", option.flags.front(), rest)
               : fmt::format("'*'{{{}}}{}", fmt::join(option.flags, ","), rest);
  }
  if (option.flags.size() == 1) return option.flags.front() + rest;
  return fmt::format("'({})'{{{}}}{}", joined_words(option.flags), fmt::join(option.flags, ","),
                     rest);
}

std::string zsh_case(const CommandFacts& command, const CompletionFacts& facts) {
  std::string text = fmt::format("    {})\n      _arguments -s", command.name);
  for (const OptionFacts& option : command.options) {
    text += " \\\n        " + zsh_option(option, command, facts);
  }
  for (const OptionFacts& positional : command.positionals) {
    text += fmt::format(" \\\n        '{}:{}:'\"{}\"", positional.repeatable ? "*" : "",
                        zsh_text(positional.value), zsh_action(positional, command, facts));
  }
  return text + "\n      ;;\n";
}

}  // namespace

std::string zsh_completion(const CompletionFacts& facts) {
  std::string text =
      "#compdef rigor\n# zsh completion for rigor, as `rigor completion zsh` prints it\n\n"
      "_rigor() {\n  local -a commands=(\n";
  for (const CommandFacts& command : facts.commands) {
    text += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.description));
  }
  text += fmt::format("  )\n  local categories={}\n  local rules={}\n",
                      shell_quoted(joined_words(facts.categories)),
                      shell_quoted(joined_words(facts.rules)));
  text +=
      "  if ((CURRENT == 2)); then\n    _describe command commands\n    return\n  fi\n"
      "  shift words\n  ((CURRENT--))\n  case $words[1] in\n";
  for (const CommandFacts& command : facts.commands) text += zsh_case(command, facts);
  return text +
         "  esac\n}\n\n# Sourced, it registers itself; as a file of $fpath, it is the function's "
         "body.\n"
         "if [[ $zsh_eval_context[-1] == loadautofunc ]]; then\n  _rigor \"$@\"\nelse\n"
         "  compdef _rigor rigor\nfi\n";
}

}  // namespace rigor::tool
