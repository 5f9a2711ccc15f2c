// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor inertia SHAPE`: a block from numbers alone.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/mass/hollow.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/mass/polyhedron.h>
#include <rigor/mass/proposal.h>
#include <rigor/mass/shapes.h>
#include <rigor/mass/shell.h>
#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/fault.h>
#include <rigor/mesh/select.h>
#include <rigor/report/inertia/inertia_report.h>
#include <rigor/report/mesh_check/mesh_fault.h>
#include <rigor/report/number.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/write/inertial_text.h>

#include "command/command.h"
#include "command/inertia.h"
#include "option/numbers.h"

namespace rigor::tool {
namespace {

using mass::MeshState;
using mass::Solid;

// A part of a robot is neither smaller nor larger; what is has its unit wrong.
constexpr double kSmallest = 1e-6;  // m
constexpr double kLargest = 1e3;    // m

// A mesh longer than this is most likely in millimeters.
constexpr double kLongMesh = 20;  // m

constexpr std::string_view kShapes[] = {"box",       "sphere", "cylinder", "capsule",
                                        "ellipsoid", "cone",   "mesh"};

/// The input is well-formed and still has no answer: said on stderr, exit 1, nothing printed.
class NoAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void require_size(const std::string& option, double value) {
  if (value >= kSmallest && value <= kLargest) return;
  throw UsageError(fmt::format("{} {} m: no part of a robot is {} than {} m", option,
                               report::number(value), value > kLargest ? "longer" : "smaller",
                               report::number(value > kLargest ? kLargest : kSmallest)));
}

double length_option(const InertiaArguments& a, const std::string& option,
                     const std::string& text) {
  if (text.empty()) throw UsageError(a.what + " needs " + option);
  const double value = positive_number(option, text, "m");
  require_size(option, value);
  return value;
}

model::Vector3 lengths_option(const InertiaArguments& a, const std::string& option,
                              const std::vector<std::string>& words) {
  if (words.empty()) throw UsageError(a.what + " needs " + option + " with three numbers");
  const model::Vector3 value = positive_vector(option, words, "m");
  for (const double one : {value.x, value.y, value.z}) require_size(option, one);
  return value;
}

model::Field<double> field(double value) { return {value, {}, true}; }
model::Field<model::Vector3> field(const model::Vector3& value) { return {value, {}, true}; }

/// An option that the shape does not have.
void refuse_model_options(const InertiaArguments& a) {
  const bool round = a.what == "cylinder" || a.what == "capsule" || a.what == "cone";
  const auto refuse = [&a](bool given, bool belongs, const char* option) {
    if (given && !belongs) throw UsageError(std::string(option) + " does not belong to " + a.what);
  };
  refuse(!a.size.empty(), a.what == "box", "--size");
  refuse(!a.radius.empty(), round || a.what == "sphere", "--radius");
  refuse(!a.length.empty(), round, "--length");
  refuse(!a.radii.empty(), a.what == "ellipsoid", "--radii");
  refuse(!a.scale.empty(), a.what == "mesh", "--scale");
  refuse(a.hull, a.what == "mesh", "--hull");
  refuse(!a.mesh.empty(), a.what == "mesh", "a second argument");
  refuse(!a.only.empty(), false, "--only");
  refuse(!a.from.empty(), false, "--from");
  refuse(!a.joints.empty(), false, "--joint");
  refuse(a.bake, false, "--bake");
  refuse(a.diff, false, "--diff");
  refuse(a.write, false, "--write");
}

model::Shape primitive(const InertiaArguments& a) {
  if (a.what == "box") return model::Box{field(lengths_option(a, "--size", a.size))};
  if (a.what == "sphere") return model::Sphere{field(length_option(a, "--radius", a.radius))};
  if (a.what == "ellipsoid") {
    return model::Ellipsoid{field(lengths_option(a, "--radii", a.radii))};
  }
  const auto radius = field(length_option(a, "--radius", a.radius));
  const auto length = field(length_option(a, "--length", a.length));
  if (a.what == "cylinder") return model::Cylinder{radius, length};
  if (a.what == "capsule") return model::Capsule{radius, length};
  return model::Cone{radius, length};
}

Solid primitive_solid(const InertiaArguments& a) {
  const model::Shape shape = primitive(a);
  if (a.hollow.empty()) return *mass::solid_of(shape);
  const double wall = positive_number("--hollow", a.hollow, "m");
  const auto solid = mass::hollow(shape, wall);
  if (solid && solid->volume < mass::solid_of(shape)->volume) return *solid;
  throw UsageError("--hollow " + a.hollow + " m: a wall this thick fills the whole " + a.what);
}

/// An STL or OBJ has no unit, and most that are very long are in millimeters.
void require_plausible_unit(const InertiaArguments& a, const mass::MeshSurvey& survey) {
  if (!a.scale.empty()) return;
  const model::Vector3 size = survey.bounds.max - survey.bounds.min;
  const double longest = std::max({size.x, size.y, size.z});
  if (longest <= kLongMesh) return;
  throw NoAnswer(
      fmt::format("{} is {} m long: if it is in millimeters, add --scale 0.001; if it "
                  "is meant, --scale 1",
                  a.mesh, report::number(longest)));
}

std::string open_text(const mass::MeshSurvey& survey) {
  const mesh::Topology& t = *survey.topology;
  std::string text =
      "is not closed: " + report::counted(t.boundary_edges, "edge") + " of one triangle";
  if (t.nonmanifold_edges > 0) {
    text += fmt::format(", {} of more than two", t.nonmanifold_edges);
  }
  if (t.inconsistent_edges > 0) {
    text += fmt::format(", {} between triangles that face opposite ways", t.inconsistent_edges);
  }
  return text;
}

/// What keeps a mesh from being a solid.
std::string problem(const mass::MeshSurvey& survey, MeshState state) {
  switch (state) {
    case MeshState::kSolid: return {};
    case MeshState::kInverted: return "is inside out: all its triangles face inward";
    case MeshState::kOpen: return open_text(survey);
    case MeshState::kOverlapping:
      return fmt::format("overlaps itself: {:.0f} % of its inside would count twice",
                         100 * survey.winding.doubled);
    case MeshState::kMixed: return "is partly inverted";
    case MeshState::kFlat: return "encloses nothing";
    case MeshState::kUnusable: return "cannot be used";
  }
  return {};
}

mesh::TriangleMesh scaled_mesh(const InertiaArguments& a, const model::Vector3& scale) {
  mesh::TriangleMesh mesh = mesh::read_mesh(a.search.disk({a.mesh}), a.mesh).mesh;
  for (model::Vector3& p : mesh.positions) p = {p.x * scale.x, p.y * scale.y, p.z * scale.z};
  return mesh;
}

Solid shell(const InertiaArguments& a, const model::Vector3& scale, const mass::MeshBody& body) {
  if (a.hull) throw UsageError("--hull and --hollow exclude each other");
  const double wall = positive_number("--hollow", a.hollow, "m");
  const auto solid = mass::shell_of(scaled_mesh(a, scale), wall);
  if (!solid) throw NoAnswer(a.mesh + " has no area");
  const bool encloses = body.state == MeshState::kSolid && body.solid;
  if (!encloses || solid->volume < body.solid->volume) return *solid;
  throw UsageError("--hollow " + a.hollow +
                   " m: a wall this thick fills all that the mesh encloses");
}

Solid hull(const InertiaArguments& a, const model::Vector3& scale) {
  const auto hull = mesh::convex_hull(mesh::used_positions(scaled_mesh(a, scale)));
  if (hull) return mass::solid_of(mass::moments_of(*hull));
  throw NoAnswer(a.mesh + " encloses nothing");
}

Solid mesh_solid(const InertiaArguments& a) {
  if (a.mesh.empty()) throw UsageError("mesh needs a file");
  const model::Vector3 scale = a.scale.empty() ? model::Vector3{1, 1, 1} : scale_factors(a.scale);
  const GuardedDisk disk = a.search.disk({a.mesh});
  switch (disk.kind(a.mesh)) {
    case PathKind::kFile: break;
    case PathKind::kMissing: throw UsageError(a.mesh + ": no such file");
    case PathKind::kFolder: throw UsageError(a.mesh + ": is a folder");
    case PathKind::kOther: throw UsageError(a.mesh + ": is not a regular file");
  }
  const mass::MeshSurvey survey = mass::survey_mesh(disk, {a.mesh}, 0);
  for (const mesh::Fault& fault : survey.faults) {
    const std::string text = a.mesh + ": " + report::fault_text(fault);
    if (mesh::fatal(fault.kind)) throw NoAnswer(text);
    say("rigor: " + report::printable(text));
  }
  require_plausible_unit(a, survey);
  const mass::MeshBody body = mass::body_of(survey, scale);
  if (!a.hollow.empty()) return shell(a, scale, body);
  const std::string why = problem(survey, body.state);
  if (why.empty()) return a.hull ? hull(a, scale) : *body.solid;
  const bool turned = body.from == mass::BodyFrom::kTurnedMesh;
  if (a.hull && body.solid) {
    say("rigor: " + report::printable(a.mesh) + " " + why +
        (turned ? "; it is taken the other way round" : "; its convex hull is used"));
    return *body.solid;
  }
  if (turned) throw NoAnswer(a.mesh + " " + why + "; --hull uses its opposite orientation");
  if (!body.solid) throw NoAnswer(a.mesh + " " + why + "; --hollow T treats it as a sheet of T m");
  throw NoAnswer(a.mesh + " " + why + "; --hull uses its convex hull, --hollow T a sheet of T m");
}

double mass_of(const InertiaArguments& a, const Solid& solid) {
  const auto density = density_of(a, a.mesh.empty() ? "." : a.mesh);
  if (a.masses.size() > 1) throw UsageError("--mass is given twice");
  if (density && !a.masses.empty()) {
    throw UsageError("--mass and a density exclude each other");
  }
  if (density) return *density * solid.volume;
  if (a.masses.empty()) {
    throw UsageError("give --mass KG, --density KG/M3 or --material NAME");
  }
  return positive_number("--mass", a.masses.front(), "kg");
}

void require_possible(double mass, const Solid& solid) {
  const double density = mass / solid.volume;
  if (density > mass::kDensest) {
    throw UsageError(fmt::format(
        "{} kg in {} m³ is {} kg/m³: no material is denser than osmium, 22590 kg/m³; is a size in "
        "the wrong unit?",
        report::number(mass), report::number(solid.volume), report::number(density, 4)));
  }
  if (!mass::judge(mass::with_mass(solid, mass)).possible()) {
    throw NoAnswer("the numbers are too small or too large for the computation");
  }
}

struct WrittenPose {
  model::Pose pose;
  std::string rotation;  ///< as the user wrote it; empty for none
};

WrittenPose pose_of(const InertiaArguments& a) {
  if (a.pose.empty()) return {};
  const std::vector<double> n = finite_numbers("--pose", {a.pose});
  if (n.size() != 6) {
    throw UsageError("--pose takes six numbers: \"x y z roll pitch yaw\"");
  }
  WrittenPose result{{{n[0], n[1], n[2]}, model::from_rpy(n[3], n[4], n[5])}, {}};
  if (n[3] != 0 || n[4] != 0 || n[5] != 0) {
    for (std::size_t i = 3; i < 6; ++i) {
      result.rotation += (i > 3 ? " " : "") + report::number(n[i], 17);
    }
  }
  return result;
}

}  // namespace

bool is_shape_name(const std::string& what) {
  return std::find(std::begin(kShapes), std::end(kShapes), what) != std::end(kShapes);
}

int run_solid_inertia(const InertiaArguments& a) try {
  const std::vector<Target> targets = a.output.targets_of({"sdf", "urdf", "mjcf", "json", "text"});
  refuse_model_options(a);
  const WrittenPose X_LS = pose_of(a);
  const Solid solid = a.what == "mesh" ? mesh_solid(a) : primitive_solid(a);
  const double mass = mass_of(a, solid);
  require_possible(mass, solid);
  mass::MassProperties body = with_mass(solid, mass);
  body.com = transform(X_LS.pose, body.com);

  constexpr write::BlockFormat kFormats[] = {write::BlockFormat::kSdf, write::BlockFormat::kUrdf,
                                             write::BlockFormat::kMjcf};
  for (const Target& target : targets) {
    if (target.format >= std::size(kFormats)) {
      const report::SolidInertia numbers{body, solid.volume, mass / solid.volume};
      const bool json = target.format == std::size(kFormats);
      write(target, json ? report::solid_json(numbers) : report::solid_text(numbers));
      continue;
    }
    const write::BlockFormat format = kFormats[target.format];
    mass::MassProperties shown = body;
    std::string rotation = X_LS.rotation;
    if (format == write::BlockFormat::kMjcf) {
      // `fullinertia` has no axes of its own: it is along the body's.
      shown.about_com = rotated(X_LS.pose.rotation, body.about_com);
      rotation.clear();
    }
    write(target, write::inertial_text(shown, format, rotation) + "\n");
  }
  return kClean;
} catch (const NoAnswer& none) {
  say("rigor: " + report::printable(none.what()));
  return kFindings;
}

}  // namespace rigor::tool
