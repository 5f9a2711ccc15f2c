// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Makes a scene of what was read from a file, and says what of it is not simulated as it is written.
//
// A file with a model at the top gets level ground at z = 0 (a scenario may leave it out); a world has
// what it holds. SDF's `<surface>`, `<physics>`, `<self_collide>` and their like, and URDF's `<gazebo>`
// blocks, are read here from the elements, since no other room asks for them.
//
//   SceneResult made = build_scene({loaded.root, frames, documents, lookups}, {});
//
// Nothing that an engine would abort on, or take silently and spoil, is in a scene that is not blocked:
// every number is finite, sizes and masses are positive, tensors are those of rigid bodies, axes have
// length 1, indices are in range.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rigor/mass/find_mesh.h>
#include <rigor/mesh/image/height_picture.h>
#include <rigor/mesh/read.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/read/documents.h>
#include <rigor/simulate/fact.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// The triangles of the mesh that a shape names; null when there are none. In the file's unit.
using LoadMesh = std::function<const mesh::LoadedMesh*(const model::Mesh&)>;

/// The picture of a heightmap, or why there is none.
struct LoadedHeights {
  std::optional<mesh::HeightPicture> picture;
  std::string why;  ///< "valley.tif is not a PNG"
};
using LoadHeights = std::function<const LoadedHeights&(const model::Heightmap&)>;

struct SceneInput {
  const model::Root& root;
  const model::Frames& frames;  ///< at the joint positions that the run begins with
  const read::Documents& documents;
  mass::FindMesh find_mesh;  ///< for masses
  LoadMesh load_mesh;        ///< for shapes
  LoadHeights load_heights;
  model::JointPositions positions = {};  ///< those of `frames`
  /// Joints that begin at a limit, since zero is beyond it.
  std::vector<model::Id<model::Joint>> moved = {};
};

/// What is made of a mesh that collides.
enum class MeshAs : std::uint8_t {
  kAuto,       ///< the primitive it nearly is; else the hull when it is convex; else its triangles
  kTriangles,  ///< as it is
  kHull,
};

struct SceneOptions {
  std::string
      model;  ///< of several at the top of a file, the one to take; all of a world when empty
  MeshAs meshes = MeshAs::kAuto;
  /// Gazebo's own solver settings instead of rigor's (docs/simulate.md).
  enum class Profile : std::uint8_t { kRigor, kGazebo } profile = Profile::kRigor;
  /// Whether a test may move a body that no joint carries. One that is held needs no mass.
  enum class Root : std::uint8_t { kFree, kHeld } root = Root::kFree;
};

struct SceneResult {
  Scene scene;
  Facts facts;

  /// Whether a fact says that it cannot be simulated.
  bool blocked() const;
};

SceneResult build_scene(const SceneInput& input, const SceneOptions& options);

}  // namespace rigor::simulate
