// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh file put in the place of a collision's or visual's geometry.
//
//   AttachedMesh done = attach_mesh(environment, sources, loaded, "arm::base::hull",
//                                   {"arm/meshes/hull.stl", bounds, {0.001, 0.001, 0.001}});
//   if (done.problem != AttachProblem::kNone) suggest(done.candidates);
//   else write(apply_edits(bytes, done.edits)), copy(done.copy);
//
// The middle of the mesh's bounds comes to lie where the middle of the old shape was; a mesh in the
// place of a mesh keeps the pose, since the two are mostly one part drawn twice.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/mesh_uri.h>
#include <rigor/author/round_axis.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/text/edit.h>
#include <rigor/text/sources.h>

namespace rigor::author {

struct NewMesh {
  std::string path;     ///< see mesh_uri.h
  mesh::Bounds bounds;  ///< in the file's own unit; empty when it has no triangles
  mesh::Vector3 scale{1, 1, 1};
  /// In the file's own unit; they outlive the attaching. Without them only the bounds tell what it is round about.
  std::span<const mesh::Vector3> vertices = {};
};

enum class AttachProblem : std::uint8_t {
  kNone,
  kNotFound,   ///< no shape has that name; `candidates` are like it, or in the link that it names
  kAmbiguous,  ///< `candidates` have it
  kIncluded,   ///< it stands in an included file: `path`
  kPose,       ///< its pose cannot be read
  kCutDocument,
};

/// The mesh is round about another axis of the shape's frame than what it is compared with: a wheel that lies on
/// its side. That is the shape that it replaces, if that is round; else, for a mesh no longer than wide, the joint
/// that turns its link round and round.
struct AxisMismatch {
  Axis mesh = Axis::kZ;
  Axis expected = Axis::kZ;
  std::string joint = {};  ///< name of the joint; empty: compared with the shape
};

struct AttachedMesh {
  AttachProblem problem = AttachProblem::kNone;
  std::vector<std::string> candidates;  ///< names that mean one shape each
  std::string subject;                  ///< "arm/link base/visual hull"
  std::string path;                     ///< of the file that the shape stands in
  std::string uri;
  std::optional<MeshCopy> copy;  ///< without which the URI does not exist
  std::vector<Edit> edits;
  std::optional<AxisMismatch>
      mismatch;  ///< to be reported: the mesh keeps the rotation of the shape
};

/// Candidates that are listed of a model in which nothing is like the name.
inline constexpr std::size_t kMaxCandidates = 8;

/// `name` is that of the collision or visual behind those of its link and models, of which outer
/// ones may be left out: "arm::hand::palm::skin", "palm::skin". Where a collision has a visual's
/// name, "palm::visual skin"; a link's only visual is "palm::visual", and the second of several
/// without a name "palm::visual 2".
AttachedMesh attach_mesh(const Environment& environment, const Sources& sources,
                         const read::Loaded& loaded, std::string_view name, const NewMesh& mesh);

}  // namespace rigor::author
