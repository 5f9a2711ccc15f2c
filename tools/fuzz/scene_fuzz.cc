// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz 60 scene`: any bytes as a file of a scene, through the importer in a worker process
// and through rigor's own reader of Collada; and what they say beside triangles. The first byte says
// which ending the file has, so that each of the importer's formats has its turn.

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

#include <rigor/mesh/asset/asset.h>
#include <rigor/mesh/collada/collada.h>
#include <rigor/mesh/importer/scene.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/text/disk.h>

#include "sound.h"

namespace {

using rigor::mesh::LoadedMesh;

// Larger meshes take time that is better spent on other bytes.
constexpr std::size_t kSmall = 1000;

constexpr std::uint64_t kImportBytes = std::uint64_t{128} << 20U;

/// To fill the gigabyte that users allow takes a sanitized worker seconds, which is no fault of the file's.
const rigor::process::Workers& small_workers() {
  static rigor::process::Workers workers;
  static std::once_flag once;
  std::call_once(once, [] { rigor::mesh::allow_imports(workers, kImportBytes); });
  return workers;
}

void look_at(const LoadedMesh& loaded) {
  rigor::fuzz::expect_sound(loaded);
  if (loaded.usable() && loaded.mesh.triangles.size() < kSmall) {
    rigor::mesh::topology_of(loaded.mesh);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array<std::string_view, 5> kEndings{".dae", ".glb", ".gltf", ".ply", ".obj"};
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::string path = "mesh" + std::string(kEndings[data[0] % kEndings.size()]);
  rigor::MemoryDisk disk;
  disk.put(path, std::string(bytes));
  disk.put("mesh.mtl", std::string(bytes));
  const LoadedMesh loaded = rigor::mesh::read_mesh(disk, path, small_workers());
  look_at(loaded);
  look_at(rigor::mesh::read_collada(bytes));
  rigor::mesh::asset_of(disk, path, loaded.format);
  return 0;
}
