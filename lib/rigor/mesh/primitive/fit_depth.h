// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How deep inside a primitive a mesh's surface lies.
//
//   const double gap = deepest(mesh, Sphere{.radius = 0.1}, X_MP);

#pragma once

#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/model/pose.h>

namespace rigor::mesh {

/// What is found falls short of the deepest by this share of the primitive's size at most.
inline constexpr double kDepthTolerance = 1e-4;

/// The greatest distance of a point of a triangle to the surface of the primitive at `X_MP`, which
/// holds the mesh.
double deepest(const TriangleMesh& mesh, const Primitive& primitive, const model::Pose& X_MP);

}  // namespace rigor::mesh
