// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz 60 stl`: any bytes, as an STL and as an OBJ.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <rigor/mesh/obj.h>
#include <rigor/mesh/stl.h>

namespace {

using rigor::mesh::LoadedMesh;
using rigor::mesh::Triangle;

/// Stops the run unless what was read is empty or a mesh.
void expect_sound(const LoadedMesh& loaded) {
  bool sound = loaded.usable() != loaded.mesh.triangles.empty();
  for (const Triangle& t : loaded.mesh.triangles) {
    for (const std::uint32_t corner : t) sound = sound && corner < loaded.mesh.positions.size();
  }
  for (const rigor::model::Vector3& p : loaded.mesh.positions) {
    sound = sound && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }
  if (!sound) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  expect_sound(rigor::mesh::read_stl(bytes));
  expect_sound(rigor::mesh::read_obj(bytes));
  return 0;
}
