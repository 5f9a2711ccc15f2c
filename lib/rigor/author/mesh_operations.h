// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What can be done to a mesh, always in this order, so that a command line has one meaning:
//
//   1. weld, repair
//   2. unit, scale, up axis
//   3. center
//   4. normals
//   5. reduce
//   6. one of: convex hull, convex pieces, a fitted primitive, parts by component or material
//
//   OperatedMesh done = operate(std::move(mesh), {.repair = true, .center = MeshCenter::kCom});
//   for (const MeshStep& step : done.steps) say(step.name, step.what);

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/mesh/primitive/fit.h>
#include <rigor/mesh/transform.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::author {

enum class MeshCenter : std::uint8_t {
  kNone,
  kCom,     ///< of what the mesh encloses; of its convex hull, when it encloses nothing
  kBounds,  ///< the middle of the box around it
  kBottom,  ///< the middle of that box's lower face
};

enum class MeshProduct : std::uint8_t {
  kMesh,
  kConvexHull,
  kConvexPieces,
  kPrimitive,
  kComponents,
  kMaterials,
};

struct MeshOperations {
  bool weld = false;
  bool repair = false;
  double unit = 1;  ///< meters that a unit of the file is
  model::Vector3 scale{1, 1, 1};
  mesh::UpAxis up = mesh::UpAxis::kZ;
  MeshCenter center = MeshCenter::kNone;
  std::optional<double> crease;            ///< rad; normals anew, smooth across edges of less
  std::optional<std::uint64_t> triangles;  ///< to be left
  std::optional<double> share;             ///< of the triangles, to be left
  std::optional<double> max_error;         ///< m; reducing stops there
  bool keep_seams = false;                 ///< of texture and color, whatever they cost
  MeshProduct product = MeshProduct::kMesh;
  std::uint64_t pieces = 16;                       ///< at most, of `kConvexPieces`
  mesh::FitKind primitive = mesh::FitKind::kBest;  ///< of `kPrimitive`
};

/// A step that was done: "fill holes", "3 filled, 12 triangles added".
struct MeshStep {
  std::string name;
  std::string what;
};

struct NamedMesh {
  std::string name;  ///< as a file's (`write/safe_name.h`); empty when there is only one
  mesh::TriangleMesh mesh;
};

struct OperatedMesh {
  std::vector<NamedMesh> meshes;
  std::vector<MeshStep> steps;
  mesh::Transform transform;           ///< what was done to the coordinates, the centering aside
  model::Vector3 translation;          ///< of the centering
  std::optional<double> hausdorff;     ///< between the meshes before and after reducing, m
  std::optional<mesh::Fit> primitive;  ///< what the mesh was replaced with
  std::string problem;                 ///< why there are no meshes
};

OperatedMesh operate(mesh::TriangleMesh mesh, const MeshOperations& operations);

}  // namespace rigor::author
