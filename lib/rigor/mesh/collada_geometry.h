// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One <geometry> of a Collada file as triangles: the positions behind its <vertices> and the groups
// (<triangles>, <polylist>, <polygons>, <tristrips>, <trifans>) that use them. Normals, colours and
// texture coordinates are passed over.
//
//   ColladaGeometry shape = read_collada_geometry(index, geometry);

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/mesh/collada_index.h>
#include <rigor/mesh/fault.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct ColladaGroup {
  std::string_view material;        ///< the symbol that instances bind; a view of the document
  std::vector<Triangle> triangles;  ///< never empty; polygons are fans
  std::uint64_t line = 0;
};

struct ColladaGeometry {
  std::string_view name;           ///< a view of the document
  std::vector<Vector3> positions;  ///< those that the triangles use, in the order of their use
  std::vector<ColladaGroup> groups;
  std::uint64_t triangles = 0;    ///< of all groups
  std::uint64_t passed_over = 0;  ///< lines, and polygons of fewer than three corners
  std::uint64_t bytes_read = 0;   ///< of coordinates, which geometries can share
  std::vector<Fault> faults;
};

/// With a fatal fault the rest is of no use.
ColladaGeometry read_collada_geometry(const ColladaIndex& index, xml::Element geometry);

}  // namespace rigor::mesh
