// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "completion/command_tree.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace rigor::tool {
namespace {

std::vector<std::string> examples_of(const CLI::App& app) {
  // They open the help (see examples_first), each on a line of its own, until an empty line.
  std::vector<std::string> examples;
  const std::string text =
      app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal);
  std::string_view help = text;
  if (!help.starts_with("Example")) return examples;
  help.remove_prefix(help.find('\n') + 1);
  while (help.starts_with("  ")) {
    const std::size_t end = help.find('\n');
    examples.emplace_back(help.substr(2, end - 2));
    help.remove_prefix(end + 1);
  }
  return examples;
}

/// Without what CLI11 adds for a check of the value.
std::string value_name(const CLI::Option& option) {
  std::string name = option.get_type_name();
  for (const std::string_view check : {":POSITIVE", ":NONNEGATIVE"}) {
    if (name.ends_with(check)) name.resize(name.size() - check.size());
  }
  return name;
}

OptionFacts option_facts(const CLI::Option& option) {
  OptionFacts facts;
  for (const std::string& name : option.get_snames()) facts.flags.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) facts.flags.push_back("--" + name);
  if (option.get_items_expected_max() > 0) facts.value = value_name(option);
  facts.description = option.get_description();
  facts.group = option.get_group();
  // `--severity RULE=LEVEL` lists levels, which alone are no value.
  if (!facts.value.empty() && facts.value.find('=') == std::string::npos) {
    facts.choices = listed_choices(facts.description);
  }
  facts.repeatable = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  facts.required = option.get_required();
  return facts;
}

bool is_choice(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::islower(c) || std::isdigit(c) || c == '-';
  });
}

/// "settle (the default), drop" is "settle, drop"; "m, ft…" is "m, ft".
std::string without_remarks(std::string text) {
  for (std::size_t begin = 0; (begin = text.find(" (", begin)) != std::string::npos;) {
    const std::size_t end = text.find(')', begin);
    if (end == std::string::npos) break;
    text.erase(begin, end + 1 - begin);
  }
  constexpr std::string_view kAndSoOn = "…";
  if (text.ends_with(kAndSoOn)) text.resize(text.size() - kAndSoOn.size());
  return text;
}

CommandFacts command_facts(const CLI::App& app) {
  CommandFacts facts{app.get_name(), app.get_description(), examples_of(app), {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) facts.positionals.push_back(option_facts(*option));
  }
  for (const std::string& group : app.get_groups()) {
    if (group.empty()) continue;  // hidden
    for (const CLI::Option* option : app.get_options()) {
      if (option->nonpositional() && option->get_group() == group) {
        facts.options.push_back(option_facts(*option));
      }
    }
  }
  return facts;
}

}  // namespace

std::vector<std::string> listed_choices(std::string description) {
  description = without_remarks(std::move(description));
  if (const std::size_t colon = description.rfind(": "); colon != std::string::npos) {
    description.erase(0, colon + 2);
  }
  // A list ends in "x or y", "x, or y" or "x, y".
  for (const std::string_view join : {", or ", " or "}) {
    if (const std::size_t at = description.rfind(join); at != std::string::npos) {
      description.replace(at, join.size(), ", ");
      break;
    }
  }
  std::vector<std::string> choices;
  std::size_t begin = 0;
  while (begin <= description.size()) {
    const std::size_t end = std::min(description.find(", ", begin), description.size());
    choices.push_back(description.substr(begin, end - begin));
    begin = end + 2;
  }
  if (choices.size() < 2 || !std::all_of(choices.begin(), choices.end(), is_choice)) return {};
  return choices;
}

std::vector<CommandFacts> command_tree(const CLI::App& program) {
  std::vector<CommandFacts> tree;
  for (const CLI::App* app : program.get_subcommands({})) {
    if (!app->get_group().empty()) tree.push_back(command_facts(*app));
  }
  return tree;
}

std::string synopsis(const CommandFacts& command) {
  std::string text = command.name + " [OPTIONS]";
  for (const OptionFacts& positional : command.positionals) {
    const std::string value = positional.value + (positional.repeatable ? "..." : "");
    text += positional.required ? ' ' + value : " [" + value + ']';
  }
  return text;
}

}  // namespace rigor::tool
