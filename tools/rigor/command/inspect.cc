// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/inspect/assembled_view.h>
#include <rigor/report/inspect/inspect.h>

#include <algorithm>
#include <utility>

#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/mesh_finder.h>

#include "command/command.h"
#include "model/model_file.h"
#include "option/search.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

struct InspectFormat {
  std::string_view name;
  std::string (*emit)(const report::Inspection&);
};

constexpr InspectFormat kInspectFormats[] = {{"text", report::inspect_text},
                                             {"json", report::inspect_json},
                                             {"tsv", report::inspect_tsv},
                                             {"dot", report::inspect_dot}};

constexpr InspectFormat kAssembledFormats[] = {{"text", report::assembled_text},
                                               {"json", report::assembled_json}};

/// What keeps the model from being whole; empty when nothing does.
std::string problem(const read::Loaded& loaded, const model::Frames& frames) {
  const std::string path = report::printable(loaded.file->path);
  if (!loaded.file->document->complete()) return path + " is not well-formed: this is a part of it";
  if (loaded.root.format == model::Format::kUnknown) return path + " is no robot model";
  if (const std::string unread = unread_part(loaded); !unread.empty()) return path + ' ' + unread;
  const std::size_t lost = lost_includes(loaded);
  if (lost > 0) {
    return report::counted(lost, "include") + " could not be followed";
  }
  if (frames.problems().empty()) return {};
  return report::counted(frames.problems().size(), "frame problem");
}

class Inspect final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "inspect", "Show what a model is once it is resolved",
                                {"rigor inspect robot.urdf", "rigor inspect robot.urdf --assembled",
                                 "rigor inspect arm/model.sdf --format tsv --joint elbow=1.57"});
    app->add_option("path", path_, "A model file, or a folder with a model.config")
        ->required()
        ->type_name("PATH");
    output_.declare(*app, {"text", "json", "tsv", "dot"});
    app->add_option("--joint", joints_, "Position of a joint, rad or m; VALUE,VALUE for two axes")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    app->add_flag(
        "--assembled", assembled_,
        "Show what is seen of the robot as a whole: its size, pairs of parts, wheels, distances");
    search_.declare(*app);
    return app;
  }

  int run() override {
    const std::vector<Target> targets =
        assembled_ ? output_.targets_of({"text", "json"}) : output_.targets();
    const GuardedDisk disk = search_.disk({path_});
    Environment environment(disk, search_.paths());
    search_.allow(environment.workers);
    Sources sources;
    read::Workspace workspace(environment.resolver, sources);
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    const read::Loaded loaded = load(reader, open_model(workspace, path_));

    const model::Frames frames(loaded.root, joint_positions(loaded.root, joints_));
    mass::MeshSurveys surveys(disk, {.workers = &environment.workers});
    const report::Inspection inspection{loaded.file->path, loaded.root, frames,
                                        rules::mesh_finder(environment.resolver, sources, surveys)};
    for (const Target& target : targets)
      write(target,
            (assembled_ ? kAssembledFormats : kInspectFormats)[target.format].emit(inspection));
    tell_unfollowed(loaded);
    const std::string why = problem(loaded, frames);
    if (why.empty()) return kClean;
    say("rigor: " + why + "; run `rigor validate` for details");
    return kFindings;
  }

 private:
  std::string path_;
  OutputOptions output_;
  std::vector<std::string> joints_;
  bool assembled_ = false;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> inspect_command() { return std::make_unique<Inspect>(); }

}  // namespace rigor::tool
