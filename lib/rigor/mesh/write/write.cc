// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/write/write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include <rigor/mesh/image/embedded_pictures.h>
#include <rigor/mesh/obj/materials.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/write/parts.h>
#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

constexpr double kMaxFloat = std::numeric_limits<float>::max();
constexpr std::uint64_t kMaxGlbBytes = std::numeric_limits<std::uint32_t>::max();
constexpr double kMaxDouble = std::numeric_limits<double>::max();

struct FormatWriter {
  std::string_view ending;
  double largest;  ///< coordinate
  WrittenMesh (*write)(const TriangleMesh& mesh, std::string_view path);
};

/// A file that only names pictures, with those beside it that the mesh holds.
template <class Write>
WrittenMesh with_pictures(const TriangleMesh& mesh, std::string_view path, const Write& write) {
  const bool holds =
      std::any_of(mesh.materials.begin(), mesh.materials.end(),
                  [](const Material& material) { return material.embedded_picture; });
  if (!holds) return write(mesh, path);
  const std::string_view name = file_name(path);
  NamedPictures named =
      named_pictures(mesh.materials, clean(std::string(name.substr(0, name.rfind('.')))));
  TriangleMesh naming = mesh;
  naming.materials = std::move(named.materials);
  WrittenMesh written = write(naming, path);
  std::move(named.files.begin(), named.files.end(), std::back_inserter(written.side_files));
  return written;
}

template <std::string (*kWrite)(const TriangleMesh& mesh)>
WrittenMesh one_file(const TriangleMesh& mesh, std::string_view /*path*/) {
  return {kWrite(mesh), {}};
}

WrittenMesh collada_files(const TriangleMesh& mesh, std::string_view path) {
  return with_pictures(mesh, path, one_file<write_collada>);
}

/// The .mtl, named as the file but for its ending, if there is anything to be said in it.
WrittenMesh obj_and_library(const TriangleMesh& mesh, std::string_view path) {
  std::string materials = write_obj_materials(mesh);
  if (materials.empty()) return {write_obj(mesh), {}};
  const std::string_view name = file_name(path);
  const std::string library = clean(std::string(name.substr(0, name.rfind('.'))) + ".mtl");
  return {write_obj(mesh, library), {}, {{library, std::move(materials)}}};
}

WrittenMesh obj_files(const TriangleMesh& mesh, std::string_view path) {
  return with_pictures(mesh, path, obj_and_library);
}

WrittenMesh glb_file(const TriangleMesh& mesh, std::string_view /*path*/) {
  std::string bytes = write_glb(mesh);
  if (bytes.size() > kMaxGlbBytes) return {{}, "over 4 GiB, the most that .glb can hold"};
  return {std::move(bytes), {}};
}

constexpr std::array<FormatWriter, 5> kWriters{{{".dae", kMaxDouble, collada_files},
                                                {".glb", kMaxFloat, glb_file},
                                                {".obj", kMaxDouble, obj_files},
                                                {".ply", kMaxDouble, one_file<write_ply>},
                                                {".stl", kMaxFloat, one_file<write_stl>}}};

/// Not for NaN either.
bool fits(const std::vector<Vector3>& positions, double largest) {
  return std::all_of(positions.begin(), positions.end(), [largest](const Vector3& p) {
    return std::abs(p.x) <= largest && std::abs(p.y) <= largest && std::abs(p.z) <= largest;
  });
}

}  // namespace

WrittenMesh write_mesh(const TriangleMesh& mesh, std::string_view path) {
  const std::string ending = extension(path);
  const auto* writer =
      std::find_if(kWriters.begin(), kWriters.end(),
                   [&ending](const FormatWriter& w) { return w.ending == ending; });
  if (writer == kWriters.end()) {
    return {{}, "meshes are written as .dae, .glb, .obj, .ply or .stl, not as '" + ending + "'"};
  }
  if (mesh.triangles.size() > kMaxTriangles) return {{}, "more than 50 million triangles"};
  if (!fits(mesh.positions, kMaxDouble)) return {{}, "a coordinate is not finite"};
  if (!fits(mesh.positions, writer->largest)) {
    return {{}, "a coordinate is over 3.4e38, the most that " + ending + " can hold"};
  }
  return writer->write(mesh, path);
}

}  // namespace rigor::mesh
