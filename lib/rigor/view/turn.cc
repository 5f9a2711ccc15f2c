// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/turn.h>

#include <cmath>

namespace rigor::view {

using model::Quaternion;
using model::Vector3;

Quaternion turn_from_z(const Vector3& direction) {
  const Vector3 d = (1 / length(direction)) * direction;
  if (d.z < -1 + 1e-12) return {0, 1, 0, 0};
  return normalized(Quaternion{1 + d.z, -d.y, d.x, 0});
}

}  // namespace rigor::view
