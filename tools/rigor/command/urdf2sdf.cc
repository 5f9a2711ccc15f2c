// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor urdf2sdf`: a URDF robot as an SDF model.

#include "model/conversion.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kSdfVersions[] = {"1.9", "1.10", "1.11"};
constexpr std::string_view kFixedNames[] = {"keep", "lump"};
constexpr std::string_view kMasslessNames[] = {"link", "frame"};
constexpr std::string_view kInertiaNames[] = {"keep", "nearest"};
constexpr std::string_view kControlNames[] = {"keep", "ros2_control", "gz"};

class UrdfToSdf final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "urdf2sdf", "Convert a robot from URDF to SDF",
                                {"rigor urdf2sdf robot.urdf -o model.sdf",
                                 "rigor urdf2sdf robot.urdf --mesh-uri model://my_robot",
                                 "rigor urdf2sdf robot.urdf --check model.sdf"});
    common_.declare(*app);
    app->add_option("--mesh-uri", mesh_uri_,
                    "How mesh URIs are written: model://NAME, package://NAME, file or keep")
        ->type_name("HOW");
    offer(app->add_option("--sdf-version", version_,
                          "1.9 to 1.11 (default: 1.9, or 1.11 for mimic joints)")
              ->type_name("VERSION"),
          kSdfVersions);
    const std::string group = "Where SDF allows a choice (the first is the default)";
    offer(app->add_option("--fixed", fixed_,
                          "Links on fixed joints: keep, lump (into the parent link)")
              ->group(group),
          kFixedNames);
    offer(
        app->add_option("--massless", massless_,
                        "Links without mass that are fixed: link (a frame when it has no shapes), "
                        "frame (its shapes move to the parent link)")
            ->group(group),
        kMasslessNames);
    offer(app->add_option("--inertia", inertia_,
                          "Inertias that no rigid body can have, which libsdformat rejects: keep "
                          "(an error), nearest (the nearest possible; --allow-loss implies it)")
              ->group(group),
          kInertiaNames);
    offer(app->add_option("--control", control_,
                          "Transmissions and plugins that drive joints: keep (plugins alone), "
                          "ros2_control (files next to the result), gz (plugins of Gazebo Sim)")
              ->group(group),
          kControlNames);
    return app;
  }

  int run() override {
    const convert::SdfOptions how = options();
    return common_.run([&how](const Environment& environment, Sources& sources,
                              read::Workspace& workspace, const read::Loaded& loaded,
                              const author::ConversionOptions& options) {
      return author::to_sdf(environment, sources, workspace, loaded, how, options);
    });
  }

 private:
  static convert::SdfMeshUri mesh_uri_of(const std::string& text) {
    using Kind = convert::SdfMeshUri::Kind;
    const auto [naming, name] = mesh_naming(text, {"model", "package"});
    switch (naming) {
      case MeshNaming::kDefault: return {};
      case MeshNaming::kFile: return {Kind::kFile, {}};
      case MeshNaming::kKeep: return {Kind::kKeep, {}};
      case MeshNaming::kScheme: break;
    }
    return {text.starts_with("model") ? Kind::kModel : Kind::kPackage, name};
  }

  convert::SdfOptions options() const {
    convert::SdfOptions how;
    how.mesh_uri = mesh_uri_of(mesh_uri_);
    if (!version_.empty()) {
      how.version = 9 + static_cast<int>(choice("SDF version", version_, kSdfVersions));
    }
    if (!fixed_.empty() && choice("--fixed value", fixed_, kFixedNames) == 1) {
      how.fixed = convert::FixedPolicy::kLump;
    }
    if (!massless_.empty() && choice("--massless value", massless_, kMasslessNames) == 1) {
      how.massless = convert::MasslessPolicy::kFrame;
    }
    const bool nearest = inertia_.empty() ? common_.allows_loss()
                                          : choice("--inertia value", inertia_, kInertiaNames) == 1;
    if (nearest) how.inertia = convert::InertiaPolicy::kNearest;
    if (!control_.empty()) {
      how.control =
          static_cast<convert::ControlPolicy>(choice("--control value", control_, kControlNames));
    }
    return how;
  }

  ConversionCommand common_{model::Format::kUrdf, ".sdf"};
  std::string mesh_uri_, version_, fixed_, massless_, inertia_, control_;
};

}  // namespace

std::unique_ptr<Command> urdf2sdf_command() { return std::make_unique<UrdfToSdf>(); }

}  // namespace rigor::tool
