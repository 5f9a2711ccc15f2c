// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How the surfaces of a Collada file look: the diffuse color or picture, and the opacity, of the
// effect behind a <material>. What is said in other ways, such as by a <param>, is not known.
//
//   ColladaMaterials materials(index);
//   part.material = materials.name(*index.find("#steel", "material"));
//   mesh.materials = materials.take();

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/mesh/collada/index.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// Of longer names this much is kept: each part repeats them.
inline constexpr std::size_t kMaxColladaName = 256;

/// Pictures behind a longer path are none.
inline constexpr std::size_t kMaxColladaPicture = 1024;

/// The materials that shapes use, in the order of their use.
class ColladaMaterials {
 public:
  /// The index must outlive this.
  explicit ColladaMaterials(const ColladaIndex& index);

  /// Of a <material> its name, or else its id; when one before it in the file has the same, with a
  /// number behind a blank, as the importer of scenes does. That of one without an effect is not in
  /// the list.
  const std::string& name(xml::Element material);

  std::vector<Material> take() { return std::move(materials_); }

 private:
  const ColladaIndex& index_;
  std::vector<Material> materials_;
  std::map<std::uint32_t, std::string> names_;  ///< by the index of the element
  std::map<std::uint32_t, Material> effects_;   ///< likewise, without names
  std::set<std::uint32_t> listed_;              ///< indices of elements
};

}  // namespace rigor::mesh
