// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz 60 scene`: any bytes as a file of a scene, through the importer in its child process
// and through rigor's own reader of Collada. The first byte says which ending the file has, so that
// each of the importer's formats has its turn.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/mesh/collada.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/topology.h>
#include <rigor/text/disk.h>

namespace {

using rigor::mesh::LoadedMesh;
using rigor::mesh::Triangle;

/// Stops the run unless what was read is empty or a mesh.
void expect_sound(const LoadedMesh& loaded) {
  const std::size_t count = loaded.mesh.triangles.size();
  bool sound = loaded.usable() != loaded.mesh.triangles.empty();
  for (const Triangle& t : loaded.mesh.triangles) {
    for (const std::uint32_t corner : t) sound = sound && corner < loaded.mesh.positions.size();
  }
  for (const rigor::model::Vector3& p : loaded.mesh.positions) {
    sound = sound && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }
  const auto& corners = loaded.mesh.corners;
  sound = sound && (corners.texture.empty() || corners.texture.size() == count);
  sound = sound && (corners.normals.empty() || corners.normals.size() == count);
  sound = sound && (corners.colors.empty() || corners.colors.size() == count);
  if (!sound) __builtin_trap();
  if (loaded.usable() && count < 1000) rigor::mesh::topology_of(loaded.mesh);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array<std::string_view, 5> kEndings{".dae", ".glb", ".gltf", ".ply", ".obj"};
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::string path = "mesh" + std::string(kEndings[data[0] % kEndings.size()]);
  rigor::MemoryDisk disk;
  disk.put(path, std::string(bytes));
  expect_sound(rigor::mesh::read_mesh(disk, path));
  expect_sound(rigor::mesh::read_collada(bytes));
  return 0;
}
