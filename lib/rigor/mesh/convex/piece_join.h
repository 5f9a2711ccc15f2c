// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Convex hulls joined, two at a time, until they are few.
//
//   join_hulls(hulls, 16, 1e-6 * volume);

#pragma once

#include <cstddef>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct Hull {
  TriangleMesh mesh;
  double volume = 0;
};

/// Joins those whose common hull has least more volume than both; down to `count`, and further as
/// long as it has no more than `free` more.
void join_hulls(std::vector<Hull>& hulls, std::size_t count, double free);

}  // namespace rigor::mesh
