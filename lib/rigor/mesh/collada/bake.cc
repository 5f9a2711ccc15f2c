// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada/bake.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <rigor/mesh/collada/materials.h>
#include <rigor/mesh/normals.h>

namespace rigor::mesh {
namespace {

std::string short_name(std::string_view name) {
  return std::string(name.substr(0, kMaxColladaName));
}

Vector3 vector_at(const double* number) { return {number[0], number[1], number[2]}; }

template <std::size_t kSize>
std::array<float, kSize> floats_at(const double* number,
                                   const std::array<float, kSize>& otherwise) {
  std::array<float, kSize> floats;
  std::transform(number, number + kSize, floats.begin(),
                 [](double x) { return static_cast<float>(x); });
  const bool finite =
      std::all_of(floats.begin(), floats.end(), [](float x) { return std::isfinite(x); });
  return finite ? floats : otherwise;
}

/// Takes normals to the whole mesh's frame: the cofactors of a matrix take the cross product of two
/// vectors to that of their images. The sides of a mirrored surface are exchanged.
Affine normal_map(const Affine& X_WN) {
  const double sign = determinant(X_WN) < 0 ? -1 : 1;
  return {
      sign * cross(X_WN.y, X_WN.z), sign * cross(X_WN.z, X_WN.x), sign * cross(X_WN.x, X_WN.y), {}};
}

class ColladaBaker {
 public:
  ColladaBaker(const ColladaIndex& index, const std::vector<ColladaPlacement>& placements)
      : index_(index), placements_(placements), materials_(index) {}

  TriangleMesh run() {
    reserve();
    for (const ColladaPlacement& placement : placements_) add(placement);
    mesh_.materials = materials_.take();
    return std::move(mesh_);
  }

 private:
  void reserve() {
    std::uint64_t triangles = 0;
    std::uint64_t numbers = 0;
    for (const ColladaPlacement& placement : placements_) {
      const ColladaGeometry& shape = *placement.shape;
      triangles += shape.triangles;
      numbers += shape.values[kColladaPosition].size();
      for (std::size_t kind = 0; kind < kColladaKinds; ++kind) {
        if (!shape.values[kind].empty()) carried_[kind] = true;
      }
    }
    mesh_.positions.reserve(numbers / 3);
    mesh_.triangles.reserve(triangles);
    if (carried_[kColladaTexture]) mesh_.corners.texture.reserve(triangles);
    if (carried_[kColladaNormal]) mesh_.corners.normals.reserve(triangles);
    if (carried_[kColladaColor]) mesh_.corners.colors.reserve(triangles);
  }

  void add(const ColladaPlacement& placement) {
    const ColladaGeometry& shape = *placement.shape;
    const auto base = static_cast<std::uint32_t>(mesh_.positions.size());
    const std::vector<double>& positions = shape.values[kColladaPosition];
    for (std::size_t i = 0; i < positions.size(); i += 3) {
      mesh_.positions.push_back(moved(placement.X_WN, vector_at(&positions[i])));
    }
    for (const ColladaGroup& group : shape.groups) {
      const std::vector<Triangle>& triangles = group.corners[kColladaPosition];
      mesh_.parts.push_back({short_name(placement.name.empty() ? shape.name : placement.name),
                             material_of(*placement.instance, group), mesh_.triangles.size(),
                             triangles.size()});
      const bool mirrored = determinant(placement.X_WN) < 0;
      for (Triangle t : triangles) {
        if (mirrored) std::swap(t[1], t[2]);
        mesh_.triangles.push_back({base + t[0], base + t[1], base + t[2]});
      }
      add_corners(placement, group);
    }
  }

  /// A symbol that nothing is bound to may be a material's id, as Gazebo takes it; else it is all
  /// that is known.
  std::string material_of(const ColladaInstance& instance, const ColladaGroup& group) {
    const auto bound = instance.materials.find(group.material);
    if (bound != instance.materials.end()) return materials_.name(bound->second);
    const auto material = index_.find_id(group.material, "material");
    return material ? materials_.name(*material) : short_name(group.material);
  }

  void add_corners(const ColladaPlacement& placement, const ColladaGroup& group) {
    const bool mirrored = determinant(placement.X_WN) < 0;
    const auto add = [&](std::size_t kind, auto& list, const auto& otherwise, const auto& convert) {
      if (!carried_[kind]) return;
      const std::vector<Triangle>& triangles = group.corners[kind];
      const std::vector<double>& values = placement.shape->values[kind];
      for (Triangle t : triangles) {
        if (mirrored) std::swap(t[1], t[2]);
        auto& corners = list.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
          corners[c] = convert(values.data() + kColladaWidths[kind] * t[c]);
        }
      }
      list.resize(mesh_.triangles.size(), {otherwise, otherwise, otherwise});
    };
    const Affine turn = normal_map(placement.X_WN);
    Corners& corners = mesh_.corners;
    add(kColladaTexture, corners.texture, Corners::Texture{},
        [](const double* at) { return floats_at<2>(at, {}); });
    add(kColladaNormal, corners.normals, Corners::Normal{},
        [&](const double* at) { return normal_along(turned(turn, vector_at(at))); });
    add(kColladaColor, corners.colors, kWhite,
        [](const double* at) { return floats_at(at, kWhite); });
  }

  const ColladaIndex& index_;
  const std::vector<ColladaPlacement>& placements_;
  ColladaMaterials materials_;
  std::array<bool, kColladaKinds> carried_{};  ///< by any of them
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh bake_collada(const ColladaIndex& index,
                          const std::vector<ColladaPlacement>& placements) {
  return ColladaBaker(index, placements).run();
}

}  // namespace rigor::mesh
