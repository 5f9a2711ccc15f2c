// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/orient.h>

#include <array>
#include <vector>

#include <rigor/mesh/select.h>
#include <rigor/mesh/topology/component.h>
#include <rigor/mesh/topology/nesting.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>

namespace rigor::mesh {
namespace {

enum class Facing : std::uint8_t { kUnseen, kAsFirst, kAgainst };

/// The triangles of the patch of `first`, each marked as to whether it faces as that does.
std::vector<std::uint32_t> facing_patch(const Workpiece& work, std::uint32_t first,
                                        std::vector<Facing>& sides) {
  std::vector<std::uint32_t> patch = {first};
  sides[first] = Facing::kAsFirst;
  for (std::size_t next = 0; next < patch.size(); ++next) {
    const std::uint32_t face = patch[next];
    const Triangle& t = work[face];
    for (const auto& [i, k] : kSides) {
      const EdgeFaces at = work.faces_at(t[i], t[k]);
      if (at.count != 2) continue;
      const std::uint32_t other = at.faces[0] == face ? at.faces[1] : at.faces[0];
      if (sides[other] != Facing::kUnseen) continue;
      const bool agrees = !runs(work[other], t[i], t[k]);
      sides[other] =
          (sides[face] == Facing::kAsFirst) == agrees ? Facing::kAsFirst : Facing::kAgainst;
      patch.push_back(other);
    }
  }
  return patch;
}

/// Those of the patch that are fewer.
std::vector<std::uint32_t> fewer(const std::vector<std::uint32_t>& patch,
                                 const std::vector<Facing>& sides) {
  std::array<std::vector<std::uint32_t>, 2> split;
  for (const std::uint32_t face : patch) {
    split[sides[face] == Facing::kAsFirst ? 0 : 1].push_back(face);
  }
  return split[0].size() < split[1].size() ? split[0] : split[1];
}

/// The outermost component around this one.
std::uint32_t root_of(const Components& components, std::uint32_t component) {
  while (components.list[component].inside) component = *components.list[component].inside;
  return component;
}

}  // namespace

std::uint64_t turn_consistent(Workpiece& work) {
  std::uint64_t turned = 0;
  std::vector<Facing> sides(work.size(), Facing::kUnseen);
  for (std::uint32_t first = 0; first < work.size() && !work.tired(); ++first) {
    if (!work.has(first) || degenerate(work[first]) || sides[first] != Facing::kUnseen) continue;
    const std::vector<std::uint32_t> faces = fewer(facing_patch(work, first, sides), sides);
    const bool done = work.attempt([&] {
      for (const std::uint32_t face : faces) work.turn(face);
    });
    turned += done ? faces.size() : 0;
  }
  return turned;
}

std::uint64_t face_outward(TriangleMesh& mesh) {
  DefectTally tally;
  const Weld welded = weld(mesh.positions);
  Rings rings = look_round(mesh, welded, tally);
  Components components = components_of(mesh, welded, rings);
  nest(mesh, components);
  std::uint64_t turned = 0;
  std::vector<bool> turn(components.list.size());
  for (std::uint32_t i = 0; i < components.list.size(); ++i) {
    turn[i] = components.list[root_of(components, i)].inverted();
    turned += turn[i] ? 1 : 0;
  }
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const std::uint32_t component = components.of_face[face];
    if (component != kNoComponent && turn[component]) turn_over(mesh, face);
  }
  return turned;
}

}  // namespace rigor::mesh
