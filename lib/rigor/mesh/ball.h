// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

// A ball around points or a shape, in meters, in the frame of what it is around.

#pragma once

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Ball {
  Vector3 center;
  double radius = 0;
};

}  // namespace rigor::mesh
