// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The points behind the <vertices> of a Collada geometry: its POSITION input names a <source>, whose
// <accessor> says how a <float_array> is to be read.
//
//   ColladaPositions source = read_collada_positions(index, "#cube-vertices");
//   if (!source.problem) use(source.positions);

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <rigor/mesh/collada_index.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct ColladaPositions {
  std::vector<Vector3> positions;  ///< no more than the accessor's count, and than there are
  std::uint64_t bytes_read = 0;
  const char* problem = nullptr;  ///< why there are none
};

/// `vertices` is the url in the VERTEX input of a group.
ColladaPositions read_collada_positions(const ColladaIndex& index, std::string_view vertices);

}  // namespace rigor::mesh
