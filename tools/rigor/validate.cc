// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/validate.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <rigor/environment.h>
#include <rigor/mass/mesh_reads.h>
#include <rigor/read/workspace.h>
#include <rigor/report/github.h>
#include <rigor/report/printable.h>
#include <rigor/report/summary.h>
#include "baseline_options.h"
#include "cache.h"
#include "changed_since.h"
#include "command.h"
#include "compat_option.h"
#include "file_options.h"
#include "fix_options.h"
#include "output.h"
#include "project.h"
#include "rule_settings.h"
#include "search.h"
#include "selection.h"
#include "shard_option.h"
#include "show_config.h"
#include "validation_format.h"
#include "watch.h"
#include "xacro.h"

namespace rigor::tool {
namespace {

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

/// What the command line says.
struct ValidateArguments {
  std::vector<std::string> paths;
  std::string stdin_filename;
  OutputOptions output;
  ColorOption color;
  SelectionOptions selection;
  CompatOption compat;
  FixOptions fix;
  BaselineOptions baseline;
  FileOptions files;
  ChangedSinceOption changed_since;
  bool watch = false;
  bool no_mesh = false;
  unsigned jobs = 0;
  ShardOption shard;
  CacheOption cache;
  SearchOptions search;
  ShowConfigOption show_config;
};

/// What checking takes, on a disk: made once for all that is done with it.
class Checking {
 public:
  Checking(const ValidateArguments& a, const Disk& disk)
      : environment_(disk, a.search.paths()),
        settings_(a.selection, a.search.config(), environment_.registry),
        changed_(
            a.changed_since.changed(a.paths.empty() ? std::vector<std::string>{"."} : a.paths)),
        cache_(a.cache.cache()),
        reads_(disk),
        surveys_(disk, {cache_ ? &*cache_ : nullptr, &reads_}),
        mesh_files_(disk, mass::MeshDepth::kFile, {cache_ ? &*cache_ : nullptr, &reads_}) {
    choose_files(a, disk);
    options_.selection_for = [this, compat = a.compat.compat()](const std::string& path) {
      rules::Selection selection = settings_.selection(path);
      selection.compat = compat;
      return selection;
    };
    options_.threads = a.jobs;
    options_.shard = a.shard.shard();
    options_.meshes = a.no_mesh ? rules::MeshPolicy::kDoNotOpen : rules::MeshPolicy::kOpen;
    options_.known = {&surveys_, &mesh_files_};
    if (!a.no_mesh && checks_many(disk)) reads_.expect_many();
  }
  Checking(const Checking&) = delete;
  Checking& operator=(const Checking&) = delete;

  const Environment& environment() const { return environment_; }
  const RuleSettings& settings() const { return settings_; }
  rules::ValidateOptions& options() { return options_; }

  /// Before anything else asks the configurations: a UsageError that tells of all that is wrong in one.
  void refuse_bad_settings() const {
    for (const std::string& path : options_.paths) settings_.selection(path);
  }

  rules::ValidateResult run(Sources& sources) const {
    return rules::validate(environment_, options_, sources);
  }

  /// That `--changed-since` left no file, when it did.
  std::optional<std::string> nothing_changed() const {
    return changed_ ? changed_->nothing() : std::nullopt;
  }

 private:
  bool checks_many(const Disk& disk) const {
    const auto& paths = options_.paths;
    return paths.size() > 1 || (paths.size() == 1 && disk.kind(paths[0]) == PathKind::kFolder);
  }

  void choose_files(const ValidateArguments& a, const Disk& disk) {
    options_.discover = a.files.discover();
    options_.discover.excluded = [&config = a.search.config()](const std::string& path,
                                                               PathKind kind) {
      return config.why_excluded(path, kind);
    };
    if (changed_) {
      options_.discover.wanted = [this, &disk](const std::string& path) {
        return changed_->concern(disk, environment_.resolver, path);
      };
    }
    options_.expand = expand_xacro;
    for (const std::string& path : a.paths) {
      if (path != "-") {
        options_.paths.push_back(path);
      } else if (!options_.buffer) {
        options_.buffer = {a.stdin_filename.empty() ? "<stdin>" : a.stdin_filename, read_stdin()};
        if (options_.buffer->bytes.size() > read::kMaxModelBytes) {
          throw UsageError("stdin holds more than the 64 MiB that a model may have");
        }
      }
    }
    if (!a.stdin_filename.empty() && !options_.buffer) {
      throw UsageError("--stdin-filename names what - reads, and there is no - among the paths");
    }
    if (options_.paths.empty() && !options_.buffer) options_.paths.push_back(".");
  }

