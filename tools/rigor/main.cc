// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <deque>
#include <exception>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include <rigor/report/terminal/printable.h>

#include "command/command.h"
#include "option/search.h"
#include "output/output.h"
#include "output/own_input.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kGreeting =
    R"(rigor checks robot models (SDFormat, URDF) before a simulator loads them.

  validate, report         check files and folders; a page about many models for a team
  inspect, render, view    tree, poses and masses; pictures without a window; a page to turn it
  inertia, mesh-check      mass and inertia, exactly; check, repair, reduce and convert meshes
  sdf2urdf, urdf2sdf       convert, with an account of every loss; sdf2mjcf, mjcf2urdf … for MuJoCo
  diff, upgrade, fmt       what differs between robots; a newer SDF of the same robot; one layout
  simulate, merge          drop it, drive it, sweep its joints: a verdict; join sharded runs
  new, init                a robot to begin with, done right and explained; a rigor.toml
  rules, explain           what is checked; why, and what to do about it
  edit, lsp                another name, in all files; editors: findings and fixes as you type
  expand, schema, resolve  xacro as plain XML; a format's elements; where a URI leads

  rigor validate my_robot  check every model and mesh in a folder; `rigor help COMMAND` has more examples
)";

const CLI::App& chosen_command(const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  return chosen.empty() ? program : *chosen.front();
}

std::string unknown_option(const CLI::App& app, const std::string& word) {
  const std::string bare = word.substr(0, word.find('='));
  if (bare == kTemplateArgumentOption) {
    return app.get_name() + " takes no arguments of templates, as " +
           word.substr(std::min(bare.size() + 1, word.size())) + " is one";
  }
  const std::string text = "unknown option " + bare;
  // Commands that write reports have both: --output takes a format, and -o a file.
  if (bare == "--output" && app.get_option_no_throw("--out") != nullptr)
    return text + "; did you mean \"-o\"?";
  std::vector<std::string> names;
  for (const CLI::Option* each : app.get_options()) {
    for (const std::string& name : each->get_lnames()) names.push_back("--" + name);
  }
  return text + did_you_mean(bare, {names.begin(), names.end()});
}

/// The first word that nobody declared, and what it was probably meant to be.
std::string unknown_word(const CLI::App& program) {
  const CLI::App& app = chosen_command(program);
  const std::vector<std::string> words = program.remaining(true);
  const std::string word = words.empty() ? "" : words.front();
  if (word.starts_with('-')) return unknown_option(app, word);
  if (&app != &program) return "one argument too many: " + word;
  std::vector<std::string> names;
  for (const CLI::App* each : program.get_subcommands({})) names.push_back(each->get_name());
  return "unknown command " + word + did_you_mean(word, {names.begin(), names.end()});
}

/// What is missing, or the option that was probably meant for it.
std::string missing_word(const CLI::App& program, const CLI::RequiredError& error) {
  for (const std::string& word : program.remaining(true)) {
    if (word.starts_with('-')) return unknown_option(chosen_command(program), word);
  }
  return error.what();
}

int usage_error(std::string_view message) {
  say("rigor: " + report::printable(message));
  return kUsage;
}

struct CommandEntry {
  std::string_view name;
  std::unique_ptr<Command> (*make)();
  bool tells_of_all = false;  // commands, with their options
};

constexpr CommandEntry kCommands[] = {
    {"validate", validate_command},
    {"inspect", inspect_command},
    {"inertia", inertia_command},
    {"mesh-check", mesh_check_command},
    {"sdf2urdf", sdf2urdf_command},
    {"urdf2sdf", urdf2sdf_command},
    {"sdf2mjcf", sdf2mjcf_command},
    {"urdf2mjcf", urdf2mjcf_command},
    {"mjcf2sdf", mjcf2sdf_command},
    {"mjcf2urdf", mjcf2urdf_command},
    {"diff", diff_command},
    {"simulate", simulate_command},
    {"render", render_command},
    {"view", view_command},
    {"report", report_command},
    {"new", new_command},
    {"merge", merge_command},
    {"upgrade", upgrade_command},
    {"fmt", fmt_command},
    {"edit", edit_command},
    {"srdf", srdf_command},
    {"init", init_command},
    {"lsp", lsp_command},
    {"rules", rules_command},
    {"explain", explain_command},
    {"schema", schema_command},
    {"resolve", resolve_command},
    {"expand", expand_command},
    {"completion", completion_command, true},
    {"man", manual_command, true},
    {"version", version_command},
};

