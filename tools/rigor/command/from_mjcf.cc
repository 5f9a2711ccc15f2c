// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor mjcf2urdf` and `rigor mjcf2sdf`: a robot of MuJoCo for ROS and Gazebo.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/robot/robot.h>

#include "command/command.h"
#include "model/conversion.h"
#include "option/numbers.h"

namespace rigor::tool {
namespace {

// The first is the default.
constexpr std::string_view kSurroundingsNames[] = {"keep", "drop"};
constexpr std::string_view kMjcfUrdfVersions[] = {"1.0", "1.1"};
constexpr std::string_view kMjcfSdfVersions[] = {"1.9", "1.10", "1.11"};

class FromMjcf final : public Command {
 public:
  FromMjcf(model::Format to, std::string name)
      : to_(to),
        name_(std::move(name)),
        common_(model::Format::kMjcf, is_urdf() ? ".urdf" : ".sdf") {}

  CLI::App* declare(CLI::App& program) override {
    const std::string out = is_urdf() ? "robot.urdf" : "model.sdf";
    CLI::App* app = add_command(
        program, name_,
        std::string("Convert a model of MuJoCo from MJCF to ") + (is_urdf() ? "URDF" : "SDF"),
        {"rigor " + name_ + " robot.xml -o " + out,
         "rigor " + name_ + " scene.xml --model base -o " + out,
         "rigor " + name_ + " robot.xml --check " + out});
    common_.declare(*app);
    app->add_option("--model", how_.body,
                    "Body of the top level to convert, if the file has several: else all")
        ->type_name("NAME");
    app->add_option("--name", how_.name, "Name of the result (default: the file's)")
        ->type_name("NAME");
    app->add_option("--mesh-uri", mesh_uri_,
                    is_urdf()
                        ? "How mesh URIs are written: package://NAME, file or keep"
                        : "How mesh URIs are written: model://NAME, package://NAME, file or keep")
        ->type_name("HOW");
    if (is_urdf()) {
      offer(app->add_option("--urdf-version", version_, "1.1 has capsules (default: 1.0)")
                ->type_name("VERSION"),
            kMjcfUrdfVersions);
      app->add_option("--unlimited", unlimited_,
                      "Number that represents an infinite effort or velocity (default: 1e16)")
          ->type_name("NUMBER");
    } else {
      offer(app->add_option("--sdf-version", version_,
                            "1.9 to 1.11 (default: 1.9, or 1.11 for mimic joints)")
                ->type_name("VERSION"),
            kMjcfSdfVersions);
    }
    offer(app->add_option("--surroundings", surroundings_,
                          "Shapes of the world itself, as its floor: keep (the default; of a URDF "
                          "where the world is its root), drop"),
          kSurroundingsNames);
    return app;
  }

  int run() override {
    const convert::FromMjcfOptions how = options();
    return common_.run([&](const Environment& environment, Sources& sources,
                           read::Workspace& workspace, const read::Loaded& loaded,
                           const author::ConversionOptions& options) {
      require_body(loaded.root);
      return is_urdf()
                 ? author::from_mjcf_to_urdf(environment, sources, workspace, loaded, how, options)
                 : author::from_mjcf_to_sdf(environment, sources, workspace, loaded, how, options);
    });
  }

 private:
  /// A UsageError when a body is asked for, and none has that name.
  void require_body(const model::Root& root) const {
    if (how_.body.empty()) return;
    std::vector<std::string_view> names;
    for (const model::Link& link : root.links) {
      if (link.name.value != robot::kWorldBody) names.push_back(link.name.value);
    }
    if (std::find(names.begin(), names.end(), how_.body) != names.end()) return;
    throw UsageError("unknown --model \"" + how_.body + '"' + did_you_mean(how_.body, names));
  }

  bool is_urdf() const { return to_ == model::Format::kUrdf; }

  void set_mesh_uri(convert::FromMjcfOptions& how) const {
    using Urdf = convert::MeshUri::Kind;
    using Sdf = convert::SdfMeshUri::Kind;
    const std::vector<std::string> schemes = is_urdf()
                                                 ? std::vector<std::string>{"package"}
                                                 : std::vector<std::string>{"model", "package"};
    const auto [naming, name] = mesh_naming(mesh_uri_, schemes);
    switch (naming) {
      case MeshNaming::kDefault: break;
      case MeshNaming::kFile:
        how.urdf.mesh_uri.kind = Urdf::kFile;
        how.sdf.mesh_uri.kind = Sdf::kFile;
        break;
      case MeshNaming::kKeep:
        how.urdf.mesh_uri.kind = Urdf::kKeep;
        how.sdf.mesh_uri.kind = Sdf::kKeep;
        break;
      case MeshNaming::kScheme:
        how.urdf.mesh_uri = {Urdf::kPackage, name};
        how.sdf.mesh_uri = {mesh_uri_.starts_with("model") ? Sdf::kModel : Sdf::kPackage, name};
        break;
    }
  }

  convert::FromMjcfOptions options() const {
    convert::FromMjcfOptions how = how_;
    set_mesh_uri(how);
    if (!version_.empty()) {
      if (is_urdf()) {
        how.urdf.urdf_version =
            static_cast<int>(choice("URDF version", version_, kMjcfUrdfVersions));
      } else {
        how.sdf.version = 9 + static_cast<int>(choice("SDF version", version_, kMjcfSdfVersions));
      }
    }
    if (!unlimited_.empty()) how.urdf.unlimited = positive_number("--unlimited", unlimited_, "");
    if (!surroundings_.empty() &&
        choice("--surroundings value", surroundings_, kSurroundingsNames) == 1) {
      how.surroundings = convert::SurroundingsPolicy::kDrop;
    }
    how.urdf.shapes = convert::ShapePolicy::kMesh;
    const bool files = common_.writes_file() || common_.compares_file();
    how.files = files ? convert::FromMjcfFiles::kWritten : convert::FromMjcfFiles::kNone;
    return how;
  }

  model::Format to_;
  std::string name_;
  ConversionCommand common_;
  convert::FromMjcfOptions how_;
  std::string mesh_uri_, version_, unlimited_, surroundings_;
};

}  // namespace

std::unique_ptr<Command> mjcf2urdf_command() {
  return std::make_unique<FromMjcf>(model::Format::kUrdf, "mjcf2urdf");
}

std::unique_ptr<Command> mjcf2sdf_command() {
  return std::make_unique<FromMjcf>(model::Format::kSdf, "mjcf2sdf");
}

}  // namespace rigor::tool
