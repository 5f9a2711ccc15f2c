// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/bake.h>

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rigor::mesh {
namespace {

// ---- Transforms

/// p ↦ x·p.x + y·p.y + z·p.z + origin.
struct Affine {
  Vector3 x{1, 0, 0};
  Vector3 y{0, 1, 0};
  Vector3 z{0, 0, 1};
  Vector3 origin;
};

Vector3 turned(const Affine& by, const Vector3& v) {
  return {by.x.x * v.x + by.y.x * v.y + by.z.x * v.z, by.x.y * v.x + by.y.y * v.y + by.z.y * v.z,
          by.x.z * v.x + by.y.z * v.y + by.z.z * v.z};
}

Vector3 moved(const Affine& by, const Vector3& p) {
  const Vector3 q = turned(by, p);
  return {q.x + by.origin.x, q.y + by.origin.y, q.z + by.origin.z};
}

Affine operator*(const Affine& a, const Affine& b) {
  return {turned(a, b.x), turned(a, b.y), turned(a, b.z), moved(a, b.origin)};
}

bool mirrors(const Affine& a) { return model::dot(model::cross(a.x, a.y), a.z) < 0; }

/// The shortest decimal that is this float: what the file said, most likely. So a unit of 0.0254 m
/// is just that, not the 0.025399999693… that assimp keeps of it; else it is within the float's own
/// rounding.
double as_written(float value) {
  std::array<char, 32> text = {};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  double exact = value;
  std::from_chars(text.data(), end, exact);
  return exact;
}

Affine affine(const aiMatrix4x4& m) {
  const auto column = [](float x, float y, float z) {
    return Vector3{as_written(x), as_written(y), as_written(z)};
  };
  return {column(m.a1, m.b1, m.c1), column(m.a2, m.b2, m.c2), column(m.a3, m.b3, m.c3),
          column(m.a4, m.b4, m.c4)};
}

// ---- Scene to triangles

/// What one mesh of a scene comes to, each time it is used.
struct Census {
  std::uint64_t vertices = 0;  ///< 0 when it has no triangles
  std::uint64_t triangles = 0;
  std::uint64_t passed_over = 0;   ///< lines and points
  std::uint64_t out_of_range = 0;  ///< corners
};

Census census(const aiMesh& mesh) {
  Census counts;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices < 3) ++counts.passed_over;
    if (face.mNumIndices > 2) counts.triangles += face.mNumIndices - 2;
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      counts.out_of_range += face.mIndices[i] >= mesh.mNumVertices;
    }
  }
  if (mesh.mNumFaces == 0) counts.passed_over = mesh.mNumVertices;  // a cloud of points
  if (counts.triangles > 0) counts.vertices = mesh.mNumVertices;
  return counts;
}

/// Calls `use(node, X_WN, mesh index)` for each mesh of each node. Recursive, as assimp itself is.
template <class Use>
void for_each_instance(const aiNode& node, const Affine& X_WP, const Use& use) {
  const Affine X_WN = X_WP * affine(node.mTransformation);
  for (unsigned i = 0; i < node.mNumMeshes; ++i) use(node, X_WN, node.mMeshes[i]);
  for (unsigned i = 0; i < node.mNumChildren; ++i) for_each_instance(*node.mChildren[i], X_WN, use);
}

std::string_view text(const aiString& string) { return {string.data, string.length}; }

std::string part_name(const aiNode& node, const aiMesh& mesh) {
  const std::string_view own = text(node.mName);
  const bool invented = own.empty() || own.starts_with("$ColladaAutoName$");  // assimp's own
  return std::string(invented ? text(mesh.mName) : own);
}

/// A string property is its length in 32 bits, then the characters and a zero.
std::string material_name(const aiMaterial& material) {
  for (unsigned i = 0; i < material.mNumProperties; ++i) {
    const aiMaterialProperty& property = *material.mProperties[i];
    std::uint32_t length = 0;
    if (text(property.mKey) != "?mat.name" || property.mDataLength < sizeof length) continue;
    std::memcpy(&length, property.mData, sizeof length);
    const std::string_view rest(property.mData, property.mDataLength);
    return std::string(rest.substr(sizeof length, length));
  }
  return {};
}

class Baker {
 public:
  explicit Baker(const aiScene& scene) : scene_(scene) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) census_.push_back(census(*scene.mMeshes[i]));
  }

  LoadedMesh run() {
    if (!scene_.mRootNode) return {.faults = {{FaultKind::kEmpty}}};
    // Counted before anything is allocated: a few nodes can repeat a mesh a billion times.
    const Census all = total();
    LoadedMesh loaded;
    if (all.passed_over > 0) {
      loaded.faults.push_back({.kind = FaultKind::kNotTriangles, .count = all.passed_over});
    }
    if (all.out_of_range > 0) {
      loaded.faults.push_back({.kind = FaultKind::kIndexOutOfRange, .count = all.out_of_range});
    } else if (all.triangles == 0) {
      loaded.faults.push_back({FaultKind::kEmpty});
    } else if (std::max(all.triangles, all.vertices) > kMaxTriangles) {
      loaded.faults.push_back({.kind = FaultKind::kTooLarge, .count = all.triangles});
    } else {
      fill(loaded, all);
    }
    return loaded;
  }

 private:
  Census total() const {
    Census all;
    for_each_instance(*scene_.mRootNode, {}, [&](const aiNode&, const Affine&, unsigned index) {
      const Census& one = census_.at(index);
      all.vertices += one.vertices;
      all.triangles += one.triangles;
      all.passed_over += one.passed_over;
      all.out_of_range += one.out_of_range;
    });
    return all;
  }

  void fill(LoadedMesh& loaded, const Census& all) const {
    TriangleMesh& mesh = loaded.mesh;
    mesh.positions.reserve(all.vertices);
    mesh.triangles.reserve(all.triangles);
    for_each_instance(*scene_.mRootNode, {},
                      [&](const aiNode& node, const Affine& X_WN, unsigned index) {
                        if (census_[index].triangles > 0) add(mesh, node, X_WN, index);
                      });
    std::uint64_t bad = 0;
    for (const Vector3& p : mesh.positions) {
      bad += !std::isfinite(p.x) + !std::isfinite(p.y) + !std::isfinite(p.z);
    }
    if (bad == 0) return;
    mesh = {};
    loaded.faults.push_back({.kind = FaultKind::kNotFinite, .count = bad});
  }

  void add(TriangleMesh& into, const aiNode& node, const Affine& X_WN, unsigned index) const {
    const aiMesh& mesh = *scene_.mMeshes[index];
    const bool known = mesh.mMaterialIndex < scene_.mNumMaterials;
    std::string material = known ? material_name(*scene_.mMaterials[mesh.mMaterialIndex]) : "";
    into.parts.push_back({part_name(node, mesh), std::move(material), into.triangles.size(),
                          static_cast<std::size_t>(census_[index].triangles)});
    const auto base = static_cast<std::uint32_t>(into.positions.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      into.positions.push_back(moved(X_WN, {p.x, p.y, p.z}));
    }
    const bool mirrored = mirrors(X_WN);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      for (unsigned i = 2; i < face.mNumIndices; ++i) {
        Triangle t{base + face.mIndices[0], base + face.mIndices[i - 1], base + face.mIndices[i]};
        if (mirrored) std::swap(t[1], t[2]);
        into.triangles.push_back(t);
      }
    }
  }

  const aiScene& scene_;
  std::vector<Census> census_;
};

}  // namespace

LoadedMesh bake(const aiScene& scene) { return Baker(scene).run(); }

}  // namespace rigor::mesh
