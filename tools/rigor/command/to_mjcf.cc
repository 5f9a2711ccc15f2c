// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor sdf2mjcf` and `rigor urdf2mjcf`: a model as MJCF, with its meshes and a scene.

#include <rigor/mass/mesh/reads.h>
#include <rigor/read/srdf/srdf.h>
#include <rigor/text/path.h>
#include <rigor/view/drawing/files.h>
#include <rigor/view/drawing/looks.h>

#include "model/conversion.h"
#include "model/model_file.h"
#include "option/numbers.h"

namespace rigor::tool {
namespace {

// The first is the default.
constexpr std::string_view kMjcfActuatorNames[] = {"motor", "position", "velocity", "none"};
constexpr std::string_view kMjcfFixedNames[] = {"keep", "lump"};
constexpr std::string_view kMjcfSelfCollisions[] = {"source", "all"};
constexpr std::string_view kMjcfBaseNames[] = {"free", "world"};

class ToMjcf final : public Command {
 public:
  ToMjcf(model::Format from, std::string name)
      : from_(from), name_(std::move(name)), common_(from, ".xml") {}

  CLI::App* declare(CLI::App& program) override {
    const bool sdf = from_ == model::Format::kSdf;
    const std::string in = sdf ? "model.sdf" : "robot.urdf";
    CLI::App* app = add_command(
        program, name_,
        std::string("Convert ") + (sdf ? "SDF models" : "a URDF robot") + " to MJCF, for MuJoCo",
        {"rigor " + name_ + " " + in + " -o mjcf/robot.xml",
         "rigor " + name_ + " " + in + " -o robot.xml --actuators position",
         "rigor " + name_ + " " + in + " -o robot.xml --fixed lump"});
    common_.declare(*app);
    if (sdf) {
      app->add_option("--model", how_.model, "Model to convert, if the file has several: else all")
          ->type_name("NAME");
    }
    app->add_option(
           "--srdf", srdf_,
           "SRDF whose state `home` is the keyframe, and whose disabled pairs do not touch")
        ->type_name("FILE");
    app->add_option("--armature", armature_,
                    "Inertia of the rotor that is added to each joint: kg·m², or kg of a slide")
        ->type_name("NUMBER");
    const std::string group = "Where MJCF allows a choice (the first is the default)";
    const auto policy = [&](const std::string& option, std::string& value, const char* what,
                            Names known) {
      offer(app->add_option(option, value, what)->group(group), known);
    };
    policy("--actuators", actuators_,
           "Actuators of joints with an effort limit: motor, position, velocity, none",
           kMjcfActuatorNames);
    policy("--fixed", fixed_, "Links on fixed joints: keep, lump (into the parent body)",
           kMjcfFixedNames);
    policy("--self-collision", self_collision_,
           "Contact between links of one model: source (as self_collide says), all (but neighbors)",
           kMjcfSelfCollisions);
    policy("--base", base_, "A root that nothing carries: free, world (fixed to it)",
           kMjcfBaseNames);
    return app;
  }

  int run() override {
    convert::MjcfOptions how = options();
    return common_.run([this, &how](const Environment& environment, Sources& sources,
                                    read::Workspace& workspace, const read::Loaded& loaded,
                                    const author::ConversionOptions& options) {
      if (!how.model.empty()) require_model(how.model, {&loaded.root});
      if (!srdf_.empty()) add_srdf(workspace, how);
      mass::MeshReads reads(environment.disk, environment.workers);
      how.looks = view::looks_of(loaded.root, sources,
                                 view::files_of(environment.resolver, sources, reads));
      return author::to_mjcf(environment, sources, workspace, loaded, how, options);
    });
  }

 private:
  static std::size_t chosen(const char* option, const std::string& value, Names known) {
    return value.empty() ? 0 : choice(option, value, known);
  }

  /// `home` of all groups; where two of them place a joint, the first does.
  void add_srdf(read::Workspace& workspace, convert::MjcfOptions& how) const {
    const read::File& file = workspace.open(srdf_);
    const bool whole = file.document && file.document->complete() && file.document->root() &&
                       file.document->root()->name() == "robot";
    if (!whole) throw UsageError("--srdf " + srdf_ + ": is no SRDF that can be read");
    const read::Srdf srdf = read::read_srdf(*file.document->root());
    for (const read::SrdfPosition& position : srdf.positions) {
      if (position.state == "home") how.home.try_emplace(position.joint.text, position.value);
    }
    how.excluded.assign(srdf.disabled.begin(), srdf.disabled.end());
  }

  convert::MjcfOptions options() const {
    convert::MjcfOptions how = how_;
    how.actuators = static_cast<convert::MjcfActuators>(
        chosen("--actuators value", actuators_, kMjcfActuatorNames));
    how.fixed = static_cast<convert::MjcfFixed>(chosen("--fixed value", fixed_, kMjcfFixedNames));
    how.self_collision = static_cast<convert::MjcfSelfCollision>(
        chosen("--self-collision value", self_collision_, kMjcfSelfCollisions));
    how.base = static_cast<convert::MjcfBase>(chosen("--base value", base_, kMjcfBaseNames));
    if (!armature_.empty()) how.armature = positive_number("--armature", armature_, "");
    how.file = common_.result_name();
    how.files = common_.writes_file() ? convert::MjcfFiles::kWritten : convert::MjcfFiles::kNone;
    return how;
  }

  model::Format from_;
  std::string name_;
  ConversionCommand common_;
  convert::MjcfOptions how_;
  std::string actuators_, fixed_, self_collision_, base_, armature_, srdf_;
};

}  // namespace

std::unique_ptr<Command> sdf2mjcf_command() {
  return std::make_unique<ToMjcf>(model::Format::kSdf, "sdf2mjcf");
}

std::unique_ptr<Command> urdf2mjcf_command() {
  return std::make_unique<ToMjcf>(model::Format::kUrdf, "urdf2mjcf");
}

}  // namespace rigor::tool
