// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What collides in place of a mesh. Private to the room.
//
//   MeshShapes meshes(load_mesh);
//   MeshShape* shape = meshes.find(collision_mesh);   // null: there is no mesh
//   if (fills(*shape, *fit_of(*shape))) use(fit.shape, fit.pose);

#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include <rigor/mesh/primitive/fit.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/geometry.h>
#include <rigor/simulate/scene/build.h>

namespace rigor::simulate {

/// A mesh is taken for the primitive around it when its hull fills so much of that, and it so much of its
/// hull. Of a wheel that is a prism with n sides, 32 fill 0.994, 16 fill 0.974, 12 fill 0.955: from 16 on
/// the sides are within 2 % of the radius, and rolling on them is noise (reference: 3 to 16 % of the way
/// is lost, it bounces at 3 to 6 cm/s).
inline constexpr double kNearlyPrimitive = 0.97;
/// Of a ball, for the same 2 % of the radius: (1 - 0.02)³.
inline constexpr double kNearlySphere = 0.94;
/// A closed mesh is convex when it fills its hull but for what coordinates lose that are written with
/// few digits.
inline constexpr double kNearlyConvex = 0.999;

/// Meshes with more triangles are not examined closer: their hull costs a second.
inline constexpr std::size_t kMaxFittedTriangles = 200'000;
/// More are no collision but somebody's drawing, and the hull is taken: ODE tests the triangles at each
/// step.
inline constexpr std::size_t kMaxTriangles = 1'000'000;

struct MeshShape {
  mesh::TriangleMesh mesh;  ///< the chosen part, centered and scaled, without flat triangles
  /// Nothing when the mesh is flat, or has more triangles than are examined.
  std::optional<mesh::TriangleMesh> hull;
  double hull_share = 0;         ///< of the hull's volume that the mesh encloses; 0 when it is open
  std::optional<mesh::Fit> fit;  ///< of the hull, once it was asked for
  std::uint32_t index = kWorld;  ///< in the scene, once it is there
  std::uint32_t hull_index = kWorld;  ///< likewise its hull

  bool convex() const { return hull_share >= kNearlyConvex; }
};

/// The primitive around it; null when it has no hull. Worked out once.
const mesh::Fit* fit_of(MeshShape& shape);

/// Whether the hull is nearly the primitive.
bool is_nearly(const mesh::Fit& fit);

class MeshShapes {
 public:
  explicit MeshShapes(LoadMesh load) : load_(std::move(load)) {}

  /// Null when there is no mesh, or none with an area.
  MeshShape* find(const model::Mesh& mesh);

 private:
  using Key = std::tuple<const mesh::LoadedMesh*, std::string, bool, std::array<double, 3>>;
  LoadMesh load_;
  std::map<Key, std::unique_ptr<MeshShape>> known_;
};

}  // namespace rigor::simulate
