// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "completion/command_tree.h"

#include <functional>

#include "command/command.h"

namespace rigor::tool {
namespace {

OptionFacts option_facts(CLI::Option& option) {
  OptionFacts facts;
  for (const std::string& name : option.get_snames()) facts.flags.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) facts.flags.push_back("--" + name);
  if (option.get_items_expected_max() > 0) facts.value = value_name(option);
  facts.description = option.get_description();
  facts.group = option.get_group();
  facts.choices = offered_by(option);
  facts.repeatable = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  facts.required = option.get_required();
  return facts;
}

CommandFacts command_facts(CLI::App& app) {
  CommandFacts facts{app.get_name(), app.get_description(), examples_of(app), {}, {}};
  for (CLI::Option* option : app.get_options()) {
    if (option->get_positional()) facts.positionals.push_back(option_facts(*option));
  }
  for (const std::string& group : app.get_groups()) {
    if (group.empty()) continue;  // hidden
    for (CLI::Option* option : app.get_options()) {
      if (option->nonpositional() && option->get_group() == group) {
        facts.options.push_back(option_facts(*option));
      }
    }
  }
  return facts;
}

}  // namespace

std::vector<CommandFacts> command_tree(CLI::App& program) {
  std::vector<CommandFacts> tree;
  for (CLI::App* app : program.get_subcommands(std::function<bool(CLI::App*)>())) {
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
