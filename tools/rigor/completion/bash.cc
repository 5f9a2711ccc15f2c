// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "completion/completion.h"

#include <string_view>

#include <fmt/format.h>

namespace rigor::tool {
namespace {

/// What stands in a case's arm.
std::string bash_answer(const OptionFacts& option, const CommandFacts& command,
                        const CompletionFacts& facts) {
  switch (value_kind(option)) {
    case ValueKind::kFiles: return "files=yes";
    case ValueKind::kFolders: return "folders=yes";
    case ValueKind::kRules: return "words=\"$categories $rules\"";
    case ValueKind::kRule: return "words=$rules";
    default: return "words='" + joined_words(words_of(option, command, facts)) + '\'';
  }
}

/// What the positionals of a command are completed with.
std::string bash_positionals(const CommandFacts& command, const CompletionFacts& facts) {
  if (command.positionals.empty()) return "words=''";
  const std::string first = bash_answer(command.positionals.front(), command, facts);
  const OptionFacts* rest = behind_verb(command);
  if (rest == nullptr) return first;
  return fmt::format("{}\n      if _rigor_has_one_of \"$words\"; then words='' {}; fi", first,
                     bash_answer(*rest, command, facts));
}

std::string bash_cases(const CompletionFacts& facts) {
  std::string text;
  for (const CommandFacts& command : facts.commands) {
    for (const OptionFacts& option : command.options) {
      if (option.value.empty()) continue;
      std::string pattern;
      for (const std::string& flag : option.flags) {
        if (!pattern.empty()) pattern += " | ";
        pattern += fmt::format("'{} {}'", command.name, flag);
      }
      text += fmt::format("    {}) {} ;;\n", pattern, bash_answer(option, command, facts));
    }
    std::vector<std::string> flags;
    for (const OptionFacts& option : command.options) {
      flags.insert(flags.end(), option.flags.begin(), option.flags.end());
    }
    text += fmt::format("    '{} '*) flags='{}' {} ;;\n", command.name, joined_words(flags),
                        bash_positionals(command, facts));
  }
  return text;
}

constexpr std::string_view kBashBegin =
    R"bash(# bash completion for rigor, as `rigor completion bash` prints it

# Whether one of the words is given before the one that is completed.
_rigor_has_one_of() {
  local word given
  for word in $1; do
    for given in "${COMP_WORDS[@]:2:COMP_CWORD-2}"; do
      [[ $given == "$word" ]] && return 0
    done
  done
  return 1
}

_rigor() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}
  # `--format=json` is three words to bash.
  if [[ $cur == = ]]; then
    cur=''
  elif [[ $prev == = ]]; then
    prev=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  local command='' i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    if [[ ${COMP_WORDS[i]} != -* ]]; then
      command=${COMP_WORDS[i]}
      break
    fi
  done
)bash";

constexpr std::string_view kBashEnd = R"bash(  esac
  if [[ $cur == -* && -n $flags ]]; then
    words=$flags files='' folders=''
  fi
  if [[ -n $files ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$cur")
    compopt -o filenames 2>/dev/null
  elif [[ -n $folders ]]; then
    mapfile -t COMPREPLY < <(compgen -d -- "$cur")
    compopt -o filenames 2>/dev/null
  else
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
  fi
}
complete -F _rigor rigor
)bash";

}  // namespace

std::string bash_completion(const CompletionFacts& facts) {
  std::vector<std::string> names;
  for (const CommandFacts& command : facts.commands) names.push_back(command.name);
  return fmt::format(
      "{}  local categories='{}'\n  local rules='{}'\n"
      "  local words='' flags='' files='' folders=''\n  case \"$command $prev\" in\n"
      "    ' '*) words='{} --help --version' ;;\n{}{}",
      kBashBegin, joined_words(facts.categories), joined_words(facts.rules), joined_words(names),
      bash_cases(facts), kBashEnd);
}

}  // namespace rigor::tool
