// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Collada, glTF, PLY and other scenes, by assimp in a child process: its 5.2.5 crashed or ran away on
// 17 of 764 damaged files, and a child's death is only a fault of the file here. The library is
// opened in the child alone, when it is first needed, so that no other run pays for it. A Collada
// file that it refuses, or dies of, is read by rigor's own reader (mesh/collada/collada.h), which does not mind a
// texture that is not defined.
//
// What a file is, its bytes say before its ending does.
//
// The scene's transforms are applied. A Collada file's `<unit>` is applied, its `<up_axis>` is not, as
// Gazebo does (other consumers turn Y-up files). Mirrored nodes keep their outside outside: the
// winding of their triangles is swapped.
//
//   LoadedMesh loaded = read_scene(disk, "meshes/arm.dae");
//
//   const SceneImporter importer;                                    // for many
//   for (const std::string& path : paths) use(read_scene(disk, path, importer));

#pragma once

#include <string>
#include <string_view>

#include <rigor/mesh/read.h>
#include <rigor/process/fork_server.h>
#include <rigor/text/disk.h>

namespace rigor::mesh {

/// Seconds of CPU time and bytes of memory that importing one file may take: a Collada file of a
/// million triangles took 1.4 s and 0.8 GB.
inline constexpr unsigned kImportSeconds = 20;
inline constexpr std::uint64_t kImportBytes = std::uint64_t{4} << 30U;

/// Opens the library once, in a process that the children are forked from, when the first scene comes.
/// Safe across threads.
class SceneImporter {
 public:
  SceneImporter();

  /// Says that many scenes may come: this process has little memory to copy now. Costs 1 ms if none does.
  void expect_many() const { server_.start(); }

  /// `bytes` are those of the file at `path`, whose ending says its format.
  LoadedMesh import(const Disk& disk, const std::string& path, std::string_view bytes) const;

 private:
  process::ForkServer server_;
};

/// Files that the scene names (buffers of a .gltf) are read through `disk` too, when they lie in the
/// scene's folder or below.
LoadedMesh read_scene(const Disk& disk, const std::string& path, const SceneImporter& importer);
LoadedMesh read_scene(const Disk& disk, const std::string& path);

/// Which importer there is: "assimp 5.2.5". It is asked in a child process, which takes some 20 ms.
std::string scene_importer();

}  // namespace rigor::mesh
