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
#include "selection.h"

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
    selection_.declare(*app);
    app->add_flag("--no-mesh", no_mesh_, "Do not open meshes");
    app->add_option("--stdin-filename", stdin_filename_, "Name of what - reads")->type_name("PATH");
    search_.declare(*app);
    return app;
  }

  int run() override {
    const std::vector<Target> targets = output_.targets();
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
    return exit_code(result);
  }

 private:
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
    options.selection = selection_.selection();
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

  int exit_code(const rules::ValidateResult& result) const {
    if (!result.unusable.empty()) return kUsage;
    return selection_.fails(result.diagnostics) ? kFindings : kClean;
  }

  std::vector<std::string> paths_;
  OutputOptions output_;
  ColorOption color_;
  SelectionOptions selection_;
  bool no_mesh_ = false;
  std::string stdin_filename_;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> validate_command() { return std::make_unique<Validate>(); }

}  // namespace rigor::tool
