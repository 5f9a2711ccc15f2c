// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <rigor/mesh/read.h>
#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

constexpr double kMaxFloat = std::numeric_limits<float>::max();
constexpr double kMaxDouble = std::numeric_limits<double>::max();

struct Writer {
  std::string_view ending;
  double largest;  ///< coordinate
  std::string (*write)(const TriangleMesh& mesh);
};

constexpr std::array<Writer, 5> kWriters{{{".dae", kMaxDouble, write_collada},
                                          {".glb", kMaxFloat, write_glb},
                                          {".obj", kMaxDouble, write_obj},
                                          {".ply", kMaxDouble, write_ply},
                                          {".stl", kMaxFloat, write_stl}}};

/// Not for NaN either.
bool fits(const std::vector<Vector3>& positions, double largest) {
  return std::all_of(positions.begin(), positions.end(), [largest](const Vector3& p) {
    return std::abs(p.x) <= largest && std::abs(p.y) <= largest && std::abs(p.z) <= largest;
  });
}

}  // namespace

WrittenMesh write_mesh(const TriangleMesh& mesh, std::string_view path) {
  const std::string ending = extension(path);
  const auto* writer = std::find_if(kWriters.begin(), kWriters.end(),
                                    [&ending](const Writer& w) { return w.ending == ending; });
  if (writer == kWriters.end()) {
    return {{}, "meshes are written as .dae, .glb, .obj, .ply or .stl, not as '" + ending + "'"};
  }
  if (mesh.triangles.size() > kMaxTriangles) return {{}, "more than 50 million triangles"};
  if (!fits(mesh.positions, kMaxDouble)) return {{}, "a coordinate is not finite"};
  if (!fits(mesh.positions, writer->largest)) {
    return {{}, "a coordinate is over 3.4e38, the most that " + ending + " can hold"};
  }
  return {writer->write(mesh), {}};
}

}  // namespace rigor::mesh
