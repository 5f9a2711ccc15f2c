// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/importer/bake.h>

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <assimp/texture.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/mesh/affine.h>
#include <rigor/mesh/normals.h>

namespace rigor::mesh {
namespace {

// ---- Transforms

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
  std::uint64_t with_texture = 0;  ///< triangles whose corners carry it
  std::uint64_t with_normals = 0;
  std::uint64_t with_colors = 0;
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
  if (mesh.mTextureCoords[0]) counts.with_texture = counts.triangles;
  if (mesh.mNormals) counts.with_normals = counts.triangles;
  if (mesh.mColors[0]) counts.with_colors = counts.triangles;
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

// ---- Materials

const aiMaterialProperty* find(const aiMaterial& material, std::string_view key,
                               aiTextureType semantic = aiTextureType_NONE) {
  for (unsigned i = 0; i < material.mNumProperties; ++i) {
    const aiMaterialProperty& property = *material.mProperties[i];
    if (text(property.mKey) == key && property.mSemantic == semantic && property.mIndex == 0) {
      return &property;
    }
  }
  return nullptr;
}

/// A string property is its length in 32 bits, then the characters and a zero.
std::string string_of(const aiMaterialProperty* property) {
  std::uint32_t length = 0;
  if (!property || property->mDataLength < sizeof length) return {};
  std::memcpy(&length, property->mData, sizeof length);
  const std::string_view rest(property->mData, property->mDataLength);
  return std::string(rest.substr(sizeof length, length));
}

/// Into as many numbers as there are, from 0 to 1.
void read_numbers(const aiMaterialProperty* property, float* into, std::size_t count) {
  if (!property || property->mType != aiPTI_Float) return;
  count = std::min<std::size_t>(count, property->mDataLength / sizeof(float));
  for (std::size_t i = 0; i < count; ++i) {
    float number = 0;
    std::memcpy(&number, property->mData + i * sizeof number, sizeof number);
    if (std::isfinite(number)) into[i] = std::clamp(number, 0.0F, 1.0F);
  }
}

/// Collada and OBJ name a picture of the opacity, glTF says what its one picture's is for.
bool has_picture_opacity(const aiMaterial& material) {
  const std::string mode = string_of(find(material, "$mat.gltf.alphaMode"));
  return mode == "BLEND" || mode == "MASK" || find(material, "$tex.file", aiTextureType_OPACITY);
}

Material material_of(const aiMaterial& material) {
  Material look{.name = string_of(find(material, "?mat.name")),
                .texture = string_of(find(material, "$tex.file", aiTextureType_DIFFUSE)),
                .picture_opacity = has_picture_opacity(material)};
  read_numbers(find(material, "$clr.diffuse"), look.diffuse.data(), look.diffuse.size());
  read_numbers(find(material, "$mat.opacity"), &look.diffuse.back(), 1);
  return look;
}

/// The pictures within a file, which are numbered "*0", "*1", …
class EmbeddedPictures {
 public:
  explicit EmbeddedPictures(const aiScene& scene) : scene_(scene) {}

  /// Null when there is none, when it is no file but bare pixels, or when there are too many bytes.
  std::shared_ptr<const std::string> find(std::string_view name) {
    unsigned index = 0;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), index);
    if (error != std::errc() || end != name.data() + name.size()) return nullptr;
    if (index >= scene_.mNumTextures) return nullptr;
    const auto [known, is_new] = known_.try_emplace(index);
    const aiTexture& texture = *scene_.mTextures[index];
    const bool is_file = texture.mHeight == 0 && texture.pcData;
    if (!is_new || !is_file || texture.mWidth > kMaxEmbeddedPictureBytes - bytes_)
      return known->second;
    bytes_ += texture.mWidth;
    return known->second = std::make_shared<const std::string>(
               reinterpret_cast<const char*>(texture.pcData), texture.mWidth);
  }

 private:
  const aiScene& scene_;
  std::map<unsigned, std::shared_ptr<const std::string>> known_;
  std::size_t bytes_ = 0;
};

/// What assimp gives to shapes of which the file says nothing: gray or white.
bool is_invented(const Material& material) {
  const bool named = !material.name.empty() && material.name != AI_DEFAULT_MATERIAL_NAME;
  const std::array<float, 4>& color = material.diffuse;
  const bool plain = color[0] == color[1] && color[0] == color[2] && color[3] == 1 &&
                     (color[0] == 0.6F || color[0] == 1);
  return !named && plain && material.texture.empty() && !material.embedded_picture;
}

bool look_alike(const Material& a, const Material& b) {
  return a.diffuse == b.diffuse && a.texture == b.texture &&
         a.embedded_picture == b.embedded_picture && a.picture_opacity == b.picture_opacity;
}

/// The materials of a scene that its shapes use, in order of their use.
class UsedMaterials {
 public:
  explicit UsedMaterials(const aiScene& scene) : scene_(scene), pictures_(scene) {}

  /// Of the material with this index, its name: when another one that looks different has the same,
  /// one with a number.
  const std::string& name(unsigned index) {
    const auto [at, is_new] = names_.try_emplace(index);
    if (is_new && index < scene_.mNumMaterials) {
      at->second = added(material_of(*scene_.mMaterials[index]));
    }
    return at->second;
  }

  std::vector<Material> take() { return std::move(materials_); }

