// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string_view>

#include <rigor/mesh/normals.h>
#include <rigor/mesh/stl/stl.h>
#include <rigor/mesh/write/parts.h>
#include <rigor/mesh/write/write.h>

namespace rigor::mesh {
namespace {

// Not "solid", by which readers tell the text form.
constexpr std::string_view kTitle = "binary STL";

void append_floats(std::string& bytes, const Vector3& p) {
  for (const double coordinate : {p.x, p.y, p.z}) {
    append_bytes(bytes, static_cast<float>(as_float(coordinate)));
  }
}

}  // namespace

std::string write_stl(const TriangleMesh& mesh) {
  std::string bytes(kTitle);
  bytes.reserve(kStlHeaderBytes + kStlFacetBytes * mesh.triangles.size());
  bytes.resize(kStlHeaderBytes - sizeof(std::uint32_t));
  append_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const Facet corners = facet(mesh, t);
    append_bytes(bytes, normal_of(corners));
    for (const Vector3& corner : corners) append_floats(bytes, corner);
    bytes.append(2, '\0');  // attributes
  }
  return bytes;
}

}  // namespace rigor::mesh
