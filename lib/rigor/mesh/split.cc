// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/split.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>

#include <rigor/mesh/topology/component.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/weld.h>

namespace rigor::mesh {
namespace {

constexpr std::uint32_t kUnassigned = 0xffffffffU;

/// To which piece each triangle goes, and how many there are.
struct Plan {
  std::vector<std::uint32_t> piece;
  std::uint64_t count = 0;
};

/// Takes pieces out of a mesh in time that depends on them, not on the mesh.
class PieceCutter {
 public:
  explicit PieceCutter(const TriangleMesh& mesh)
      : mesh_(mesh),
        number_(mesh.positions.size(), kUnassigned),
        part_(mesh.triangles.size(), kUnassigned) {
    for (std::uint32_t i = 0; i < mesh.parts.size(); ++i) {
      const Part& part = mesh.parts[i];
      std::fill_n(part_.begin() + static_cast<std::ptrdiff_t>(part.first), part.count, i);
    }
  }

  TriangleMesh cut(const std::vector<std::uint32_t>& faces) {
    TriangleMesh piece;
    std::vector<std::uint32_t> used;  // positions of the mesh
    for (const std::uint32_t face : faces) {
      add_to_parts(face, piece);
      Triangle t = mesh_.triangles[face];
      for (std::uint32_t& corner : t) {
        if (number_[corner] == kUnassigned) {
          number_[corner] = static_cast<std::uint32_t>(used.size());
          used.push_back(corner);
          piece.positions.push_back(mesh_.positions[corner]);
        }
        corner = number_[corner];
      }
      piece.triangles.push_back(t);
    }
    for (const std::uint32_t position : used) number_[position] = kUnassigned;
    copy(mesh_.corners.texture, faces, piece.corners.texture);
    copy(mesh_.corners.normals, faces, piece.corners.normals);
    copy(mesh_.corners.colors, faces, piece.corners.colors);
    take_materials(piece);
    return piece;
  }

 private:
  void add_to_parts(std::uint32_t face, TriangleMesh& piece) {
    if (part_[face] == kUnassigned) return;
    if (piece.parts.empty() || part_[face] != last_) {
      piece.parts.push_back(mesh_.parts[part_[face]]);
      piece.parts.back().first = piece.triangles.size();
      piece.parts.back().count = 0;
      last_ = part_[face];
    }
    ++piece.parts.back().count;
  }

  template <class List>
  static void copy(const List& list, const std::vector<std::uint32_t>& faces, List& to) {
    if (list.empty()) return;
    for (const std::uint32_t face : faces) to.push_back(list[face]);
  }

  /// Those that its parts name, in the mesh's order.
  void take_materials(TriangleMesh& piece) const {
    std::vector<std::string_view> names;
    for (const Part& part : piece.parts) names.push_back(part.material);
    std::sort(names.begin(), names.end());
    for (const Material& material : mesh_.materials) {
      if (std::binary_search(names.begin(), names.end(), std::string_view(material.name))) {
        piece.materials.push_back(material);
      }
    }
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> number_;  // of each position in the piece at hand
  std::vector<std::uint32_t> part_;    // of each triangle
  std::uint32_t last_ = kUnassigned;
};

Split split(const TriangleMesh& mesh, const Plan& plan) {
  Split result{.count = plan.count};
  if (result.too_many()) return result;
  std::vector<std::vector<std::uint32_t>> faces(plan.count);
  for (std::uint32_t face = 0; face < plan.piece.size(); ++face) {
    faces[plan.piece[face]].push_back(face);
  }
  PieceCutter cutter(mesh);
  for (const std::vector<std::uint32_t>& of_piece : faces) {
    result.pieces.push_back({.mesh = cutter.cut(of_piece)});
  }
  return result;
}

}  // namespace

Split split_by_component(const TriangleMesh& mesh) {
  const Weld welded = weld(mesh.positions);
  DefectTally tally;
  Rings rings = look_round(mesh, welded, tally);
  Components components = components_of(mesh, welded, rings);
  std::uint32_t last = 0;
  for (std::uint32_t& component : components.of_face) {
    if (component == kNoComponent) component = last;
    last = component;
  }
  const bool only_degenerate = components.list.empty() && !mesh.triangles.empty();
  Split result =
      split(mesh, {std::move(components.of_face), only_degenerate ? 1 : components.list.size()});
  for (std::size_t i = 0; i < result.pieces.size(); ++i) result.pieces[i].name = std::to_string(i);
  return result;
}

Split split_by_material(const TriangleMesh& mesh) {
  std::map<std::string_view, std::uint32_t> number;
  std::vector<std::string_view> names;
  Plan plan{.piece = std::vector<std::uint32_t>(mesh.triangles.size(), kUnassigned)};
  const auto piece_of = [&](std::string_view name) {
    const auto [found, added] = number.try_emplace(name, static_cast<std::uint32_t>(names.size()));
    if (added) names.push_back(name);
    return found->second;
  };
  for (const Part& part : mesh.parts) {
    if (part.count == 0) continue;
    std::fill_n(plan.piece.begin() + static_cast<std::ptrdiff_t>(part.first), part.count,
                piece_of(part.material));
  }
  for (std::uint32_t& piece : plan.piece) {
    if (piece == kUnassigned) piece = piece_of("");
  }
  plan.count = names.size();
  Split result = split(mesh, plan);
  for (std::size_t i = 0; i < result.pieces.size(); ++i) result.pieces[i].name = names[i];
  return result;
}

}  // namespace rigor::mesh
