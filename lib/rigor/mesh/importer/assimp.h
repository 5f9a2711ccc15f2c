// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The importer of scenes itself, with the library assimp, which is opened when it is first called. Only
// for a worker process (scene.h): it may crash, run away or never give back its memory.
//
//   LoadedMesh loaded = import_with_assimp(disk, "meshes/arm.dae", bytes);

#pragma once

#include <string>
#include <string_view>

#include <rigor/mesh/read.h>
#include <rigor/text/disk.h>

namespace rigor::mesh {

/// `bytes` are those of the file at `path`. Files that it names are read through `disk` when they
/// lie in its folder or below; others are not there. Throws std::bad_alloc.
LoadedMesh import_with_assimp(const Disk& disk, const std::string& path, std::string_view bytes);

/// "assimp 5.2.5", or why there is none.
std::string assimp_version();

}  // namespace rigor::mesh
