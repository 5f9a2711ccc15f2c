// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/triangle_mesh.h>

#include <algorithm>
#include <limits>

namespace rigor::mesh {

Bounds bounds_of(const std::vector<Vector3>& positions) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Bounds bounds{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  for (const Vector3& p : positions) {
    bounds.min = {std::min(bounds.min.x, p.x), std::min(bounds.min.y, p.y),
                  std::min(bounds.min.z, p.z)};
    bounds.max = {std::max(bounds.max.x, p.x), std::max(bounds.max.y, p.y),
                  std::max(bounds.max.z, p.z)};
  }
  return bounds;
}

double diagonal(const Bounds& bounds) {
  const bool holds_nothing = bounds.min.x > bounds.max.x;
  return holds_nothing ? 0 : model::length(bounds.max - bounds.min);
}

}  // namespace rigor::mesh