  Environment environment_;
  RuleSettings settings_;
  std::optional<ChangedFiles> changed_;
  std::optional<mass::MeshCache> cache_;
  mass::MeshReads reads_;
  mass::MeshSurveys surveys_;
  mass::MeshFiles mesh_files_;
  rules::ValidateOptions options_;
};

void conclude(const rules::ValidateResult& result) {
  for (const std::string& argument : result.unusable) {
    say("rigor: " + report::printable(argument));
  }
  std::string left_out = report::left_out(result);
  if (!left_out.empty()) left_out.pop_back();
  if (!left_out.empty()) say(left_out);
  say(report::summary(result));
}

class Validate final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app =
        add_command(program, "validate", "Check robot models",
                    {"rigor validate my_robot", "rigor validate --format json robot.urdf",
                     "rigor validate --select inertia --fail-on warning .",
                     "rigor validate --fix --changed-since origin/main"});
    app->add_option("paths", a_.paths, "Files and folders; - is stdin (default: .)")
        ->type_name("PATH");
    a_.output.declare(*app, validation_formats());
    a_.color.declare(*app);
    a_.selection.declare(*app);
    a_.compat.declare(*app);
    a_.fix.declare(*app);
    a_.baseline.declare(*app);
    a_.files.declare(*app);
    a_.changed_since.declare(*app);
    app->add_flag("--watch", a_.watch, "Check again whenever a file changes; Ctrl-C ends");
    app->add_flag("--no-mesh", a_.no_mesh, "Do not open meshes");
    app->add_option("-j,--jobs", a_.jobs, "Threads; 0, the default: as many as there are cores")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
    a_.shard.declare(*app, "Only this part of the files");
    a_.cache.declare(*app);
    app->add_option("--stdin-filename", a_.stdin_filename, "Name of what - reads")
        ->type_name("PATH");
    a_.search.declare(*app);
    a_.show_config.declare(*app);
    return app;
  }

  int run() override {
    const std::vector<Target> targets = a_.output.targets();
    if (a_.watch) require_pretty("--watch", targets);
    if (a_.fix.diff()) require_pretty("--diff", targets);
    a_.search.config().open();
    if (a_.watch) return watch_files();
    const RealDisk disk;
    Checking checking(a_, disk);
    if (a_.show_config.asked()) {
      return a_.show_config.run(checking.settings(), a_.search.config(), a_.output);
    }
    checking.refuse_bad_settings();
    a_.baseline.read(disk, a_.search.config().baseline(checking.options().paths));

    auto sources = std::make_unique<Sources>();
    rules::ValidateResult result = checking.run(*sources);
    if (a_.fix.asked()) {
      const bool changed = a_.fix.run(checking.environment(), checking.options(), result, *sources);
      if (a_.fix.diff()) return end_with_diff(result, changed);
      if (changed) {
        sources = std::make_unique<Sources>();
        result = checking.run(*sources);
      }
    }
    result = a_.baseline.apply(checking.environment(), checking.options(), std::move(result));
    const int code = exit_code(checking.settings(), result);
    print(targets, {result, *sources, checking.environment().registry, project_folders(), code},
          checking.options());
    if (const auto nothing = checking.nothing_changed()) say(*nothing);
    conclude(result);
    a_.baseline.conclude();
    a_.fix.hint(result.diagnostics);
    return code;
  }

 private:
  int watch_files() {
    if (a_.fix.asked() || std::count(a_.paths.begin(), a_.paths.end(), "-") > 0) {
      throw UsageError("--watch checks files again and again: it goes with neither - nor fixes");
    }
    a_.baseline.read(RealDisk(), a_.search.config().baseline(a_.paths));
    return watch(
        [&](const Disk& disk, Sources& sources) {
          a_.search.config().reopen(disk);
          Checking checking(a_, disk);
          checking.refuse_bad_settings();
          return a_.baseline.apply(checking.environment(), checking.options(),
                                   checking.run(sources));
        },
        conclude, a_.color.of({0, {}}));
  }

  /// What prints no report of its own takes no other format for it.
  static void require_pretty(const std::string& option, const std::vector<Target>& targets) {
    const bool pretty = targets.size() == 1 && targets[0].format == 0 && targets[0].file.empty();
    if (!pretty) throw UsageError(option + " goes with no other format and writes no reports");
  }

  int end_with_diff(const rules::ValidateResult& result, bool changed) const {
    conclude(result);
    a_.fix.hint(result.diagnostics);
    if (!result.unusable.empty()) return kUsage;
    return changed ? kFindings : kClean;
  }

  void print(const std::vector<Target>& targets, const report::Validation& validation,
             const rules::ValidateOptions& options) const {
    const std::vector<std::string_view> names = validation_formats();
    for (const Target& target : targets) {
      a_.fix.write(target, emit(target.format, validation, a_.color.of(target)), options);
      if (names[target.format] != "github") continue;
      add_to_step_summary(report::github_summary(validation));
    }
  }

  /// Whether an argument is a file that nobody can read: then the invocation is wrong.
  bool names_unreadable(const rules::ValidateResult& result) const {
    const auto& found = result.diagnostics.list();
    return std::any_of(found.begin(), found.end(), [this](const Diagnostic& diagnostic) {
      return diagnostic.rule == "file-unreadable" &&
             std::count(a_.paths.begin(), a_.paths.end(), diagnostic.path) > 0;
    });
  }

  int exit_code(const RuleSettings& settings, const rules::ValidateResult& result) const {
    if (!result.unusable.empty() || names_unreadable(result)) return kUsage;
    return a_.baseline.fails() || settings.fails(result) ? kFindings : kClean;
  }

  ValidateArguments a_;
};

}  // namespace

std::unique_ptr<Command> validate_command() { return std::make_unique<Validate>(); }

}  // namespace rigor::tool
