// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor diff A B`: what differs between two models as robots.

#include <optional>
#include <string>
#include <vector>

#include <rigor/report/robot_diff/robot_diff.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/robot/compare.h>
#include <rigor/rules/environment.h>

#include "command/command.h"
#include "model/expansion_map.h"
#include "model/robot_file.h"
#include "option/search.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

struct DiffFormat {
  std::string_view name;
  std::string (*emit)(const report::RobotDiff&);
};
constexpr DiffFormat kDiffFormats[] = {{"text", report::robot_diff_text},
                                       {"json", report::robot_diff_json}};

class Diff final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "diff",
        "Compare two models as robots: links, joints, masses, shapes, colors; in two SDF or two "
        "URDF files also contact, gravity, self-collision, soft limits, sensors, lights, plugins, "
        "transmissions, ros2_control and the world, in two MJCF files armature and friction. Not "
        "compared: "
        "textures and other looks",
        {"rigor diff old/robot.urdf robot.urdf", "rigor diff arm.sdf arm.urdf --format json",
         "rigor diff arm.urdf.xacro length:=2 arm.urdf.xacro length:=3"});
    option_a_ = app->add_option("a", a_,
                                "A model file, or a folder with a model.config; name:=value behind "
                                "it is an argument of this file alone, if it is a xacro file")
                    ->required()
                    ->type_name("A");
    option_b_ = app->add_option("b", b_, "The one to compare it with, and its arguments behind it")
                    ->required()
                    ->type_name("B");
    app->add_option("--model", model_, "Name of one of several models in a file")
        ->type_name("NAME");
    output_.declare(*app, {"text", "json"});
    search_.declare(*app);
    return app;
  }

  int run() override {
    const std::vector<Target> targets = output_.targets();
    const GuardedDisk disk = search_.disk({a_, b_});
    Environment environment(disk, search_.paths());
    search_.allow(environment.workers);
    Sources sources;
    read::Workspace workspace(environment.resolver, sources);
    RobotFiles files(environment, sources, workspace);
    const auto load = [&](const std::string& path, std::size_t number, const CLI::Option* file) {
      return files.load(path, number, search_.arguments_of(*file, {option_a_, option_b_}));
    };
    const read::Loaded loaded_a = load(a_, 1, option_a_);
    const read::Loaded loaded_b = load(b_, 2, option_b_);
    const std::optional<robot::Robot> a = files.robot(loaded_a, model_);
    const std::optional<robot::Robot> b = files.robot(loaded_b, model_);
    if (!a || !b) return kFindings;
    if (!model_.empty() && a->name != model_ && b->name != model_) {
      throw UsageError("no model is called " + model_ + did_you_mean(model_, {a->name, b->name}));
    }
    const robot::Correspondence all{.one_format = loaded_a.root.format == loaded_b.root.format,
                                    .helpers = robot::Helpers::kReported,
                                    .placement = robot::Placement::kReported};
    std::vector<robot::Difference> differences = robot::compare(*a, *b, all);
    const auto settings = files.review_settings(loaded_a, model_, loaded_b, model_);
    differences.insert(differences.end(), settings.differences.begin(), settings.differences.end());
    place_in_source(differences, *loaded_a.file, *loaded_b.file, sources);
    const report::RobotDiff diff{{loaded_a.file->path, *a},
                                 {loaded_b.file->path, *b},
                                 differences,
                                 sources,
                                 settings.not_compared};
    for (const Target& target : targets) write(target, kDiffFormats[target.format].emit(diff));
    if (!settings.not_compared.empty()) {
      say("rigor: " + settings.why + ", so not compared: " + std::string(settings.not_compared));
    }
    if (differences.empty()) return kClean;
    say("rigor: " + report::counted(differences.size(), "difference"));
    return kFindings;
  }

 private:
  std::string a_, b_, model_;
  const CLI::Option* option_a_ = nullptr;
  const CLI::Option* option_b_ = nullptr;
  OutputOptions output_;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> diff_command() { return std::make_unique<Diff>(); }

}  // namespace rigor::tool