 private:
  std::string added(Material material) {
    if (material.texture.starts_with('*')) {
      material.embedded_picture = pictures_.find(material.texture);
      material.texture.clear();
    }
    if (is_invented(material)) return material.name;
    const std::string own = material.name;
    for (unsigned number = 2;; ++number) {
      const auto [at, is_new] = by_name_.try_emplace(material.name, materials_.size());
      if (is_new) materials_.push_back(material);
      if (look_alike(materials_[at->second], material)) return material.name;
      material.name = own + '-' + std::to_string(number);
    }
  }

  const aiScene& scene_;
  EmbeddedPictures pictures_;
  std::vector<Material> materials_;
  std::map<std::string, std::size_t> by_name_;
  std::map<unsigned, std::string> names_;  ///< by index
};

// ---- What corners carry

Corners::Texture texture_point(const aiVector3D& from) {
  return std::isfinite(from.x) && std::isfinite(from.y) ? Corners::Texture{from.x, from.y}
                                                        : Corners::Texture{};
}

Corners::Color color(const aiColor4D& from) {
  const Corners::Color read{from.r, from.g, from.b, from.a};
  return std::all_of(read.begin(), read.end(), [](float part) { return std::isfinite(part); })
             ? read
             : kWhite;
}

/// Takes normals of a node's mesh to the whole mesh's frame. (The cofactors of a matrix take the
/// cross product of two vectors to that of their images.)
class NormalTurn {
 public:
  explicit NormalTurn(const Affine& by)
      : cofactors_{cross(by.y, by.z), cross(by.z, by.x), cross(by.x, by.y), {}},
        sign_(determinant(by) < 0 ? -1 : 1) {}

  Corners::Normal operator()(const aiVector3D& n) const {
    return normal_along(sign_ * turned(cofactors_, {n.x, n.y, n.z}));
  }

 private:
  Affine cofactors_;
  double sign_;  ///< the sides of a mirrored surface are exchanged
};

class Baker {
 public:
  explicit Baker(const aiScene& scene) : scene_(scene), materials_(scene) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) census_.push_back(census(*scene.mMeshes[i]));
  }

  LoadedMesh run() {
    if (!scene_.mRootNode) return {.faults = {{FaultKind::kEmpty}}};
    // Counted before anything is allocated: a few nodes can repeat a mesh a billion times.
    const Census& all = all_ = total();
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
      fill(loaded);
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
      all.with_texture += one.with_texture;
      all.with_normals += one.with_normals;
      all.with_colors += one.with_colors;
    });
    return all;
  }

  void fill(LoadedMesh& loaded) {
    TriangleMesh& mesh = loaded.mesh;
    mesh.positions.reserve(all_.vertices);
    mesh.triangles.reserve(all_.triangles);
    if (all_.with_texture > 0) mesh.corners.texture.reserve(all_.triangles);
    if (all_.with_normals > 0) mesh.corners.normals.reserve(all_.triangles);
    if (all_.with_colors > 0) mesh.corners.colors.reserve(all_.triangles);
    for_each_instance(*scene_.mRootNode, {},
                      [&](const aiNode& node, const Affine& X_WN, unsigned index) {
                        if (census_[index].triangles > 0) add(mesh, node, X_WN, index);
                      });
    mesh.materials = materials_.take();
    std::uint64_t bad = 0;
    for (const Vector3& p : mesh.positions) {
      bad += !std::isfinite(p.x) + !std::isfinite(p.y) + !std::isfinite(p.z);
    }
    if (bad == 0) return;
    mesh = {};
    loaded.faults.push_back({.kind = FaultKind::kNotFinite, .count = bad});
  }

  void add(TriangleMesh& into, const aiNode& node, const Affine& X_WN, unsigned index) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    into.parts.push_back({part_name(node, mesh), materials_.name(mesh.mMaterialIndex),
                          into.triangles.size(),
                          static_cast<std::size_t>(census_[index].triangles)});
    const auto base = static_cast<std::uint32_t>(into.positions.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      into.positions.push_back(moved(X_WN, {p.x, p.y, p.z}));
    }
    const std::size_t first = into.triangles.size();
    const bool mirrored = determinant(X_WN) < 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      for (unsigned i = 2; i < face.mNumIndices; ++i) {
        Triangle t{base + face.mIndices[0], base + face.mIndices[i - 1], base + face.mIndices[i]};
        if (mirrored) std::swap(t[1], t[2]);
        into.triangles.push_back(t);
      }
    }
    add_corners(into, mesh, NormalTurn(X_WN), first);
  }

  /// Of the triangles from `first` on, which are those of this mesh.
  void add_corners(TriangleMesh& into, const aiMesh& mesh, const NormalTurn& turn,
                   std::size_t first) const {
    const auto base = static_cast<std::uint32_t>(into.positions.size() - mesh.mNumVertices);
    const auto add = [&](auto& list, std::uint64_t carried, const auto* from, const auto& convert,
                         const auto& otherwise) {
      if (carried == 0) return;
      for (std::size_t i = first; i < into.triangles.size(); ++i) {
        auto& corners = list.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
          corners[c] = from ? convert(from[into.triangles[i][c] - base]) : otherwise;
        }
      }
    };
    Corners& corners = into.corners;
    add(corners.texture, all_.with_texture, mesh.mTextureCoords[0], texture_point,
        Corners::Texture{});
    add(corners.normals, all_.with_normals, mesh.mNormals, turn, Corners::Normal{});
    add(corners.colors, all_.with_colors, mesh.mColors[0], color, kWhite);
  }

  const aiScene& scene_;
  std::vector<Census> census_;  ///< of each mesh
  Census all_;
  UsedMaterials materials_;
};

}  // namespace

LoadedMesh bake(const aiScene& scene) { return Baker(scene).run(); }

}  // namespace rigor::mesh
