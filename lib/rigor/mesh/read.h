// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a mesh file of any known format into memory, within bounds.
//
// STL and OBJ are read by rigor itself, since the file is what is checked; Collada, glTF, PLY and
// what else there is by an importer in a worker process (mesh/importer/scene.h), because importers crash.
//
//   LoadedMesh loaded = read_mesh(disk, "meshes/wheel.stl", environment.workers);
//   if (!loaded.usable()) explain(loaded.faults);
//   else integrate(loaded.mesh);

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mesh/fault.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/process/workers.h>
#include <rigor/text/disk.h>

namespace rigor::mesh {

enum class Format : std::uint8_t {
  kUnknown,
  kStlBinary,
  kStlAscii,
  kObj,
  kCollada,
  kGltf,
  kGlb,
  kPly,
  kOther
};

/// "stl", "obj", "dae", "gltf", "glb", "ply", "other" and "unknown".
std::string_view to_string(Format format);

/// Whether the name ends as those of meshes do: .stl, .obj, .dae, .gltf, .glb, .ply, in any letter case.
bool has_mesh_ending(std::string_view path);

/// Larger files are refused unread. The largest seen among 3,400 real models has 30 MB.
inline constexpr std::uint64_t kMaxMeshBytes = std::uint64_t{2} << 30U;

/// More triangles, or vertices, are refused: 100 million take 6 GB.
inline constexpr std::uint64_t kMaxTriangles = 50'000'000;

struct LoadedMesh {
  Format format = Format::kUnknown;
  TriangleMesh mesh;
  std::vector<Fault> faults;

  bool usable() const;  ///< no fault is fatal
};

/// So many bytes of a file's beginning tell its format.
inline constexpr std::size_t kProbeBytes = 512;

/// By the bytes first, then by the ending: files lie about what they are.
Format format_of(std::string_view first_bytes, std::uint64_t size, std::string_view path);

/// Scenes are imported by one of the workers.
LoadedMesh read_mesh(const Disk& disk, const std::string& path, const process::Workers& workers);

/// The same with a worker of its own, for one file: it costs the start of a program when that is a scene.
LoadedMesh read_mesh(const Disk& disk, const std::string& path);

}  // namespace rigor::mesh
