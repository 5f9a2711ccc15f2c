// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/validate.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <rigor/report/github.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/shown.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/report/validation.h>
#include <rigor/text/grouping.h>
#include "command/command.h"
#include "option/baseline_options.h"
#include "option/fix_options.h"
#include "option/show_options.h"
#include "option/validation_format.h"
#include "output/output.h"
#include "project/checking.h"
#include "project/project.h"
#include "project/show_config.h"
#include "watch/watch.h"

namespace rigor::tool {
namespace {

/// What the command line says besides.
struct ValidateArguments : CheckArguments {
  OutputOptions output;
  ColorOption color;
  FixOptions fix;
  BaselineOptions baseline;
  bool watch = false;
  ShowConfigOption show_config;
  ShowOptions show;
};

constexpr std::string_view kXacroArgs[] = {"all"};

void conclude(const rules::ValidateResult& result) {
  for (const std::string& argument : result.unusable) {
    say("rigor: " + report::printable(argument));
  }
  std::string left_out = report::left_out(result);
  if (!left_out.empty()) left_out.pop_back();
  if (!left_out.empty()) say(left_out);
  say(report::summary_of_groups(result));
}

class Validate final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app =
        add_command(program, "validate", "Check robot models",
                    {"rigor validate my_robot", "rigor validate --format json robot.urdf",
                     "rigor validate robot.urdf.xacro prefix:=left_",
                     "rigor validate --select inertia --fail-on warning .",
                     "rigor validate --fix --changed-since origin/main"});
    app->add_option("paths", a_.paths,
                    "Files and folders; - is stdin (default: .); name:=value is an argument of "
                    "xacro files")
        ->type_name("PATH");
    a_.output.declare(*app, validation_formats());
    a_.color.declare(*app);
    a_.show.declare(*app);
    a_.selection.declare(*app);
    a_.compat.declare(*app);
    a_.fix.declare(*app);
    a_.baseline.declare(*app);
    a_.files.declare(*app);
    a_.changed_since.declare(*app);
    app->add_flag("--watch", a_.watch, "Check again whenever a file changes; Ctrl-C ends");
    offer(app->add_option("--xacro-args", xacro_args_,
                          "all: expand templates with every value of the arguments that their "
                          "conditionals depend on"),
          kXacroArgs)
        ->type_name("all");
    app->add_flag("--no-mesh", a_.no_mesh,
                  "Do not open meshes, nor assemble models that have some");
    app->add_option("-j,--jobs", a_.jobs, "Threads; 0, the default: as many as there are cores")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
    a_.shard.declare(*app, "Only this part of the files");
    a_.cache.declare(*app);
    app->add_option("--stdin-filename", a_.stdin_filename, "File name for stdin (-)")
        ->type_name("PATH");
    a_.search.declare(*app);
    a_.show_config.declare(*app);
    return app;
  }

  int run() override {
    const std::vector<Target> targets = a_.output.targets();
    a_.show.check(targets);
    if (a_.watch) require_pretty("--watch", targets);
    if (a_.fix.diff()) require_pretty("--diff", targets);
    if (!xacro_args_.empty()) choice("--xacro-args", xacro_args_, kXacroArgs);
    a_.all_arguments = !xacro_args_.empty();
    a_.search.config().open();
    if (a_.watch) return watch_files();
    const GuardedDisk disk = a_.search.unchecked_disk(a_.named());
    Checking checking(a_, disk);
    if (a_.show_config.asked()) {
      return a_.show_config.run(checking.settings(), a_.search.config(), a_.output);
    }
    checking.refuse_bad_settings();
    const std::vector<std::string_view> names = validation_formats();
    const bool lines = std::any_of(targets.begin(), targets.end(), [&names](const Target& target) {
      return names[target.format] == "jsonl";
    });
    if (lines) checking.options().mesh_listing = rules::MeshListing::kListed;
    a_.baseline.read(a_.search.config().disk(),
                     a_.search.config().baseline(checking.options().paths));

    auto sources = std::make_unique<Sources>();
    rules::ValidateResult result = checking.run(*sources);
    if (a_.fix.asked()) {
      const bool changed = a_.fix.run(checking.environment(), checking.options(), result, *sources);
      if (a_.fix.diff()) {
        result = a_.baseline.apply(checking.environment(), checking.options(), std::move(result));
        conclude(result);
        a_.fix.hint(result.diagnostics);
        const int code = exit_code(checking, result);
        return code == kClean && changed ? kFindings : code;
      }
      if (changed) {
        sources = std::make_unique<Sources>();
        result = checking.run(*sources);
      }
    }
    result = a_.baseline.apply(checking.environment(), checking.options(), std::move(result));
    const int code = exit_code(checking, result);
    const RuleSettings& settings = checking.settings();
    const TerminalView view = a_.show.view(result, settings);
    print(targets,
          {result, *sources, checking.environment().registry, project_folders(), code,
           [&settings](const std::string& path) {
             return settings.fail_on(path).value_or(Severity::kError);  // the report still says it
           }},
          checking.options(), view);
    if (std::any_of(targets.begin(), targets.end(),
                    [](const Target& target) { return is_for_people(target.format); })) {
      const std::string left = report::not_shown(grouped(result.diagnostics), view.least);
      if (!left.empty()) say(left);
    }
    if (const auto nothing = checking.nothing_changed()) say(*nothing);
    conclude(result);
    a_.baseline.conclude();
    a_.fix.hint(result.diagnostics);
    return code;
  }

 private:
  int watch_files() {
    if (a_.fix.asked() || std::count(a_.paths.begin(), a_.paths.end(), "-") > 0) {
      throw UsageError("--watch cannot be combined with - (stdin) or with fixes");
    }
    const GuardedDisk real = a_.search.unchecked_disk(a_.named());
    a_.baseline.read(a_.search.config().disk(), a_.search.config().baseline(a_.paths));
    return watch(
        real,
        [&](const Disk& disk, Sources& sources) {
          a_.search.config().reopen(disk);
          Checking checking(a_, disk);
          checking.refuse_bad_settings();
          return a_.baseline.apply(checking.environment(), checking.options(),
                                   checking.run(sources));
        },
        conclude, a_.color.of({0, {}}), a_.show.least());
  }

  /// What prints no report of its own takes no other format for it.
  static void require_pretty(const std::string& option, const std::vector<Target>& targets) {
    const bool pretty = targets.size() == 1 && targets[0].format == 0 && targets[0].file.empty();
    if (!pretty) throw UsageError(option + " cannot be combined with another format or report");
  }

  void print(const std::vector<Target>& targets, const report::Validation& validation,
             const rules::ValidateOptions& options, TerminalView view) const {
    const std::vector<std::string_view> names = validation_formats();
    for (const Target& target : targets) {
      a_.fix.write(target, emit(target.format, validation, a_.color.of(target), view), options);
      if (names[target.format] != "github") continue;
      add_to_step_summary(report::github_summary(validation));
    }
  }

  int exit_code(const Checking& checking, const rules::ValidateResult& result) const {
    const int code = checking.exit_code(result);
    return code == kClean && a_.baseline.fails() ? kFindings : code;
  }

  ValidateArguments a_;
  std::string xacro_args_;
};

}  // namespace

std::unique_ptr<Command> validate_command() { return std::make_unique<Validate>(); }

}  // namespace rigor::tool
