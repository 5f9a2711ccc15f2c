// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a mesh file encloses, found in one pass over its triangles: moments, whether it is closed,
// whether it counts a place twice. A binary STL is streamed, so that a million triangles cost little
// more than reading them and no memory; any other format is read whole.
//
//   MeshSurvey survey = survey_mesh(disk, {"meshes/hull.stl"});
//   MeshBody body = body_of(survey, scale);
//   if (body.solid) use(*body.solid); else say(body.state);
//
// The result is the same to the last bit for any number of threads.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <rigor/mass/mesh/facts.h>
#include <rigor/mass/mesh/state.h>
#include <rigor/mass/polyhedron.h>
#include <rigor/mass/shapes.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/mesh/topology/winding.h>
#include <rigor/model/geometry.h>
#include <rigor/process/workers.h>
#include <rigor/text/disk.h>
#include <rigor/text/found_once.h>

namespace rigor::mass {

/// A mesh file, or a part of it.
struct MeshChoice {
  std::string path;
  std::string submesh = {};  ///< name of a part; empty for the whole
  bool center = false;       ///< the part is moved so that the middle of its bounds is the origin
  /// With this scale it is weighed as a sheet as well: what has an area, scaled unevenly, has another one.
  std::optional<model::Vector3> sheet_scale = {};
};

/// The file of the shape's mesh at that path.
MeshChoice mesh_choice(const std::string& path, const model::Mesh& mesh);

struct MeshSurvey {
  mesh::Format format = mesh::Format::kUnknown;
  std::vector<mesh::Fault>
      faults;  ///< with a fatal one, the rest is empty, but for the hull of bare vertices
  std::uint64_t triangles = 0;
  mesh::Bounds bounds;        ///< in the file's own unit
  PolyhedronMoments moments;  ///< of what the triangles enclose, as they are wound
  bool closed = false;        ///< every directed edge is met by its reverse
  mesh::Winding winding;
  /// Where the mesh is not closed.
  std::optional<mesh::Topology> topology;
  /// Of the convex hull, where the mesh itself is no solid; nothing when it is flat as well.
  std::optional<PolyhedronMoments> hull;
  /// Likewise, as MuJoCo weighs it (pyramids.h).
  std::optional<PolyhedronMoments> pyramids;
  std::optional<PolyhedronMoments> pyramids_as_wound;
  /// Of the surface, scaled, 1 m thick; where it was asked for and there is a surface.
  std::optional<Solid> sheet;

  bool usable() const;  ///< no fault is fatal
};

/// `threads` of zero means as many as there are cores. A scene is read by one of the workers.
MeshSurvey survey_mesh(const Disk& disk, const MeshChoice& choice, const process::Workers& workers,
                       unsigned threads = 1);
/// The same with a worker of its own.
MeshSurvey survey_mesh(const Disk& disk, const MeshChoice& choice, unsigned threads = 1);

/// The same of a mesh that others look at as well. One of a binary STL that is large is streamed even so.
MeshSurvey survey_mesh(const Disk& disk, const MeshChoice& choice, MeshReads& reads);

/// Surveys made once, however many links use a mesh. Safe across threads.
class MeshSurveys {
 public:
  explicit MeshSurveys(const Disk& disk, MeshMemory memory = {})
      : disk_(disk), memory_(memory), known_(memory.turns()) {}

  const MeshSurvey& find(const MeshChoice& choice);

 private:
  const Disk& disk_;
  MeshMemory memory_;
  FoundOnce<std::tuple<std::string, std::string, bool, std::array<double, 3>>, MeshSurvey> known_;
};

/// Overlap up to this share of the inside is taken for the modeler's way to join parts.
inline constexpr double kMaxDoubled = 0.01;

struct MeshBody {
  MeshState state = MeshState::kUnusable;
  /// In the mesh's frame: the mesh itself when it is a solid; inside out, what it is when turned;
  /// else its convex hull. Nothing when it has no volume.
  std::optional<Solid> solid;
  BodyFrom from = BodyFrom::kMesh;
};

/// The mesh with its coordinates multiplied by `scale`, axis by axis.
MeshBody body_of(const MeshSurvey& survey, const model::Vector3& scale);

}  // namespace rigor::mass