/// The one that is asked for, as declaring the options of all takes longer than many a run; or all.
std::vector<std::unique_ptr<Command>> commands_for(std::string_view word) {
  std::vector<std::unique_ptr<Command>> commands;
  for (const CommandEntry& entry : kCommands) {
    if (entry.name == word && !entry.tells_of_all) commands.push_back(entry.make());
  }
  if (!commands.empty()) return commands;
  for (const CommandEntry& entry : kCommands) commands.push_back(entry.make());
  return commands;
}

bool is_command(std::string_view word) {
  return std::any_of(std::begin(kCommands), std::end(kCommands),
                     [word](const CommandEntry& entry) { return entry.name == word; });
}

/// `help COMMAND` is `COMMAND --help`; of a word that is no command the word is left, and refused.
void take_help(std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front() != "help") return;
  arguments.erase(arguments.begin());
  if (arguments.empty() || arguments.front().starts_with('-')) {
    arguments.clear();
  } else {
    arguments.resize(1);
    if (is_command(arguments.front())) arguments.emplace_back("--help");
  }
}

bool is_template_argument(std::string_view word) {
  const std::size_t assign = word.find(":=");
  return assign != std::string_view::npos && assign > 0 && word[0] != '-' &&
         word.substr(0, assign).find_first_of("/.= ") == std::string_view::npos;
}

/// `prefix:=left_` among the paths, as ROS has it, is an argument of templates. What follows `--` is not.
void take_template_arguments(std::vector<std::string>& arguments) {
  for (std::string& word : arguments) {
    if (word == "--") return;
    if (is_template_argument(word)) word = std::string(kTemplateArgumentOption) + '=' + word;
  }
}

int run(std::vector<std::string> arguments) {
  take_help(arguments);
  if (arguments.empty()) {
    write({0, {}}, kGreeting);
    return kClean;
  }
  if (arguments.front() == "--version") arguments.front() = "version";

  CLI::App program("Checks robot models (SDFormat, URDF) before a simulator loads them", "rigor");
  program.require_subcommand(0, 1);
  examples_first(program, {"rigor validate my_robot"});
  const std::vector<std::unique_ptr<Command>> commands = commands_for(arguments.front());
  take_template_arguments(arguments);
  std::vector<CLI::App*> apps;
  std::deque<ColorOption> never_colored;
  for (const auto& command : commands) {
    apps.push_back(command->declare(program));
    const bool is_known = apps.back()->get_option_no_throw("--color") != nullptr;
    if (!is_known) never_colored.emplace_back().declare(*apps.back());
  }

  try {
    // CLI11 takes the arguments from the back.
    program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp&) {
    write({0, {}}, program.help());
    return kClean;
  } catch (const CLI::ExtrasError&) {
    return usage_error(unknown_word(program));
  } catch (const CLI::RequiredError& error) {
    return usage_error(missing_word(program, error));
  } catch (const CLI::ParseError& error) {
    return usage_error(error.what());
  }
  for (const ColorOption& option : never_colored) option.of({});  // refuses what is none
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (!apps[i]->parsed()) continue;
    refuse_outputs_over_inputs(*apps[i]);
    return commands[i]->run();
  }
  return usage_error("no command; `rigor` alone lists them");
}

int run_caught(std::vector<std::string> arguments) {
  try {
    return run(std::move(arguments));
  } catch (const UsageError& error) {
    return usage_error(error.what());
  } catch (const InputError& error) {
    say("rigor: " + report::printable(error.what()));
    return kFindings;
  } catch (const std::exception& error) {
    say(std::string("rigor: internal error, please report it: ") + error.what());
    return kInternal;
  }
}

}  // namespace
}  // namespace rigor::tool

int main(int argc, char** argv) {
  // With stderr closed, the next file that is opened would take its place, and what is said with it.
  if (::fcntl(STDERR_FILENO, F_GETFD) < 0) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    if (nowhere >= 0 && nowhere != STDERR_FILENO) {
      ::dup2(nowhere, STDERR_FILENO);
      ::close(nowhere);
    }
  }
  // Whoever started this may ignore it, which is inherited: no end of git could be told.
  std::signal(SIGCHLD, SIG_DFL);
  return rigor::tool::run_caught(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
}
