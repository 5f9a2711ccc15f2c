// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/turn.h>

#include <algorithm>
#include <cmath>

namespace rigor::view {

using model::Quaternion;
using model::Vector3;

Quaternion turn_from_z(const Vector3& direction) {
  const Vector3 d = (1 / length(direction)) * direction;
  if (d.z < -1 + 1e-12) return {0, 1, 0, 0};
  return normalized(Quaternion{1 + d.z, -d.y, d.x, 0});
}

/// By the largest of the four parts, so that none is divided by little (S. W. Shepperd, "Quaternion from
/// rotation matrix", Journal of Guidance and Control 1, 1978).
Quaternion turn_to(const std::array<Vector3, 3>& axes) {
  const auto& [x, y, z] = axes;
  const std::array<double, 4> fourfold{1 + x.x + y.y + z.z, 1 + x.x - y.y - z.z,
                                       1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z};
  const auto largest = std::max_element(fourfold.begin(), fourfold.end()) - fourfold.begin();
  const double f = fourfold[static_cast<std::size_t>(largest)];
  switch (largest) {
    case 0: return normalized(Quaternion{f, y.z - z.y, z.x - x.z, x.y - y.x});
    case 1: return normalized(Quaternion{y.z - z.y, f, x.y + y.x, z.x + x.z});
    case 2: return normalized(Quaternion{z.x - x.z, x.y + y.x, f, y.z + z.y});
    default: return normalized(Quaternion{x.y - y.x, z.x + x.z, y.z + z.y, f});
  }
}

}  // namespace rigor::view
