// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor sdf2urdf`: an SDF model as URDF.

#include "model/conversion.h"
#include "model/model_file.h"
#include "option/numbers.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kUrdfVersions[] = {"1.0", "1.1"};
// The first is the default.
constexpr std::string_view kLoopNames[] = {"cut", "comment"};
constexpr std::string_view kShapePolicies[] = {"mesh", "lose"};
constexpr std::string_view kPlanePolicies[] = {"lose", "box"};
constexpr std::string_view kFramePolicies[] = {"links", "drop"};
constexpr std::string_view kModelPoses[] = {"drop", "world-link"};
constexpr std::string_view kStaticPolicies[] = {"block", "world-link"};
constexpr std::string_view kRootPolicies[] = {"refuse", "add"};

class SdfToUrdf final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "sdf2urdf", "Convert a model from SDF to URDF",
                                {"rigor sdf2urdf my_robot -o my_robot.urdf",
                                 "rigor sdf2urdf model.sdf --mesh-uri package://my_robot",
                                 "rigor sdf2urdf model.sdf --check my_robot.urdf"});
    common_.declare(*app);
    app->add_option("--model", how_.model, "Model to convert, if the file has several")
        ->type_name("NAME");
    app->add_option("--mesh-uri", mesh_uri_,
                    "How mesh URIs are written: package://NAME, file or keep")
        ->type_name("HOW");
    offer(app->add_option(
                 "--urdf-version", urdf_version_,
                 "1.0 (the default) or 1.1, which has capsules that an older urdfdom leaves out")
              ->type_name("VERSION"),
          kUrdfVersions);
    app->add_option("--root", how_.root,
                    "Add a root link without mass, such as base_footprint: KDL does not support "
                    "a root link with inertia")
        ->type_name("NAME");
    const std::string group = "Where URDF allows a choice (the first is the default)";
    const auto policy = [&](const std::string& name, std::string& value, const char* what,
                            Names known) {
      offer(app->add_option(name, value, what)->group(group), known);
    };
    policy("--loop", loop_, "A joint that closes a loop: cut, comment", kLoopNames);
    policy("--shapes", shapes_,
           "Shapes that URDF lacks: mesh (files next to the result of -o), lose", kShapePolicies);
    policy("--plane", plane_, "Planes: lose, box (a thin one)", kPlanePolicies);
    policy("--frames", frames_, "Frames: links, drop", kFramePolicies);
    policy("--model-pose", model_pose_, "Pose of the model: drop, world-link", kModelPoses);
    policy("--static", static_, "A static model: block (for Gazebo), world-link", kStaticPolicies);
    policy("--roots", roots_, "Several trees: refuse, add (one root for all)", kRootPolicies);
    app->add_flag("--keep-link-frames", keep_link_frames_,
                  "Links stay where they are, beside the frames of their joints")
        ->group(group);
    app->add_option("--unlimited", unlimited_,
                    "Finite number that represents an unlimited effort, velocity or position")
        ->type_name("NUMBER")
        ->group(group);
    return app;
  }

  int run() override {
    const convert::UrdfOptions how = options();
    return common_.run([&how](const Environment& environment, Sources& sources,
                              read::Workspace& workspace, const read::Loaded& loaded,
                              const author::ConversionOptions& options) {
      require_model(how.model, {&loaded.root});
      return author::to_urdf(environment, sources, workspace, loaded, how, options);
    });
  }

 private:
  static bool second(const char* option, const std::string& value, Names known) {
    return !value.empty() && choice(option, value, known) == 1;
  }

  static convert::MeshUri mesh_uri_of(const std::string& text) {
    using Kind = convert::MeshUri::Kind;
    const auto [naming, name] = mesh_naming(text, {"package"});
    switch (naming) {
      case MeshNaming::kDefault: return {};
      case MeshNaming::kFile: return {Kind::kFile, {}};
      case MeshNaming::kKeep: return {Kind::kKeep, {}};
      case MeshNaming::kScheme: break;
    }
    return {Kind::kPackage, name};
  }

  convert::UrdfOptions options() const {
    convert::UrdfOptions how = how_;
    how.mesh_uri = mesh_uri_of(mesh_uri_);
    if (second("--loop value", loop_, kLoopNames)) how.loop = convert::LoopPolicy::kComment;
    const bool lose_shapes = second("--shapes value", shapes_, kShapePolicies);
    if (!lose_shapes && (common_.writes_file() || !shapes_.empty())) {
      how.shapes = convert::ShapePolicy::kMesh;
    }
    if (second("--plane value", plane_, kPlanePolicies)) how.planes = convert::PlanePolicy::kBox;
    if (second("--frames value", frames_, kFramePolicies)) how.frames = convert::FramePolicy::kDrop;
    if (second("--model-pose value", model_pose_, kModelPoses)) {
      how.model_pose = convert::ModelPosePolicy::kWorldLink;
    }
    if (second("--static value", static_, kStaticPolicies)) {
      how.static_model = convert::StaticPolicy::kWorldLink;
    }
    if (second("--roots value", roots_, kRootPolicies)) how.roots = convert::RootPolicy::kAddRoot;
    if (keep_link_frames_) how.link_frames = convert::LinkFramePolicy::kKeepLinks;
    if (!unlimited_.empty()) how.unlimited = positive_number("--unlimited", unlimited_, "");
    if (!urdf_version_.empty()) {
      how.urdf_version = static_cast<int>(choice("URDF version", urdf_version_, kUrdfVersions));
    }
    return how;
  }

  ConversionCommand common_{model::Format::kSdf, ".urdf"};
  convert::UrdfOptions how_;
  std::string mesh_uri_, urdf_version_, loop_, shapes_, plane_, frames_, model_pose_, static_,
      roots_;
  std::string unlimited_;
  bool keep_link_frames_ = false;
};

}  // namespace

std::unique_ptr<Command> sdf2urdf_command() { return std::make_unique<SdfToUrdf>(); }

}  // namespace rigor::tool
