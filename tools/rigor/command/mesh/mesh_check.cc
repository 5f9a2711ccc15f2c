// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor mesh-check`: the checks, and which of the things that change files is asked for.

#include "command/mesh/mesh_check.h"

#include <algorithm>
#include <string>
#include <vector>

#include <rigor/report/mesh_check/mesh_report.h>
#include <rigor/report/terminal/concise.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/grouping.h>

#include "command/command.h"

namespace rigor::tool {
namespace {

class MeshCheck final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "mesh-check", "Check, repair, center, scale, reduce and convert meshes",
        {"rigor mesh-check meshes/chassis.dae", "rigor mesh-check my_robot",
         "rigor mesh-check scan.stl --repair --unit mm --center bottom --reduce 5000 -o hull.dae",
         "rigor mesh-check hull.stl --fit best -o collision.stl",
         "rigor mesh-check hull.dae --attach my_robot::chassis::visual",
         "rigor mesh-check my_robot --center com --apply"});
    app->add_option("paths", a_.paths, "Mesh files, models, or folders that hold models")
        ->type_name("FILE|MODEL");
    app->add_option("-o,--out", a_.out, "Write the mesh there: .stl, .obj, .dae, .glb or .ply")
        ->type_name("FILE");
    a_.operations.declare(*app);
    const std::string group = "In a model";
    app->add_option("--attach", a_.attach,
                    "Put the mesh in place of a visual's or collision's shape")
        ->type_name("MODEL::LINK::SHAPE")
        ->group(group);
    app->add_flag("--apply", a_.apply,
                  "Apply the operations to a model's meshes, and update the model")
        ->group(group);
    app->add_flag("--test-world", a_.test_world, "Write a world with the mesh alone on the ground")
        ->group(group);
    a_.output.declare(*app, {"pretty", "concise", "json"});
    a_.color.declare(*app);
    a_.selection.declare(*app);
    a_.search.declare(*app);
    a_.cache.declare(*app);
    return app;
  }

  int run() override {
    if (a_.paths.empty()) {
      throw UsageError("mesh-check needs a mesh or a model; `rigor mesh-check --help` shows both");
    }
    refuse_contradictions();
    if (a_.apply) return apply_to_model(a_);
    const bool works = !a_.out.empty() || !a_.attach.empty() || !a_.operations.given().empty();
    if (works || a_.test_world) return work_on_mesh(a_);
    return MeshChecking(a_).conclude();
  }

 private:
  void refuse_contradictions() const {
    const std::string changes = a_.operations.given();
    a_.operations.operations();  // says what is wrong with their values, whatever comes of them
    if (a_.apply && !a_.attach.empty()) throw UsageError("--apply and --attach exclude each other");
    if (a_.apply && a_.test_world) throw UsageError("--apply and --test-world exclude each other");
    if (a_.apply && changes.empty()) {
      throw UsageError("--apply needs an operation: --center, --unit, --repair or another");
    }
    if (!changes.empty() && changes != "--fit" && !a_.apply && a_.out.empty()) {
      throw UsageError(changes + " changes the mesh: give the output file with -o OUT");
    }
  }

  MeshCheckArguments a_;
};

}  // namespace

MeshChecking::MeshChecking(const MeshCheckArguments& arguments)
    : arguments_(arguments),
      targets_(arguments.output.targets()),
      real_(arguments.search.disk(arguments.paths)),
      disk_(real_),
      environment_(disk_, arguments.search.paths(arguments.paths)),
      settings_(arguments.selection, arguments.search.config(), environment_.registry),
      cache_(arguments.cache.cache(environment_.workers)),
      files_(disk_, mass::MeshDepth::kAll,
             {.cache = cache_ ? &*cache_ : nullptr, .workers = &environment_.workers}) {
  arguments.search.allow(environment_.workers);
  rules::MeshCheckOptions options{.paths = arguments.paths};
  options.selection_for = [this](const std::string& path) {
    return settings_.selection_of_command(path);
  };
  result_ = rules::mesh_check(environment_, options, files_, sources_);
  result_.diagnostics = withheld(result_.diagnostics, sources_, real_.reach());
}

bool MeshChecking::whole() const {
  return result_.unusable.empty() &&
         std::all_of(result_.meshes.begin(), result_.meshes.end(),
                     [](const rules::CheckedMesh& mesh) { return mesh.facts->whole(); });
}

int MeshChecking::conclude(const MeshWork& work) const {
  const report::MeshCheckReport report{result_, sources_, work.steps, work.fit, work.written};
  for (const Target& target : targets_) {
    switch (target.format) {
      case 0: write(target, mesh_check_text(report, arguments_.color.of(target))); break;
      case 1: write(target, report::concise(grouped(result_.diagnostics), sources_)); break;
      default: write(target, mesh_check_json(report));
    }
  }
  for (const std::string& argument : result_.unusable) say("rigor: " + report::printable(argument));
  for (const read::LeftOut& left : result_.left_out) {
    say("skipped: " + report::printable(left.path + ": " + left.why));
  }
  if (!result_.unusable.empty()) return kUsage;
  say(report::counted(result_.meshes.size(), "mesh", "meshes") + " checked" +
      report::findings(grouped(result_.diagnostics)));
  const bool fails = std::any_of(
      arguments_.paths.begin(), arguments_.paths.end(),
      [&](const std::string& path) { return settings_.fails(path, result_.diagnostics); });
  return fails ? kFindings : kClean;
}

std::unique_ptr<Command> mesh_check_command() { return std::make_unique<MeshCheck>(); }

}  // namespace rigor::tool
