// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One <geometry> of a Collada file as triangles: the positions behind its <vertices>, what corners
// carry besides, and the groups (<triangles>, <polylist>, <polygons>, <tristrips>, <trifans>) that
// use them.
//
//   ColladaGeometry shape = read_collada_geometry(index, geometry, budget);

#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include <rigor/mesh/collada/index.h>
#include <rigor/mesh/collada/inputs.h>
#include <rigor/mesh/fault.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct ColladaGroup {
  std::string_view material;  ///< the symbol that instances bind; a view of the document
  /// By kind: of each triangle what its corners have, as items of the geometry's values. All of one
  /// size, which is not 0, or empty where the group has no such input. Polygons are fans.
  std::array<std::vector<Triangle>, kColladaKinds> corners;
  std::array<std::string_view, kColladaKinds> sources;  ///< urls, views of the document
  std::uint64_t line = 0;
};

struct ColladaGeometry {
  std::string_view name;  ///< a view of the document
  /// By kind, `kColladaWidths` numbers each: what the triangles use, in the order of its use.
  /// Positions are finite unless a fault says so.
  std::array<std::vector<double>, kColladaKinds> values;
  std::vector<ColladaGroup> groups;
  std::uint64_t triangles = 0;    ///< of all groups
  std::uint64_t passed_over = 0;  ///< lines, and polygons of fewer than three corners
  std::uint64_t bytes_read = 0;   ///< of numbers, which groups and geometries can share
  std::vector<Fault> faults;
};

/// With a fatal fault the rest is of no use. There is one when more than about `max_bytes` of
/// numbers would be read.
ColladaGeometry read_collada_geometry(const ColladaIndex& index, xml::Element geometry,
                                      std::uint64_t max_bytes);

}  // namespace rigor::mesh
