// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// All that is known of a mesh file: what its bytes say, how its triangles hang together, what they
// enclose. Rules turn it into findings, `mesh-check` prints it.
//
//   MeshFacts facts = mesh_facts(disk, "meshes/hull.stl", MeshDepth::kAll, environment.workers);
//   if (facts.shape && !facts.shape->topology.closed()) say("open");

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/mass/polyhedron.h>
#include <rigor/mesh/asset/asset.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/spatial/self_intersection.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/process/workers.h>
#include <rigor/text/disk.h>
#include <rigor/text/found_once.h>

namespace rigor::mass {

/// How much is asked of a mesh.
enum class MeshDepth : std::uint8_t {
  kFile,   ///< what a picture needs: that it can be read, its size, its textures
  kShape,  ///< and what contacts need: `MeshShape`, self-intersections only of small meshes
  kAll,    ///< and self-intersections of any
};

/// Triangles of a mesh whose self-intersections are looked for at `kShape`: some milliseconds. A
/// collision of more has a finding for that.
inline constexpr std::uint64_t kSmallMesh = 5000;

/// Of triangles that count: degenerate ones enclose nothing.
struct MeshShape {
  mesh::Topology topology;
  PolyhedronMoments moments;  ///< of an open mesh, with cones to the reference
  bool convex = false;        ///< closed, wound outward, and as large as its hull
  std::optional<mesh::SelfIntersections> self_intersections;  ///< nothing when not looked for
};

struct MeshFacts {
  std::string path;
  std::uint64_t bytes = 0;  ///< of the file
  mesh::Format format = mesh::Format::kUnknown;
  std::vector<mesh::Fault> faults;
  mesh::Asset asset;  ///< when a fault is fatal, of glTF only, and without textures

  // Nothing of what follows when a fault is fatal.
  std::uint64_t triangles = 0;
  std::uint64_t largest_part = 0;  ///< vertices of the part that has most, as a renderer needs them
  bool normals = false;            ///< corners carry some
  mesh::Bounds bounds;             ///< of what triangles use; meters, or the file's own unit
  std::optional<MeshShape> shape;  ///< from `kShape` on

  bool usable() const;  ///< no fault is fatal
  bool whole() const;   ///< and nothing of the mesh is missing
};

/// A scene is read by one of the workers.
MeshFacts mesh_facts(const Disk& disk, const std::string& path, MeshDepth depth,
                     const process::Workers& workers);
/// The same with a worker of its own.
MeshFacts mesh_facts(const Disk& disk, const std::string& path, MeshDepth depth);

/// The same of a mesh that was read already.
MeshFacts mesh_facts(const Disk& disk, const std::string& path, const mesh::LoadedMesh& loaded,
                     MeshDepth depth);

class MeshCache;
class MeshReads;

/// What spares looking at a mesh again, where there is such; it outlives who uses it.
struct MeshMemory {
  const MeshCache* cache = nullptr;  ///< what earlier runs found
  MeshReads* reads = nullptr;        ///< what is in memory
  /// That read scenes where the others do not; without them each scene gets a worker of its own.
  const process::Workers* workers = nullptr;

  Turns* turns() const;  ///< of those who ask; null when there are none
};

/// Facts found once, however many links use a mesh. Safe across threads.
class MeshFiles {
 public:
  /// Each mesh is examined as deep as is asked, and at least as deep as `least`.
  explicit MeshFiles(const Disk& disk, MeshDepth least = MeshDepth::kFile, MeshMemory memory = {})
      : disk_(disk), min_(least), memory_(memory), known_(memory.turns()) {}

  const MeshFacts& find(const std::string& path, MeshDepth depth);

 private:
  const Disk& disk_;
  MeshDepth min_;
  MeshMemory memory_;
  FoundOnce<std::pair<std::string, MeshDepth>, MeshFacts> known_;
};

}  // namespace rigor::mass
