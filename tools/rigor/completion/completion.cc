// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "completion/completion.h"

#include <set>
#include <string_view>

#include <fmt/format.h>

#include <rigor/rules/registry.h>
#include "command/command.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

struct Shell {
  std::string_view name;
  std::string (*script)(const CompletionFacts&);
};

constexpr Shell kShells[] = {
    {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};

std::vector<std::string_view> shell_names() {
  std::vector<std::string_view> names;
  for (const Shell& shell : kShells) names.push_back(shell.name);
  return names;
}

class Completion final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    program_ = &program;
    CLI::App* app =
        add_command(program, "completion", "Print a shell's completion script",
                    {"rigor completion bash > ~/.local/share/bash-completion/completions/rigor",
                     "rigor completion zsh > ~/.zfunc/_rigor",
                     "rigor completion fish > ~/.config/fish/completions/rigor.fish"});
    offer(app->add_option("shell", shell_, "bash, zsh or fish")->required()->type_name("SHELL"),
          shell_names());
    return app;
  }

  int run() override {
    const std::size_t chosen = choice("shell", shell_, shell_names());
    CompletionFacts facts{command_tree(*program_), {}, {}};
    const rules::Registry registry;
    std::set<std::string> categories;
    for (const rules::Rule& rule : registry.rules()) {
      facts.rules.emplace_back(rule.name);
      categories.emplace(rules::to_string(rule.category));
    }
    facts.categories.assign(categories.begin(), categories.end());
    write({0, {}}, kShells[chosen].script(facts));
    return kClean;
  }

 private:
  CLI::App* program_ = nullptr;
  std::string shell_;
};

}  // namespace

std::string joined_words(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

ValueKind value_kind(const OptionFacts& option) {
  const std::string& value = option.value;
  if (!option.choices.empty()) return ValueKind::kChoices;
  if (value == "RULE,...") return ValueKind::kRules;
  if (value == "RULE") return ValueKind::kRule;
  if (value == "DIR") return ValueKind::kFolders;
  // What a verb takes are names and files; of names the shell knows none.
  for (const std::string_view file : {"FILE", "PATH", "MODEL", "IN", "A", "B", "WORD"}) {
    const bool is = value == file || value.starts_with(std::string(file) + '|') ||
                    value.ends_with("|" + std::string(file));
    if (is && (value != "A" || option.flags.empty())) return ValueKind::kFiles;
  }
  return value.starts_with("FILE.") ? ValueKind::kFiles : ValueKind::kNone;
}

std::vector<std::string> words_of(const OptionFacts& option, const CommandFacts& command,
                                  const CompletionFacts& facts) {
  switch (value_kind(option)) {
    case ValueKind::kChoices: return option.choices;
    case ValueKind::kRule: return facts.rules;
    case ValueKind::kRules: {
      std::vector<std::string> words = facts.categories;
      words.insert(words.end(), facts.rules.begin(), facts.rules.end());
      return words;
    }
    case ValueKind::kNone:
      if (option.value != "FORMAT[:FILE]") return {};
      for (const OptionFacts& other : command.options) {
        if (other.flags == std::vector<std::string>{"--format"}) return other.choices;
      }
      return {};
    default: return {};
  }
}

const OptionFacts* behind_verb(const CommandFacts& command) {
  const bool has_verb = command.positionals.size() > 1 &&
                        value_kind(command.positionals.front()) == ValueKind::kChoices;
  return has_verb ? &command.positionals[1] : nullptr;
}

std::string shell_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else
      out += c;
  }
  return out + '\'';
}

std::unique_ptr<Command> completion_command() { return std::make_unique<Completion>(); }

}  // namespace rigor::tool
