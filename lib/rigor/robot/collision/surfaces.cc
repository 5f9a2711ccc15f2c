// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/collision/surfaces.h>

namespace rigor::robot {

FindSurface surface_finder(mass::MeshReads& reads) {
  return [&reads](const Shape& shape) -> FoundSurface {
    if (shape.path.empty()) return {nullptr, shape.uri + " is not found"};
    if (!shape.submesh.empty()) return {nullptr, shape.uri + ": parts of a mesh are not supported"};
    const auto loaded = reads.find(shape.path);
    if (!loaded->usable() || loaded->mesh.triangles.empty())
      return {nullptr, shape.uri + " cannot be read"};
    return {{loaded, &loaded->mesh}};
  };
}

}  // namespace rigor::robot
