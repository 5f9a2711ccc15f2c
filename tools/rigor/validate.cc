// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/validate.h>

#include <cstdio>
#include <iterator>
#include <utility>

#include <rigor/environment.h>
#include <rigor/read/workspace.h>
#include <rigor/report/concise.h>
#include <rigor/report/json.h>
#include <rigor/report/pretty.h>
#include <rigor/report/printable.h>
#include <rigor/report/summary.h>
#include "command.h"
#include "output.h"
#include "search.h"

namespace rigor::tool {
namespace {

struct ValidateFormat {
  std::string_view name;
  std::string (*emit)(const rules::ValidateResult&, const Sources&, report::Color);
};

constexpr ValidateFormat kValidateFormats[] = {
    {"pretty",
     [](const rules::ValidateResult& result, const Sources& sources, report::Color color) {
       return report::pretty(result.diagnostics, sources, color);
     }},
    {"concise", [](const rules::ValidateResult& result, const Sources& sources,
                   report::Color) { return report::concise(result.diagnostics, sources); }},
    {"json", [](const rules::ValidateResult& result, const Sources& sources,
                report::Color) { return report::json(result, sources); }},
};

std::vector<std::string_view> format_names() {
  std::vector<std::string_view> names;
  for (const ValidateFormat& format : kValidateFormats) names.push_back(format.name);
  return names;
}

/// All of stdin, and one byte more than a model may have at most: enough to tell.
std::string read_stdin() {
  std::string bytes;
  char buffer[65536];
  while (bytes.size() <= read::kMaxModelBytes) {
    const std::size_t count = std::fread(buffer, 1, sizeof(buffer), stdin);
    if (count == 0) break;
    bytes.append(buffer, count);
  }
  return bytes;
}

Severity severity_named(const std::string& name) {
  constexpr Severity kAll[] = {Severity::kError, Severity::kWarning, Severity::kInfo};
  return kAll[choice("severity", name, {"error", "warning", "info"})];
}

void require_known(const rules::Selection& selection, const rules::Registry& registry) {
  const std::optional<std::string> unknown = unknown_name(selection, registry);
  if (!unknown) return;
  std::vector<std::string_view> known;
  for (const rules::Rule& rule : registry.rules()) {
    known.push_back(rule.name);
    const std::string_view category = to_string(rule.category);
    if (std::find(known.begin(), known.end(), category) == known.end()) known.push_back(category);
  }
  const std::string hint = did_you_mean(*unknown, known);
  throw UsageError("unknown rule \"" + *unknown + '"' +
                   (hint.empty() ? "; `rigor rules` lists them" : hint));
}

class Validate final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app =
        add_command(program, "validate", "Check robot models",
                    {"rigor validate my_robot", "rigor validate --format json robot.urdf",
                     "rigor validate --select inertia --fail-on warning ."});
    app->add_option("paths", paths_, "Files and folders; - is stdin (default: .)")
        ->type_name("PATH");
    output_.declare(*app, format_names());
    color_.declare(*app);
    app->add_option("--fail-on", fail_on_,
                    "Least severity that makes the exit code 1: "
                    "error (default), warning, info, never")
        ->type_name("LEVEL");
    list_option(*app, "--select", select_, "Only these rules or categories");
    list_option(*app, "--ignore", ignore_, "Not these rules or categories");
    app->add_option("--severity", severity_, "Give a rule another severity: error, warning, info")
        ->type_name("RULE=LEVEL")
        ->allow_extra_args(false);
    app->add_flag("--no-mesh", no_mesh_, "Do not open meshes");
    app->add_option("--stdin-filename", stdin_filename_, "Name of what - reads")->type_name("PATH");
    search_.declare(*app);
    return app;
  }

  int run() override {
    const std::vector<Target> targets = output_.targets();
    const std::size_t fail_on =
        choice("--fail-on level", fail_on_, {"error", "warning", "info", "never"});
    const RealDisk disk;
    const Environment environment(disk, search_.paths());
    const rules::ValidateOptions options = validate_options();
    require_known(options.selection, environment.registry);

    Sources sources;
    const rules::ValidateResult result = rules::validate(environment, options, sources);
    for (const Target& target : targets) {
      write(target, kValidateFormats[target.format].emit(result, sources, color_.of(target)));
    }
    conclude(result);
    return exit_code(result, fail_on);
  }

 private:
  static void list_option(CLI::App& app, const std::string& name, std::vector<std::string>& list,
                          const std::string& description) {
    app.add_option(name, list, description)
        ->type_name("RULE,...")
        ->delimiter(',')
        ->allow_extra_args(false);
  }

  rules::ValidateOptions validate_options() const {
    rules::ValidateOptions options;
    for (const std::string& path : paths_) {
      if (path != "-") {
        options.paths.push_back(path);
      } else if (!options.buffer) {
        options.buffer = {stdin_filename_.empty() ? "<stdin>" : stdin_filename_, read_stdin()};
        if (options.buffer->bytes.size() > read::kMaxModelBytes) {
          throw UsageError("stdin holds more than the 64 MiB that a model may have");
        }
      }
    }
    if (!stdin_filename_.empty() && !options.buffer) {
      throw UsageError("--stdin-filename names what - reads, and there is no - among the paths");
    }
    if (options.paths.empty() && !options.buffer) options.paths.push_back(".");
    options.selection.select = select_;
    options.selection.ignore = ignore_;
    for (const std::string& text : severity_) {
      auto [rule, level] = split_assignment("--severity", text);
      options.selection.severity.emplace_back(std::move(rule), severity_named(level));
    }
    options.meshes = no_mesh_ ? rules::MeshPolicy::kDoNotOpen : rules::MeshPolicy::kOpen;
    return options;
  }

  static void conclude(const rules::ValidateResult& result) {
    for (const std::string& argument : result.unusable) {
      say("rigor: " + report::printable(argument));
    }
    std::string left_out = report::left_out(result);
    if (!left_out.empty()) left_out.pop_back();
    if (!left_out.empty()) say(left_out);
    say(report::summary(result));
  }

  static int exit_code(const rules::ValidateResult& result, std::size_t fail_on) {
    if (!result.unusable.empty()) return kUsage;
    // "error" fails on one severity, "warning" on two, "info" on three, "never" on none.
    const std::size_t failing = fail_on == 3 ? 0 : fail_on + 1;
    constexpr Severity kAll[] = {Severity::kError, Severity::kWarning, Severity::kInfo};
    for (std::size_t i = 0; i < failing; ++i) {
      if (result.diagnostics.count(kAll[i]) > 0) return kFindings;
    }
    return kClean;
  }

  std::vector<std::string> paths_;
  OutputOptions output_;
  ColorOption color_;
  std::string fail_on_ = "error";
  std::vector<std::string> select_;
  std::vector<std::string> ignore_;
  std::vector<std::string> severity_;
  bool no_mesh_ = false;
  std::string stdin_filename_;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> validate_command() { return std::make_unique<Validate>(); }

}  // namespace rigor::tool
