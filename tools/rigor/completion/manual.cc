// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "completion/manual.h"

#include <string_view>

#include <fmt/format.h>

#include <rigor/report/tool.h>
#include "command/command.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

struct Entry {
  std::string_view name;
  std::string_view text;
};

constexpr std::string_view kProgramLine = "check robot models before a simulator loads them";

constexpr Entry kExitCodes[] = {
    {"0", "It ran; nothing at or above the threshold that --fail-on sets (error by default)."},
    {"1",
     "It ran; there are findings at or above the threshold, which includes input that cannot be "
     "parsed."},
    {"2",
     "The invocation is wrong: an unknown option, rule or format, a named file that does not "
     "exist."},
    {"3", "An internal error: a bug of rigor's. Please report it."},
};

constexpr Entry kVariables[] = {
    {"GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH, SDF_PATH, GAZEBO_MODEL_PATH, "
     "GAZEBO_RESOURCE_PATH, ROS_PACKAGE_PATH, AMENT_PREFIX_PATH",
     "Where model:// and package:// URIs are searched, in this order, after --model-path, "
     "--package, "
     "and the model's own neighbors and package. `rigor resolve URI` shows the search."},
    {"NO_COLOR, CLICOLOR_FORCE, TERM",
     "Whether terminal output is colored, unless --color is given."},
    {"RIGOR_CACHE", "`off` forgets what earlier runs found of large meshes."},
    {"XDG_CACHE_HOME", "Where that is kept, in rigor; else ~/.cache/rigor."},
};

// ---- roff

std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";  // else a hyphen that cannot be copied
    else if (c == '~')
      out += "\\(ti";
    else if (c == '^')
      out += "\\(ha";
    else if (c == '`')
      out += "\\(ga";
    else if (c == '\'')
      out += "\\(aq";
    else
      out += c;
  }
  if (out.starts_with('.')) out.insert(0, "\\&");
  return out;
}

std::string capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return out;
}

std::string roff_heading(std::string_view title) { return ".SH " + capitals(title) + '\n'; }

std::string roff_title(std::string_view name) {
  return fmt::format(".\\\" As `rigor man` prints it\n.TH {} 1 \"\" \"rigor {}\" \"rigor\"\n",
                     roff(capitals(name)), report::tool_version());
}

std::string roff_option(const OptionFacts& option) {
  std::string text = ".TP\n";
  for (const std::string& flag : option.flags) {
    text += fmt::format("{}\\fB{}\\fR", &flag == &option.flags.front() ? "" : ", ", roff(flag));
  }
  if (!option.value.empty()) {
    text += fmt::format("{}\\fI{}\\fR{}", option.flags.empty() ? "" : " ", roff(option.value),
                        option.repeatable ? " ..." : "");
  }
  return text + '\n' + roff(option.description) + '\n';
}

std::string roff_entries(std::string_view title, const auto& entries) {
  std::string text = roff_heading(title);
  for (const Entry& entry : entries) {
    text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(entry.name), roff(entry.text));
  }
  return text;
}

std::string roff_examples(const std::vector<std::string>& examples) {
  std::string text = roff_heading("Examples");
  text += ".nf\n";
  for (const std::string& example : examples) text += roff(example) + '\n';
  return text + ".fi\n";
}

// ---- Markdown

/// Between backticks; a bar would end the cell of a table.
std::string markdown_code(std::string_view text) {
  std::string out = "`";
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out + '`';
}

/// Running text: "<inertial>" is not a tag, and a bar does not end the cell.
std::string markdown_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '_') out += '\\';
    out += c;
  }
  return out;
}

std::string markdown_option(const OptionFacts& option) {
  std::string name = fmt::format("{}", fmt::join(option.flags, ", "));
  if (!option.value.empty()) name += (name.empty() ? "" : " ") + option.value;
  return fmt::format("| {}{} | {} |\n", markdown_code(name), option.repeatable ? " …" : "",
                     markdown_text(option.description));
}

std::string markdown_command(const CommandFacts& command) {
  std::string text =
      fmt::format("\n## rigor {}\n\n{}.\n\n```sh\n", command.name, command.description);
  for (const std::string& example : command.examples) text += example + '\n';
  text += fmt::format("```\n\n`rigor {}`\n\n| option | meaning |\n|---|---|\n", synopsis(command));
  for (const OptionFacts& option : command.positionals) text += markdown_option(option);
  std::string group = "Options";
  for (const OptionFacts& option : command.options) {
    if (option.group != group) text += fmt::format("| **{}** | |\n", option.group);
    group = option.group;
    text += markdown_option(option);
  }
  return text;
}

// ---- The command

constexpr std::string_view kManualFormats[] = {"roff", "markdown"};

