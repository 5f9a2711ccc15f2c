// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include <rigor/mass/mesh/survey.h>
#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_size_suspicious {

// Diagonals, in meters. In 2,000 real model files no mesh that may move is beyond them; what stands fast
// may be a building or terrain.
constexpr double kLarge = 50;
constexpr double kSmall = 0.005;
// What a link may be expected to measure.
constexpr double kLikelySmall = 0.01;
constexpr double kLikelyLarge = 5;
// Of 73 real models with three meshes or more, the largest mesh has at most 10.4 times the diagonal of
// the next, and the smallest no less than a seventh; the least mistake, meters for inches, makes 39.
constexpr double kBeyondOthers = 30;
// More than nine in ten of their meshes are within this factor of the others.
constexpr double kApart = 4;
// With one other, it is unknown which of the two is wrong.
constexpr std::size_t kFewestOthers = 2;
// Shapes of the model that are compared with: these tell, and a hostile file has a million.
constexpr int kMaxOthers = 100;

struct Unit {
  std::string_view name;
  double meter;
};
constexpr Unit kUnits[] = {{"millimeters", 0.001}, {"inches", 0.0254}, {"centimeters", 0.01}};

bool stands_fast(const MeshFile& file, const Context& context) {
  const model::Link* link = link_of(file, context);
  return link && link->model && context.root().models[link->model.value].is_static.value;
}

double diagonal_of(const mesh::Bounds& bounds, const model::Vector3& scale) {
  const model::Vector3 size = bounds.max - bounds.min;
  return length(model::Vector3{scale.x * size.x, scale.y * size.y, scale.z * size.z});
}

/// What a mesh may be expected to measure, in meters.
struct Likely {
  double least = kLikelySmall;
  double most = kLikelyLarge;
};

/// "; if it is drawn in millimeters, 0.35 m are meant": the first unit in which the size is likely.
std::string too_large(double size, const Likely& likely = {}) {
  for (const Unit& unit : kUnits) {
    const double meant = size * unit.meter;
    if (meant < likely.least || meant > likely.most) continue;
    return fmt::format("; if it is drawn in {}, {:.3g} m are meant", unit.name, meant);
  }
  return {};
}

/// The same of one that was shrunk once too often.
std::string too_small(double size, const Likely& likely = {}) {
  for (const Unit& unit : kUnits) {
    const double meant = size / unit.meter;
    if (meant < likely.least || meant > likely.most) continue;
    return fmt::format("; if the scale from {} was applied twice, {:.3g} m are meant", unit.name,
                       meant);
  }
  return {};
}

struct Others {
  std::size_t count = 0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
};

/// The diagonals of the model's other meshes.
Others others_of(const MeshFile& file, const model::Link& link, Context& context) {
  const model::Root& root = context.root();
  using Placed = std::pair<std::string_view, double>;
  const Placed own(file.use->mesh.uri.value, length(file.scale()));
  std::set<Placed> seen{own};
  Others others;
  int looked_at = 0;
  const auto compare = [&](const auto& shape) {
    const auto* const mesh = std::get_if<model::Mesh>(&shape.geometry.shape);
    if (!mesh || !shape.link || !root.own(shape.site) || looked_at == kMaxOthers) return;
    if (root.links[shape.link.value].model != link.model) return;
    ++looked_at;
    if (!seen.emplace(mesh->uri.value, length(mesh->scale.value)).second) return;
    const mass::MeshSurvey* const survey = context.survey(*mesh);
    if (!survey || !survey->usable()) return;
    const double size = diagonal_of(survey->bounds, mesh->scale.value);
    others.least = std::min(others.least, size);
    others.most = std::max(others.most, size);
    ++others.count;
  };
  for (const model::Collision& collision : root.collisions) compare(collision);
  for (const model::Visual& visual : root.visuals) compare(visual);
  return others;
}

/// Beside the others of its model a mesh stands out before it is as large as a building.
void check_among_others(const MeshFile& file, double size, Context& context) {
  const model::Link* const link = link_of(file, context);
  if (!link || (size >= kLikelySmall && size <= kLikelyLarge)) return;
  const Others others = others_of(file, *link, context);
  const bool large = size > kBeyondOthers * others.most;
  if (others.count < kFewestOthers || !(large || kBeyondOthers * size < others.least)) return;
  const Likely likely{others.least / kApart, others.most * kApart};
  report_mesh(
      file, context,
      fmt::format("the mesh is {:.3g} m across, and {} other of the model {:.3g} m{}", size,
                  large ? "the largest" : "the smallest", large ? others.most : others.least,
                  large ? too_large(size, likely) : too_small(size, likely)));
}

void check(const MeshFile& file, Context& context) {
  if (!file.use || takes_part(file) || !file.facts.usable()) return;
  const double size = mesh::diagonal(scaled_bounds(file));
  if (!(size > 0) || stands_fast(file, context)) return;
  const bool large = size > kLarge;
  if (!large && size >= kSmall) return check_among_others(file, size, context);
  report_mesh(file, context,
              fmt::format("the mesh is {:.3g} m across, which is {} for a link{}", size,
                          large ? "much" : "little", large ? too_large(size) : too_small(size)));
}

Rule rule() {
  return {
      .name = "mesh-size-suspicious",
      .severity = Severity::kWarning,
      .summary = "a mesh is as large as a building or as small as a grain",
      .why =
          "STL and OBJ have no unit. A part drawn in millimeters and read in meters is a thousand "
          "times too large, one scaled twice as much too small; at a thousandth of its size a "
          "robot is invisible. Contacts, inertia and camera ranges are wrong, too. A mesh that is "
          "thirty times larger or smaller than all others of its model is also reported.",
      .what_to_do = "Give the mesh's unit in the model's scale (0.001 for millimeters), or put it "
                    "into the file: `rigor mesh-check FILE --unit mm -o OUT`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_size_suspicious
