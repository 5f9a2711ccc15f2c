// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Geometries of a Collada file where nodes put them, as one mesh: as mesh/importer/bake.h does with a scene of
// the importer's. One part for each group of polygons of each placement.
//
//   TriangleMesh mesh = bake_collada(index, placements);

#pragma once

#include <string_view>
#include <vector>

#include <rigor/mesh/affine.h>
#include <rigor/mesh/collada/geometry.h>
#include <rigor/mesh/collada/index.h>
#include <rigor/mesh/collada/scene.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

/// One geometry where a node puts it.
struct ColladaPlacement {
  std::string_view name;  ///< of the node
  const ColladaInstance* instance;
  const ColladaGeometry* shape;  ///< without a fatal fault
  Affine X_WN;
};

TriangleMesh bake_collada(const ColladaIndex& index,
                          const std::vector<ColladaPlacement>& placements);

}  // namespace rigor::mesh
