// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/mesh/places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_inverted {

/// A mirroring scale turns the mesh round once more.
bool mirrored(const MeshFile& file) {
  const auto [x, y, z] = file.scale();
  return x * y * z < 0;
}

/// What a mirroring node turns round depends on the reader: `mesh-mirrored-node`.
bool has_mirrored_node(const MeshFile& file) {
  const auto& collada = file.facts.asset.collada;
  return collada && collada->mirrored_nodes.count > 0;
}

/// What a piece adds or takes away by being inverted, in the units of the file, cubed.
double volume(const mesh::Component& component) { return std::abs(component.volume); }

struct Inverted {
  double share = 0;  ///< of the volume of all closed components
  double cubic = 0;  ///< m³, as the model scales the mesh
};

Inverted inverted_in(const mesh::Topology& topology, const MeshFile& file) {
  double all = 0;
  double inverted = 0;
  for (const mesh::Component& component : topology.component_list) {
    if (!component.closed) continue;
    all += volume(component);
    if (component.inverted()) inverted += volume(component);
  }
  const auto [x, y, z] = file.scale();
  return {all > 0 ? inverted / all : 1, inverted * std::abs(x * y * z)};
}

std::string inside_out(const mesh::Topology& topology, double share) {
  std::string message =
      "the mesh is inside out: its triangles face inward, so that its volume is negative";
  if (topology.inverted < topology.components) {
    message += fmt::format(" ({} of {} pieces, {:.3g} % of the volume)", topology.inverted,
                           topology.components, 100 * share);
  }
  return message;
}

// Above this share of the volume the other pieces are screws and labels: the mesh is inside out.
constexpr double kWhole = 0.95;

// A rivet that is not seen and changes no mass: below both.
constexpr double kTinyShare = 0.01;
constexpr double kTinyVolume = 1e-7;  // m³, 100 mm³

void check(const MeshFile& file, Context& context) {
  const mass::MeshShape* shape = shape_of(file);
  if (!shape) return;
  const mesh::Topology& topology = shape->topology;
  if (topology.inverted == 0 || mirrored(file) || has_mirrored_node(file)) return;
  const Inverted inverted = inverted_in(topology, file);
  if (inverted.share > kWhole) {
    report_mesh(file, context, inside_out(topology, inverted.share));
    return;
  }
  const bool tiny = inverted.share < kTinyShare && inverted.cubic < kTinyVolume;
  std::vector<model::Vector3> places;
  for (const mesh::Component& component : topology.component_list) {
    if (component.inverted()) places.push_back(middle(component.bounds));
  }
  context.report({.where = file.where(),
                  .message = fmt::format("{} of {} separate pieces of the mesh {} inside out{}",
                                         topology.inverted, topology.components,
                                         topology.inverted == 1 ? "is" : "are",
                                         at_places(places, topology.inverted)),
                  .subject = file.subject(),
                  .severity = tiny ? std::optional(Severity::kInfo) : std::nullopt});
}

Rule rule() {
  return {
      .name = "mesh-inverted",
      .severity = Severity::kWarning,
      .summary = "a closed mesh is inside out",
      .why = "All its triangles face inward. Its volume is negative, which MuJoCo, Drake and "
             "Gazebo's automatic inertia reject or turn into a wrong mass; viewers that cull back "
             "faces show its inside. A piece of less than 1 % of the volume and 100 mm³ is an "
             "info.",
      .what_to_do = "Reverse the winding of its triangles: `rigor mesh-check FILE --repair -o "
                    "OUT`, or \"flip "
                    "normals\" in the tool that made it.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_inverted
