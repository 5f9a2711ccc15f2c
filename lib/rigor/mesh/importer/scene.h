// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Collada, glTF, PLY and other scenes, by assimp in a worker process: its 5.2.5 crashed or ran away on
// 17 of 764 damaged files, and a worker's death is only a fault of the file here. The library is
// opened in the worker alone, when it is first needed, so that no other run pays for it. A Collada
// file that it refuses, or dies of, is read by rigor's own reader (mesh/collada/collada.h), which does not mind a
// texture that is not defined.
//
// What a file is, its bytes say before its ending does.
//
// The scene's transforms are applied. A Collada file's `<unit>` is applied, its `<up_axis>` is not, as
// Gazebo does (other consumers turn Y-up files). Mirrored nodes keep their outside outside: the
// winding of their triangles is swapped.
//
//   const process::Workers workers;
//   for (const std::string& path : paths) use(read_scene(disk, path, workers));

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/mesh/read.h>
#include <rigor/process/request.h>
#include <rigor/process/serve.h>
#include <rigor/process/workers.h>
#include <rigor/text/disk.h>

namespace rigor::mesh {

/// What importing one file may take: a Collada file of a million triangles took 1.4 s and 0.8 GB, a damaged one of
/// some kilobytes whatever it was given. `allow_imports` gives more memory, and a large file has more time.
inline constexpr process::RequestLimits kImportLimits{.cpu_seconds = 6,
                                                      .memory_bytes = std::uint64_t{1} << 30U};
inline constexpr std::uint64_t kBytesPerImportSecond = 10'000'000;

/// How much memory the import of one file may take from now on; before the first one.
void allow_imports(process::Workers& workers, std::uint64_t bytes);

/// Files that the scene names (buffers of a .gltf) are read through `disk` too, when they lie in the
/// scene's folder or below.
LoadedMesh read_scene(const Disk& disk, const std::string& path, const process::Workers& workers);

/// What assimp alone makes of the file at `path` with these bytes; the path's ending says its format.
LoadedMesh import_scene(const Disk& disk, const std::string& path, std::string_view bytes,
                        const process::Workers& workers);

/// Which importer there is: "assimp 5.2.5", or why there is none. A worker is asked.
std::string scene_importer(const process::Workers& workers);

/// What a worker has to serve for these.
process::Service import_service();
process::Service importer_name_service();

}  // namespace rigor::mesh
