// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rules on a mesh's shape share: which shape is asked, and how counts, lengths and places are
// put into words. Lengths and places are those of the file, where its author will look for them.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/mass/mesh/facts.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules {

/// Of a submesh nothing is known by itself, and what holds for the whole file may not for it.
inline bool takes_part(const MeshFile& file) {
  return file.use && !file.use->mesh.submesh.value.empty();
}

/// Null when the shape was not examined, or a part of it is used only.
inline const mass::MeshShape* shape_of(const MeshFile& file) {
  return file.facts.shape && !takes_part(file) ? &*file.facts.shape : nullptr;
}

/// "1 vertex", "3 vertices".
inline std::string how_many(std::uint64_t count, std::string_view one, std::string_view several) {
  return std::to_string(count) + ' ' + std::string(count == 1 ? one : several);
}

/// "0.31 m"; "0.31 units" of a format that leaves it to the model what a unit is.
inline std::string length_in(const MeshFile& file, double length) {
  const bool meters = file.facts.format > mesh::Format::kObj;
  return fmt::format("{:.3g} {}", length, meters ? "m" : "units");
}

/// "(0.12, 0, 0.3)".
inline std::string place(const model::Vector3& at) {
  // Zero is added so that none is written -0.
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", at.x + 0, at.y + 0, at.z + 0);
}

/// " at (0, 0, 1), (0.1, 0, 1)", or of many " at (0, 0, 1), (0.1, 0, 1), (0.2, 0, 1) and elsewhere".
inline std::string at_places(const std::vector<model::Vector3>& places, std::uint64_t count) {
  constexpr std::size_t kListed = 3;
  const std::size_t listed = std::min(places.size(), kListed);
  std::string text;
  for (std::size_t i = 0; i < listed; ++i) text += (i == 0 ? " at " : ", ") + place(places[i]);
  return text + (listed > 0 && count > listed ? " and elsewhere" : "");
}

/// The same of the defects of a kind.
inline std::string at_defects(const mesh::Topology& topology, mesh::Defect defect,
                              std::uint64_t count) {
  std::vector<model::Vector3> places;
  for (const mesh::Example& example : topology.examples) {
    if (example.defect == defect) places.push_back(example.at);
  }
  return at_places(places, count);
}

inline model::Vector3 middle(const mesh::Bounds& bounds) { return 0.5 * (bounds.min + bounds.max); }

/// As the model scales it.
inline mesh::Bounds scaled_bounds(const MeshFile& file) {
  const auto [x, y, z] = file.scale();
  const auto& [min, max] = file.facts.bounds;
  return mesh::bounds_of({{x * min.x, y * min.y, z * min.z}, {x * max.x, y * max.y, z * max.z}});
}

/// The collision or visual that a geometry is a member of; null when it is in none of the list.
template <class Entity>
const Entity* owner_of(const model::Geometry& geometry, const std::vector<Entity>& list) {
  // Its place in memory tells which: a search through names would take as long as the list.
  const auto found = std::partition_point(list.begin(), list.end(), [&](const Entity& entity) {
    return std::less<const model::Geometry*>()(&entity.geometry, &geometry);
  });
  return found != list.end() && &found->geometry == &geometry ? &*found : nullptr;
}

/// The link of a mesh that a model uses; null when there is none.
inline const model::Link* link_of(const MeshFile& file, const Context& context) {
  if (!file.use) return nullptr;
  const model::Root& root = context.root();
  const model::Geometry& geometry = file.use->geometry;
  model::Id<model::Link> id;
  if (const auto* collision = owner_of(geometry, root.collisions)) id = collision->link;
  if (const auto* visual = owner_of(geometry, root.visuals)) id = visual->link;
  return id ? &root.links[id.value] : nullptr;
}

}  // namespace rigor::rules