/// Hidden: for those who package rigor and write its reference.
class Manual final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    program_ = &program;
    CLI::App* app = add_command(program, "man", "Print a man page, or write all of them",
                                {"rigor man validate | man -l -", "rigor man -o share/man/man1",
                                 "rigor man --format markdown"});
    app->group("");
    app->add_option("command", command_, "The command; else rigor itself")->type_name("COMMAND");
    offer(app->add_option("--format", format_, "roff, or markdown: one page of all commands")
              ->type_name("NAME"),
          kManualFormats);
    app->add_option("-o,--out", folder_, "Write all pages there, a file each")->type_name("DIR");
    return app;
  }

  int run() override {
    const std::vector<CommandFacts> commands = command_tree(*program_);
    if (choice("format", format_, kManualFormats) == 1) {
      write({0, {}}, commands_markdown(commands));
    } else if (!folder_.empty()) {
      write({0, folder_ + "/rigor.1"}, program_man_page(commands));
      for (const CommandFacts& command : commands) {
        write({0, folder_ + "/rigor-" + command.name + ".1"}, command_man_page(command));
      }
    } else if (command_.empty()) {
      write({0, {}}, program_man_page(commands));
    } else {
      std::vector<std::string_view> names;
      for (const CommandFacts& command : commands) names.push_back(command.name);
      write({0, {}}, command_man_page(commands[choice("command", command_, names)]));
    }
    return kClean;
  }

 private:
  CLI::App* program_ = nullptr;
  std::string command_;
  std::string format_ = "roff";
  std::string folder_;
};

}  // namespace

std::string program_man_page(const std::vector<CommandFacts>& commands) {
  std::string text = roff_title("rigor");
  text += fmt::format(
      ".SH NAME\nrigor \\- {}\n.SH SYNOPSIS\n\\fBrigor\\fR \\fICOMMAND\\fR "
      "[\\fIOPTIONS\\fR] [\\fIPATH\\fR ...]\n",
      roff(kProgramLine));
  text += roff_heading("Description");
  text +=
      "Checks robot models (SDFormat, URDF) and what belongs to them: XML, schema, names, "
      "references, "
      "frames,\ninertia, joints, shapes, meshes and packages. It converts and simulates them, "
      "works "
      "offline, and changes\na file only on request.\n";
  text += roff_heading("Commands");
  for (const CommandFacts& command : commands) {
    text += fmt::format(".TP\n\\fB{}\\fR\n{}. See \\fBrigor\\-{}\\fR(1).\n", roff(command.name),
                        roff(command.description), roff(command.name));
  }
  text += roff_entries("Exit status", kExitCodes) + roff_entries("Environment", kVariables);
  text += roff_examples({"rigor validate my_robot", "rigor inertia my_robot --material abs --write",
                         "rigor simulate my_robot --test settle,drive"});
  return text;
}

std::string command_man_page(const CommandFacts& command) {
  const std::string name = "rigor-" + command.name;
  std::string text = roff_title(name);
  text += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n\\fBrigor\\fR {}\n", roff(name),
                      roff(command.description), roff(synopsis(command)));
  text += roff_heading("Description") + roff(command.description) + ".\n";
  if (!command.positionals.empty()) {
    text += roff_heading("Arguments");
    for (const OptionFacts& option : command.positionals) text += roff_option(option);
  }
  std::string group;
  for (const OptionFacts& option : command.options) {
    if (option.group != group) {
      text += group.empty() ? ".SH OPTIONS\n" : ".SS " + roff(option.group) + '\n';
    }
    group = option.group;
    text += roff_option(option);
  }
  text += roff_entries("Exit status", kExitCodes) + roff_examples(command.examples);
  return text + ".SH SEE ALSO\n\\fBrigor\\fR(1)\n";
}

std::string commands_markdown(const std::vector<CommandFacts>& commands) {
  std::string text =
      "# Commands\n\n<!-- Written by `tools/dev docs` from the commands themselves. -->\n\n";
  for (const CommandFacts& command : commands) {
    text += fmt::format("- [rigor {0}](#rigor-{0}): {1}\n", command.name,
                        markdown_text(command.description));
  }
  text += "\n| exit code | meaning |\n|---:|---|\n";
  for (const Entry& code : kExitCodes) text += fmt::format("| {} | {} |\n", code.name, code.text);
  text += "\n| variable | what it sets |\n|---|---|\n";
  for (const Entry& variable : kVariables) {
    text += fmt::format("| {} | {} |\n", markdown_text(variable.name), variable.text);
  }
  for (const CommandFacts& command : commands) text += markdown_command(command);
  return text;
}

std::unique_ptr<Command> manual_command() { return std::make_unique<Manual>(); }

}  // namespace rigor::tool
