// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "command/inertia.h"

#include <rigor/mass/material.h>
#include <rigor/report/inertia/inertia_report.h>

#include "command/command.h"
#include "option/numbers.h"

namespace rigor::tool {
namespace {

class InertiaCommand final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "inertia", "Exact mass, center of mass and inertia",
        {"rigor inertia cylinder --radius 0.1 --length 0.05 --mass 0.4",
         "rigor inertia mesh hull.stl --scale 0.001 --material aluminum", "rigor inertia my_robot",
         "rigor inertia my_robot --material abs --write", "rigor inertia my_arm --loads"});
    app->add_option("what", a_.what,
                    "box, sphere, cylinder, capsule, ellipsoid, cone, mesh FILE; or a model")
        ->type_name("SHAPE|MODEL");
    app->add_option("file", a_.mesh, "The mesh's file")->type_name("FILE");
    declare_shape(*app);
    declare_mass(*app);
    declare_model(*app);
    declare_loads(*app);
    a_.output.declare(*app, {"sdf", "urdf", "mjcf", "json", "text"});
    app->get_option("--format")
        ->description(
            "What to print on stdout: of a shape sdf, urdf, mjcf, json or text; of a "
            "model text or json");
    a_.search.declare(*app);
    return app;
  }

  int run() override {
    if (list_materials_) return print_materials();
    if (a_.loads) return run_static_loads(a_);
    if (a_.what.empty()) {
      throw UsageError("inertia needs a shape or a model; `rigor inertia --help` shows both");
    }
    return is_shape_name(a_.what) ? run_solid_inertia(a_) : run_model_inertia(a_);
  }

 private:
  void declare_shape(CLI::App& app) {
    const std::string group = "Of a shape";
    numbers(app, "--size", a_.size, "Side lengths of a box, m", "X Y Z", group);
    word(app, "--radius", a_.radius, "m", "R", group);
    word(app, "--length", a_.length, "m, along z; of a capsule, without its caps", "L", group);
    numbers(app, "--radii", a_.radii, "Semi-axes of an ellipsoid, m", "A B C", group);
    numbers(app, "--scale", a_.scale, "Factor of a mesh's coordinates: one, or one per axis",
            "S | X Y Z", group);
    word(app, "--hollow", a_.hollow, "Only a wall of this thickness inside the surface, m", "T",
         group);
    word(app, "--pose", a_.pose, "Of the shape in the link: \"x y z roll pitch yaw\", m and rad",
         "POSE", group);
    app.add_flag("--hull", a_.hull, "Take a mesh's convex hull")->group(group);
  }

  void declare_mass(CLI::App& app) {
    const std::string group = "Mass";
    app.add_option("--mass", a_.masses, "KG of a shape; LINK=KG of a model, repeatable")
        ->type_name("KG")
        ->allow_extra_args(false)
        ->group(group);
    word(app, "--density", a_.density, "kg/m³", "RHO", group);
    word(app, "--material", a_.material, "A material's density", "NAME", group);
    app.add_flag("--materials", list_materials_, "List the materials, and stop")->group(group);
  }

  void declare_model(CLI::App& app) {
    const std::string group = "Of a model";
    offer(word(app, "--only", a_.only,
               "missing, implausible or all links; else those with a finding", "WHICH", group),
          kOnlyNames);
    offer(word(app, "--from", a_.from, "collision or visual shapes; else whichever have an answer",
               "SHAPES", group),
          kFromNames);
    app.add_flag("--bake", a_.bake, "Also turn <inertial auto=\"true\"> into numbers")
        ->group(group);
    app.add_option("--joint", a_.joints, "Position of a joint, rad or m, for the totals")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->group(group);
    app.add_flag("--diff", a_.diff, "Show what would be written; exit 1 if anything")->group(group);
    app.add_flag("--write", a_.write, "Write the inertials into the file")->group(group);
  }

  void declare_loads(CLI::App& app) {
    const std::string group = "Loads of a model";
    app.add_flag(
           "--loads", a_.loads,
           "What gravity asks of each joint, beside its effort limit; exit 1 where that is less")
        ->group(group);
    word(app, "--model", a_.model, "Which model, of several in the file", "NAME", group);
    word(app, "--samples", a_.samples, "Poses to try; else 1000", "N", group);
    word(app, "--seed", a_.seed, "Of the poses; else 1", "N", group);
  }

  static CLI::Option* word(CLI::App& app, const std::string& name, std::string& value,
                           const std::string& description, const std::string& type,
                           const std::string& group) {
    return app.add_option(name, value, description)->type_name(type)->group(group);
  }

  static void numbers(CLI::App& app, const std::string& name, std::vector<std::string>& value,
                      const std::string& description, const std::string& type,
                      const std::string& group) {
    app.add_option(name, value, description)->type_name(type)->expected(1, 3)->group(group);
  }

  int print_materials() const {
    for (const Target& target : a_.output.targets_of({"text", "json"})) {
      const auto own = a_.search.config().materials(".");
      write(target, target.format == 0 ? report::materials_text(own) : report::materials_json(own));
    }
    return kClean;
  }

  InertiaArguments a_;
  bool list_materials_ = false;
};

}  // namespace

std::optional<double> density_of(const InertiaArguments& arguments, const std::string& path) {
  if (!arguments.density.empty() && !arguments.material.empty()) {
    throw UsageError("--density and --material exclude each other: both give the density");
  }
  if (!arguments.density.empty()) {
    return positive_number("--density", arguments.density, "kg/m³");
  }
  if (arguments.material.empty()) return std::nullopt;
  const std::map<std::string, double> materials = arguments.search.config().materials(path);
  const auto own = materials.find(arguments.material);
  if (own != materials.end()) return own->second;
  if (const mass::Material* material = mass::find_material(arguments.material)) {
    return material->density;
  }
  std::vector<std::string_view> known;
  for (const auto& [name, density] : materials) known.push_back(name);
  for (const mass::Material& material : mass::materials()) known.push_back(material.name);
  throw UsageError("--material " + arguments.material + ": no such material" +
                   did_you_mean(arguments.material, known) +
                   "; `rigor inertia --materials` lists them");
}

std::unique_ptr<Command> inertia_command() { return std::make_unique<InertiaCommand>(); }

}  // namespace rigor::tool
